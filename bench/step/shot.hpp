// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/sim/phases.hpp"
#include "ogive/sph/gradient.hpp"

#include <malloc.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Times the steps of a shot, and counts the work and the memory of its particles.

namespace bench {

using ogive::Phase;

/// Arithmetic of one particle of a cluster with one place of its list.
struct PairArithmetic {
  double flops;        ///< a fused multiply-add counts two; maximum, minimum, estimates of root and reciprocal one each
  double instructions; ///< arithmetic ones on vectors, multiplication and addition fused wherever they can be
};

// Counted for the cubic spline, a fixed smoothing length and machines with estimates of roots; what does not depend on
// the neighbour is left out. flops / instructions:
//
//   x_ij 3/3, r^2 5/3                                                                                  8/6
//   u^2 = max(r^2/h^2, 1e-12) 2/2, 1/u: estimate and Newton's step 7/5, u 1/1,
//   (dw/du)/u: far 3/2, near 3/2, difference of squares 3/2, times 1/u 1/1                            20/15
//
// gradient_sums: those and weight 2/2, V_j grad W 3/3, v_ij 3/3, nine sums 18/9, six moments 12/6, comparison with the
// support 1/1.
inline constexpr PairArithmetic gradient_arithmetic{67, 45};

// pair_forces: those and weight 1/1, v_ij . x_ij 8/6, mu: minimum, r^2 + 0.01 h^2, reciprocal 5/3, two products 9/7,
// q 5/4, weights 2/2, three sums of both terms 27/15 (the product of stress and x_ij, times w, less q V w x_ij), three
// sums of gradients 6/3, power 2/1.
inline constexpr PairArithmetic force_arithmetic{88, 60};

/// Sizes of the disc at one state and what its loops over pairs do in one step.
struct Work {
  std::int64_t particles = 0;
  std::int64_t images = 0; ///< mirror images of particles
  std::int64_t clusters = 0;
  std::int64_t listed = 0;   ///< entries of all lists
  std::int64_t within = 0;   ///< of them with a particle of the cluster within the support: those of the force loop
  std::int64_t pairs = 0;    ///< neighbours within the support, of all particles; a pair counts at both
  std::int64_t flowing = 0;  ///< particles that flowed plastically in the last step
  double gradient_bytes = 0; ///< touched by velocity_gradient()
  double force_bytes = 0;    ///< touched by add_internal_force()
  double stress_bytes = 0;   ///< touched by update_stress()
};

/// Directed pairs of different particles within the support, images included, with the nodes where they are.
template <class Body, class T> std::int64_t count_pairs(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  const ogive::Index width = ogive::lanes<T>, places = static_cast<ogive::Index>(n.order.size());
  const auto position = [&](ogive::Index place) -> ogive::Vec3<T> {
    const auto particle = place < places ? n.order[place] : n.images[place - places].parent;
    const auto &x = nodes.position[body.nodes.begin + particle];
    return place < places ? x : ogive::mirrored(x, n.images[place - places]);
  };
  const T support = n.support;
  return ogive::ordered_sum(ogive::clusters(n), std::int64_t(0), [&](ogive::Index c) {
    std::int64_t found = 0;
    for (ogive::Index k = c * width; k < std::min(body.points.size(), (c + 1) * width); ++k)
      for (const ogive::Index place : ogive::row(n, c))
        found += place != k && (position(k) - position(place)).squaredNorm() < support * support;
    return found;
  });
}

/// Counts the work at a state. Bytes: each number that a function reads or writes counts once for each of its loops, as
/// if what is read again lay in the cache; a number that is changed in place counts twice.
template <class Body, class T> Work count_work(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  Work w;
  w.particles = body.points.size();
  w.images = static_cast<std::int64_t>(n.images.size());
  w.clusters = ogive::clusters(n);
  w.listed = static_cast<std::int64_t>(n.list.size());
  for (const std::uint64_t word : n.within) w.within += std::popcount(word);
  w.pairs = count_pairs(body, nodes);
  for (const T rate : body.points.plastic_strain_rate) w.flowing += rate > T(0);

  constexpr double number = sizeof(T), index = sizeof(ogive::Index), image = sizeof(ogive::MirrorImage);
  const double particles = static_cast<double>(w.particles), places = particles + static_cast<double>(w.images);
  const double lists = index * static_cast<double>(w.listed);
  // Position, velocity, volume of all places; correction and velocity gradient are written.
  w.gradient_bytes = lists + 7 * number * places + (index + (9 + 9) * number) * particles;
  // First loop: density, mass, pressure, deviator, correction are read; flux and density written. Images: flux and
  // density written. Last loop: position, velocity, volume, density, flux of all places; force and viscous energy are
  // changed.
  w.force_bytes = (index + (3 + 6 + 9 + 9 + 1) * number) * particles +
                  (image + 10 * number) * static_cast<double>(w.images) + lists + (6 + 2 + 9) * number * places +
                  (index + (3 + 1) * 2 * number) * particles;
  // Velocity gradient, the last elastic limit with its strain and temperature are read; the 13 numbers of a point are
  // changed.
  w.stress_bytes = (9 + 3 + 2 * 13) * number * particles;
  return w;
}

/// Bytes of the arrays of a disc of particles, from their capacity.
struct Memory {
  double nodes = 0;  ///< the disc's share of the nodes
  double points = 0; ///< material points, mass, viscous energy
  double pair_data = 0;
  double neighbours = 0; ///< order, images, positions at building
  double lists = 0;
  double process = 0; ///< largest resident set after the model was made and stepped, less that before
};

template <class V> double bytes(const std::vector<V> &v) { return static_cast<double>(v.capacity() * sizeof(V)); }
template <class... Arrays> double bytes_of(const Arrays &...arrays) { return (bytes(arrays) + ...); }

template <class Body, class T> Memory memory_of(const Body &body, const ogive::Nodes<T> &nodes) {
  Memory m;
  m.nodes =
      bytes_of(nodes.position, nodes.velocity, nodes.force, nodes.mass, nodes.held) * body.nodes.size() / nodes.size();
  const auto &p = body.points;
  ogive::for_each_point_field(p, [&](const char *, const char *, const auto &field) { m.points += bytes(field); });
  m.points +=
      bytes_of(p.velocity_gradient, p.yield, p.yield_strain, p.yield_temperature, body.point_mass, body.viscous_energy);
  const auto &d = body.pair_data;
  m.pair_data = bytes_of(d.x, d.y, d.z, d.vx, d.vy, d.vz, d.volume, d.density, d.smoothing);
  for (const auto &component : d.correction) m.pair_data += bytes(component);
  for (const auto &component : d.flux) m.pair_data += bytes(component);
  const auto &n = body.neighbours;
  m.neighbours = bytes_of(n.order, n.images, n.built_at);
  m.lists = bytes_of(n.cluster_begin, n.list);
  return m;
}

/// Resident set of this process, bytes; memory that is free is given back first. The peak begins anew from it.
inline double restart_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  std::ifstream file("/proc/self/statm");
  double size = 0, resident = 0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The largest resident set since then, bytes; that of the whole process where the system does not allow a new begin.
inline double peak_bytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
  return 0;
}

