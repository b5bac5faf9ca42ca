// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/projectile.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/sim/energy.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ogive {

/// The projectile at one time. Velocities are positive along the initial line of flight.
template <class T> struct FlightSample {
  T time{};     ///< s
  T velocity{}; ///< mean of the projectile's mass, m/s
  T nose{};     ///< depth of the foremost point below the plate's front face, m
  T shoulder{}; ///< depth of the nose's shoulder, m
  T tail{};     ///< depth of the rear end, m
};

/// State of a shot.
enum class FlightState { in_progress, perforated, stopped };

/// The projectile's flight so far and what has been concluded from it.
template <class T> struct Flight {
  T plate_thickness{};                          ///< m, from the front face to the rear one, of the last plate
  T initial_velocity{};                         ///< m/s
  Vec3<T> direction{T(0), T(0), T(-1)};         ///< of the initial flight
  bool sharp = false;                           ///< the nose has a length
  std::vector<FlightSample<T>> samples;         ///< in the order of time
  FlightState state = FlightState::in_progress; ///< what they say
  std::optional<T> velocity_at_shoulder;        ///< sharp noses: when the shoulder left the rear face, m/s
  std::optional<T> velocity_at_tail;            ///< sharp noses: when the tail left the rear face, m/s
};

/// Calls `f(value)` for each value of a sample: the list that checkpoints write and read.
template <class T, class F> void for_each_field(FlightSample<T> &s, F &&f) {
  f(s.time), f(s.velocity), f(s.nose), f(s.shoulder), f(s.tail);
}

/// Calls `f(value)` for each value of a flight that start_flight() does not give.
template <class T, class F> void for_each_field(Flight<T> &flight, F &&f) {
  f(flight.samples), f(flight.state), f(flight.velocity_at_shoulder), f(flight.velocity_at_tail);
}

/// Starts the record of a shot.
template <class T> Flight<T> start_flight(const PerforationCase<T> &c) {
  Flight<T> flight;
  flight.plate_thickness = target_depth(c);
  flight.initial_velocity = c.initial_velocity;
  flight.direction = direction_of_flight(c);
  flight.sharp = c.projectile.nose != Nose::blunt;
  return flight;
}

/// The projectile now. `shape` gives the distance of the shoulder from the tail.
template <class M, class T>
FlightSample<T> observe_flight(const M &model, const ProjectileShape<T> &shape, const Flight<T> &flight) {
  const auto &body = projectile(model);
  const auto &nodes = model.nodes;
  FlightSample<T> s;
  s.time = model.time;
  s.velocity = mean_velocity(nodes, body.nodes).dot(flight.direction);
  const T lowest =
      parallel_min(body.nodes.size(), T(1e30), [&](Index i) { return nodes.position[body.nodes.begin + i][2]; });
  const T highest =
      parallel_max(body.nodes.size(), T(-1e30), [&](Index i) { return nodes.position[body.nodes.begin + i][2]; });
  s.nose = -lowest;
  s.tail = -highest;
  s.shoulder = s.tail - shape.shank_length * flight.direction[2];
  return s;
}

/// Interval over which a velocity must stay constant to be called steady, s: the time in which the projectile moves on
/// by a millimetre, between 10 and 60 us.
template <class T> T steady_interval(T velocity) {
  return std::clamp(T(1e-3) / std::max(velocity, T(1e-3)), T(10e-6), T(60e-6));
}

/// True if the velocity changed by less than `tolerance` (m/s) over the interval that ends now.
template <class T> bool is_steady(const std::vector<FlightSample<T>> &samples, T tolerance) {
  const FlightSample<T> &now = samples.back();
  const T since = now.time - steady_interval(now.velocity);
  if (samples.front().time > since) return false;
  for (auto s = samples.rbegin(); s != samples.rend() && s->time >= since; ++s)
    if (std::abs(s->velocity - now.velocity) > tolerance) return false;
  return true;
}

/// Records a sample and concludes. Blunt: perforated once the velocity is steady (0.1 % of the initial velocity) and
/// `is_plug_loose()` is true; before that a plug that still hangs on the plate may come back to the nose. Sharp:
/// perforated once the tail has left the rear face. Stopped once the projectile moves backwards by more than 0.2 % of
/// the initial velocity. What has been concluded stays.
template <class T, class IsPlugLoose>
void record(Flight<T> &flight, const FlightSample<T> &sample, IsPlugLoose &&is_plug_loose) {
  flight.samples.push_back(sample);
  const T tolerance = T(1e-3) * flight.initial_velocity;
  if (flight.sharp) {
    if (!flight.velocity_at_shoulder && sample.shoulder >= flight.plate_thickness)
      flight.velocity_at_shoulder = sample.velocity;
    if (!flight.velocity_at_tail && sample.tail >= flight.plate_thickness) flight.velocity_at_tail = sample.velocity;
  }
  if (flight.state != FlightState::in_progress) return;
  if (sample.velocity < T(-2) * tolerance)
    flight.state = FlightState::stopped;
  else if (flight.sharp ? flight.velocity_at_tail.has_value()
                        : sample.velocity > T(5) * tolerance && is_steady(flight.samples, tolerance) && is_plug_loose())
    flight.state = FlightState::perforated;
}

/// Residual velocity, m/s: 0 unless perforated.
template <class T> T residual_velocity(const Flight<T> &flight) {
  return flight.state == FlightState::perforated ? flight.samples.back().velocity : T(0);
}

} // namespace ogive
