// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/projectile.hpp"
#include "ogive/perforation/parts.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/perforation/way.hpp"
#include "ogive/sim/energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ogive {

/// The projectile at one time, or main_part() of it if its parts touch. Velocities are positive along the initial line
/// of flight.
template <class T> struct FlightSample {
  T time{};     ///< s
  T velocity{}; ///< mean of the projectile's mass, m/s
  T nose{};     ///< depth of the foremost point below the plate's front face, m
  T shoulder{}; ///< depth of the nose's shoulder, m
  T tail{};     ///< depth of the rear end, m
  T advance{};  ///< velocity normal to the plate and into it, m/s: that of the line of flight unless it is oblique
};

/// State of a shot. One whose time ends in progress is undecided.
enum class FlightState { in_progress, perforated, stopped };

/// The projectile's flight so far and what has been concluded from it.
template <class T> struct Flight {
  T plate_thickness{};                          ///< m, from the front face to the rear one, of the last plate
  T diameter{};                                 ///< m, of the projectile
  T initial_velocity{};                         ///< m/s
  Vec3<T> direction{T(0), T(0), T(-1)};         ///< of the initial flight
  bool sharp = false;                           ///< the nose has a length
  T shorter{};                                  ///< m, between the rear ends of projectile and main_part() at first
  std::vector<FlightSample<T>> samples;         ///< in the order of time
  FlightState state = FlightState::in_progress; ///< by the samples
  std::optional<T> velocity_at_shoulder;        ///< sharp noses: when the shoulder left the rear face, m/s
  std::optional<T> velocity_at_tail;            ///< sharp noses: when the tail left the rear face, m/s
};

/// Calls `f(value)` for each value of a sample: the list that checkpoints write and read.
template <class T, class F> void for_each_field(FlightSample<T> &s, F &&f) {
  f(s.time), f(s.velocity), f(s.nose), f(s.shoulder), f(s.tail), f(s.advance);
}

/// Calls `f(value)` for each value of a flight that start_flight() does not give.
template <class T, class F> void for_each_field(Flight<T> &flight, F &&f) {
  f(flight.samples), f(flight.state), f(flight.velocity_at_shoulder), f(flight.velocity_at_tail);
}

/// Starts the record of a shot.
template <class T> Flight<T> start_flight(const PerforationCase<T> &c) {
  Flight<T> flight;
  flight.plate_thickness = target_depth(c);
  flight.diameter = c.projectile.diameter;
  flight.initial_velocity = c.initial_velocity;
  flight.direction = direction_of_flight(c);
  flight.sharp = is_sharp(c.projectile);
  return flight;
}

/// Starts the record of a shot with the model before its first step.
template <class M, class T> Flight<T> start_flight(const PerforationCase<T> &c, const M &model) {
  Flight<T> flight = start_flight(c);
  const Vec3<T> axis = direction_of_axis(c);
  const auto rear_of = [&](const std::vector<Index> &list) {
    T rear = std::numeric_limits<T>::max();
    for (const Index n : list) rear = std::min(rear, model.nodes.position[n].dot(axis));
    return rear;
  };
  const std::size_t main = main_part(model);
  const T rear = rear_of(nodes_of_part(model, main));
  for (std::size_t k = 0; k < model.bodies.projectile.size(); ++k)
    flight.shorter = std::max(flight.shorter, rear - rear_of(nodes_of_part(model, k)));
  return flight;
}

/// The projectile now. `shape` gives the distance of the shoulder from the tail.
template <class M, class T>
FlightSample<T> observe_flight(const M &model, const ProjectileShape<T> &shape, const Flight<T> &flight) {
  const std::vector<Index> followed = followed_nodes(model);
  const auto count = static_cast<Index>(followed.size());
  const auto &nodes = model.nodes;
  FlightSample<T> s;
  s.time = model.time;
  const Vec3<T> velocity = mean_velocity(nodes, followed);
  s.velocity = velocity.dot(flight.direction);
  s.advance = -velocity[2];
  const T lowest = parallel_min(count, T(1e30), [&](Index i) { return nodes.position[followed[i]][2]; });
  const T highest = parallel_max(count, T(-1e30), [&](Index i) { return nodes.position[followed[i]][2]; });
  s.nose = -lowest;
  s.tail = -highest;
  s.shoulder = s.tail - (shape.shank_length - flight.shorter) * flight.direction[2];
  return s;
}

/// Interval over which a velocity must stay constant to be called steady, s: the time in which a projectile of this
/// diameter (m) covers a twentieth of it, between 0.5 and 3 ms for each metre of diameter (10 and 60 us for 20 mm).
template <class T> T steady_interval(T velocity, T diameter) {
  return std::clamp(T(0.05) * diameter / std::max(velocity, T(1e-3)), T(0.5e-3) * diameter, T(3e-3) * diameter);
}