/// What to measure.
struct Plan {
  std::vector<int> threads;
  int steps = 0;           ///< that are timed; 0: whole cycles between two rebuilds of the neighbour lists
  int repeats = 3;         ///< measurements, of which the median counts
  double seconds = 3;      ///< at least, of one measurement: the steps are repeated from the same state
  double load_time = 2e-6; ///< s of simulated time before the steps that are timed
  int load_steps = 30;     ///< at least
};

/// Times of a number of threads; medians of the repeats.
struct Timing {
  int threads = 1;
  int rounds = 1;                                  ///< from the same state, in one measurement
  int rebuilds = 0;                                ///< of the neighbour lists in a round
  std::array<double, ogive::phase_count> phases{}; ///< s per step
  double step = 0;                                 ///< s per step, all phases
  double rebuild = 0;                              ///< s, what a step with new neighbour lists takes longer
  double spread = 0;                               ///< largest less smallest step over the median
  std::uint64_t hash = 0;                          ///< of the state after the steps
};

/// Everything measured with a number of particles.
struct ShotResult {
  double spacing = 0;    ///< m
  double start_time = 0; ///< s, simulated, at the first step that is timed
  std::int64_t start_step = 0;
  int steps = 0; ///< that are timed
  std::int64_t hexes = 0, slaves = 0;
  Work work; ///< at the first step that is timed
  Memory memory;
  std::vector<Timing> timings;
};

/// True if all numbers of threads led to the same state.
inline bool equal_hashes(const ShotResult &result) {
  return std::all_of(result.timings.begin(), result.timings.end(),
                     [&](const Timing &t) { return t.hash != 0 && t.hash == result.timings.front().hash; });
}

/// A quarter of about so many particles: 12 mm Weldox 460 E, blunt projectile, 303.5 m/s.
inline auto make_shot(double particles) {
  ogive::PerforationCase<double> shot{.thickness = 12e-3, .sph_radius = 24e-3, .initial_velocity = 303.5};
  shot.spacing = std::cbrt(0.25 * std::numbers::pi * shot.sph_radius * shot.sph_radius * shot.thickness / particles);
  return ogive::make_perforation(shot, ogive::library::weldox_460e_mjc<double>(),
                                 ogive::library::arne_tool_steel<double>());
}

using Shot = decltype(make_shot(1.0));

/// Some steps and what they took.
struct Window {
  std::array<double, ogive::phase_count> seconds{};
  int steps = 0, rebuilds = 0;
  double rebuild_seconds = 0; ///< of the phase neighbours, in the steps with new lists
};

/// Steps, as run() does them, until `done(window)`.
template <class Done> Window advance_until(Shot &model, Done &&done) {
  // Differs before and after new lists were built: the positions then are kept.
  const auto lists_mark = [&] { return ogive::hash_values(0, ogive::disc(model).neighbours.built_at); };
  Window w;
  const auto before = model.times;
  auto mark = lists_mark();
  while (!done(w)) {
    const double neighbours = model.times[Phase::neighbours];
    ogive::Lap lap(model.times);
    const double dt = ogive::is_time_step_due(model, ogive::RunOptions<double>{}.time_step_every)
                          ? ogive::stable_time_step(model)
                          : model.last_step;
    lap(Phase::checks);
    ogive::step(model, dt);
    ++w.steps;
    if (const auto old = std::exchange(mark, lists_mark()); old == mark) continue;
    ++w.rebuilds;
    w.rebuild_seconds += model.times[Phase::neighbours] - neighbours;
  }
  for (std::size_t k = 0; k < ogive::phase_count; ++k) w.seconds[k] = model.times.seconds[k] - before.seconds[k];
  return w;
}

/// Number of steps to time: whole cycles, each ending with the step that builds lists, at least ten steps.
inline int whole_cycles(Shot model) {
  int seen = 0;
  return advance_until(model,
                       [&](const Window &w) {
                         const bool built = w.rebuilds > std::exchange(seen, w.rebuilds);
                         return (built && w.steps >= 10) || w.steps >= 100;
                       })
      .steps;
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

inline Timing measure(const Shot &loaded, int steps, int threads, const Plan &plan) {
  omp_set_num_threads(threads);
  Timing timing;
  timing.threads = threads;
  std::array<std::vector<double>, ogive::phase_count> phases;
  std::vector<double> step, rebuild;
  for (int repeat = 0; repeat < plan.repeats; ++repeat) {
    Window sum;
    double total = 0;
    int rounds = 0;
    for (; rounds == 0 || (total < plan.seconds && rounds < 1000); ++rounds) {
      Shot model = loaded;
      const Window w = advance_until(model, [&](const Window &now) { return now.steps == steps; });
      for (std::size_t k = 0; k < ogive::phase_count; ++k) sum.seconds[k] += w.seconds[k], total += w.seconds[k];
      sum.steps += w.steps, sum.rebuilds += w.rebuilds, sum.rebuild_seconds += w.rebuild_seconds;
      const auto hash = ogive::state_hash(model);
      // Each round must end alike: else the hash is zero, which equals no other.
      timing.hash = repeat == 0 && rounds == 0 ? hash : timing.hash == hash ? hash : 0;
    }
    timing.rounds = rounds;
    timing.rebuilds = sum.rebuilds / rounds;
    for (std::size_t k = 0; k < ogive::phase_count; ++k) phases[k].push_back(sum.seconds[k] / sum.steps);
    step.push_back(total / sum.steps);
    const double others = sum.seconds[static_cast<std::size_t>(Phase::neighbours)] - sum.rebuild_seconds;
    const bool both = sum.rebuilds > 0 && sum.rebuilds < sum.steps;
    rebuild.push_back(both ? sum.rebuild_seconds / sum.rebuilds - others / (sum.steps - sum.rebuilds) : 0);
  }
  for (std::size_t k = 0; k < ogive::phase_count; ++k) timing.phases[k] = median(phases[k]);
  timing.step = median(step);
  timing.rebuild = median(rebuild);
  const auto [least, most] = std::minmax_element(step.begin(), step.end());
  timing.spread = (*most - *least) / timing.step;
  return timing;
}

/// Shoots a quarter of about `particles` particles. `progress(text)` is called now and then.
inline ShotResult measure_shot(double particles, const Plan &plan,
                               const std::function<void(const std::string &)> &progress) {
  ShotResult result;
  omp_set_num_threads(*std::max_element(plan.threads.begin(), plan.threads.end()));
  progress("loading the plate");
  const double before = restart_peak();
  Shot loaded = make_shot(particles);
  // Until the plate is loaded and its lists have just been built, so that cycles of them begin here.
  advance_until(loaded, [&](const Window &w) { return w.steps >= plan.load_steps && loaded.time >= plan.load_time; });
  advance_until(loaded, [](const Window &w) { return w.rebuilds > 0 || w.steps >= 100; });
  const auto &disc = ogive::disc(loaded);
  result.memory = memory_of(disc, loaded.nodes);
  result.memory.process = peak_bytes() - before;
  result.spacing = disc.spacing;
  result.start_time = loaded.time;
  result.start_step = loaded.steps;
  result.work = count_work(disc, loaded.nodes);
  result.hexes = static_cast<std::int64_t>(ogive::rim(loaded).hexes.size() + ogive::projectile(loaded).hexes.size());
  for (const auto &contact : loaded.contacts) result.slaves += static_cast<std::int64_t>(contact.slaves.size());
  result.steps = plan.steps > 0 ? plan.steps : whole_cycles(loaded);
  for (const int threads : plan.threads) {
    progress(std::to_string(threads) + (threads == 1 ? " thread" : " threads"));
    result.timings.push_back(measure(loaded, result.steps, threads, plan));
  }
  return result;
}

} // namespace bench