/// True if the velocity changed by less than `tolerance` (m/s) over the `interval` (s) that ends now, with three
/// samples in it.
template <class T> bool is_steady_for(const Flight<T> &flight, T interval, T tolerance) {
  const auto &samples = flight.samples;
  const FlightSample<T> &now = samples.back();
  const T since = now.time - interval;
  if (samples.front().time > since) return false;
  int count = 0;
  for (auto s = samples.rbegin(); s != samples.rend() && s->time >= since; ++s, ++count)
    if (std::abs(s->velocity - now.velocity) > tolerance) return false;
  return count > 2;
}

/// True if the velocity changed by less than `tolerance` (m/s) over steady_interval().
template <class T> bool is_steady(const Flight<T> &flight, T tolerance) {
  return is_steady_for(flight, steady_interval(flight.samples.back().velocity, flight.diameter), tolerance);
}

/// True if the velocity changed by less than a thousandth of `tolerance` (m/s) over a fifth of steady_interval():
/// nothing touches the projectile.
template <class T> bool is_untouched(const Flight<T> &flight, T tolerance) {
  const T interval = steady_interval(flight.samples.back().velocity, flight.diameter);
  return is_steady_for(flight, interval / T(5), tolerance / T(1000));
}

/// Share of the initial velocity below which a projectile counts as at rest.
inline constexpr double rest_share = 5e-3;
/// Share of the initial velocity by which a steady one may change.
inline constexpr double steady_share = 1e-3;

/// The way of a shot's projectile now.
template <class M, class T> Way<T> find_way(const M &model, const Flight<T> &flight) {
  return find_way(model, flight.direction, flight.diameter / T(2), T(rest_share) * flight.initial_velocity);
}

/// The state that the samples up to now show. `find_way()` gives the Way<T> and is called only where it decides.
///
/// Stopped: the projectile moves away from the plate by more than 0.2 % of the initial velocity; or its velocity is
/// steady below 0.5 % of that while a plate is in its way or around it. A velocity is steady if it changes by less than
/// 0.1 % of the initial one over steady_interval(). A projectile that moves on is steady too if it is untouched, see
/// is_untouched().
///
/// Perforated, sharp: the tail has left the last plate, and nothing is in the way or the velocity is steady and above
/// that of the plate. Perforated, blunt: the nose is behind the last plate and the velocity steady, by more than 0.5 %
/// of the initial one above that of the plate beside the projectile, and nothing is in the way: a plug that still hangs
/// on the plate may come back to the nose. A plug that is slower will be hit again: that may change a steady velocity
/// by no more than a steady one may change. If the tail has left too, what a chain of debris still connects to the
/// plate does not count as in the way.
template <class T, class FindWay> FlightState state_of(const Flight<T> &flight, FindWay &&find_way) {
  using enum FlightState;
  const FlightSample<T> &now = flight.samples.back();
  const T tolerance = T(steady_share) * flight.initial_velocity, rest = T(rest_share) * flight.initial_velocity;
  if (now.advance < T(-2) * tolerance) return stopped;
  const bool has_left = now.tail >= flight.plate_thickness, moves = now.velocity > rest;
  const bool settled = is_steady(flight, tolerance), steady = settled || (moves && is_untouched(flight, tolerance));
  if (!steady && !(flight.sharp && has_left)) return in_progress;
  if (flight.sharp && moves && !has_left) return in_progress;
  const Way<T> way = find_way();
  if (!moves && !has_left) return way.clear && !way.inside ? in_progress : stopped;
  const bool moves_on = now.velocity - way.plate_velocity > rest;
  const bool free = has_left ? (way.clear && now.velocity > T(0)) || (settled && moves_on)
                             : way.clear && moves_on && now.nose > flight.plate_thickness && way.later_loss < tolerance;
  return free ? perforated : in_progress;
}

/// Records a sample and concludes, see state_of(). A conclusion is final.
template <class T, class FindWay> void record(Flight<T> &flight, const FlightSample<T> &sample, FindWay &&find_way) {
  flight.samples.push_back(sample);
  if (flight.sharp) {
    if (!flight.velocity_at_shoulder && sample.shoulder >= flight.plate_thickness)
      flight.velocity_at_shoulder = sample.velocity;
    if (!flight.velocity_at_tail && sample.tail >= flight.plate_thickness) flight.velocity_at_tail = sample.velocity;
  }
  if (flight.state == FlightState::in_progress) flight.state = state_of(flight, find_way);
}

/// Residual velocity, m/s: 0 unless perforated.
template <class T> T residual_velocity(const Flight<T> &flight) {
  return flight.state == FlightState::perforated ? flight.samples.back().velocity : T(0);
}

} // namespace ogive
