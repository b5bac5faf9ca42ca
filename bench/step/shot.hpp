// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/sim/phases.hpp"
#include "ogive/sph/gradient.hpp"

#include <malloc.h>
#include <nlohmann/json.hpp>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Times the steps of a shot, and counts the work and the memory of its particles; all as JSON in SI units.

namespace bench {

using Json = nlohmann::ordered_json;
using ogive::Phase;

// Arithmetic of one pair of a tile. Flops: a fused multiply-add counts two, maximum, minimum, estimates of root and
// reciprocal one each. Instructions: arithmetic ones on vectors, multiplication and addition fused wherever they can
// be. Counted for the cubic spline, a fixed smoothing length and machines with estimates of roots; what does not depend
// on the neighbour is left out. flops / instructions:
//
//   x_ij and its conversion 3/6, r^2 with a quantum more 6/3, u^2 1/1                                  10/10
//   1/u: estimate 1/1, u 1/1, (dw/du)/u: far 3/2, its square with sign, times 1/u 3/3, near 2/1, choice 1/2   11/10
//
// sum_gradient: those and weight 1/1, V_j grad W 3/3, v_ij 3/3, nine sums 18/9, six moments 12/6, comparison with the
// support 1/1.
inline constexpr double gradient_flops = 59, gradient_instructions = 43;

// pair_forces: those and v_ij . x_ij 8/6, mu: r^2 + 0.01 h^2, reciprocal, minimum, two products 5/5, q 6/5, stress less
// q 3/3, three sums 21/12, weight 1/1, three sums of gradients 6/3, power 3/2.
inline constexpr double force_flops = 74, force_instructions = 57;

/// Directed pairs of different particles within the support, images included, with the nodes where they are.
template <class Body, class T> std::int64_t count_pairs(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  const auto position = [&](ogive::Index i) -> ogive::Vec3<T> { return nodes.position[body.nodes.begin + i]; };
  const T support = n.support;
  return ogive::ordered_sum(ogive::clusters(n), std::int64_t(0), [&](ogive::Index c) {
    std::int64_t found = 0;
    ogive::for_each_listed_pair(n, c, [&](ogive::Index i, ogive::Index j, ogive::Reflection in) {
      const bool same = i == j && !in.x && !in.y;
      found += !same && (position(i) - ogive::reflected(position(j), in)).squaredNorm() < support * support;
    });
    return found;
  });
}

/// Sizes of the disc at a state and what its loops over pairs do in one step. Bytes: each number that a function reads
/// or writes counts once for each of its loops, as if what is read again lay in the cache; a number that is changed in
/// place counts twice.
template <class Body, class T> Json work_of(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  std::int64_t within = 0, flowing = 0;
  for (const std::uint64_t word : n.within) within += std::popcount(word);
  for (const T rate : body.points.plastic_strain_rate) flowing += rate > T(0);

  constexpr double number = sizeof(T), index = sizeof(ogive::Index), image = sizeof(ogive::ClusterImage),
                   single = sizeof(float);
  const double particles = static_cast<double>(body.points.size()), images = static_cast<double>(n.images.size());
  const double lists = index * static_cast<double>(n.list.size()), seen = static_cast<double>(ogive::places(n));
  // Position, velocity, volume of all places; correction and velocity gradient are written.
  const double gradient = lists + 7 * single * seen + (index + 9 * single + 9 * number) * particles;
  // First loop: density, mass, pressure, deviator, correction are read; flux and density written. Images: flux and
  // density written. Last loop: position, velocity, volume, density, flux of all places; force and viscous energy are
  // changed.
  const double force = (index + 9 * number + 19 * single) * particles + (image + 40 * single) * images + lists +
                       (8 + 9) * single * seen + (index + (3 + 1) * 2 * number) * particles;
  // Velocity gradient, the last elastic limit with its strain and temperature are read; the 13 numbers of a point are
  // changed.
  const double stress = (9 + 3 + 2 * 13) * number * particles;
  const auto loop = [](double flops, double instructions, double bytes) {
    return Json{{"flop_per_lane_pair", flops}, {"instructions_per_lane_pair", instructions}, {"bytes", bytes}};
  };
  // listed: entries of all lists; within: of them with a particle of the cluster within the support, those of the loop
  // over forces; flowing: particles that flowed plastically in the last step.
  return {{"particles", body.points.size()},
          {"images", n.images.size()},
          {"clusters", ogive::clusters(n)},
          {"listed", n.list.size()},
          {"within", within},
          {"pairs", count_pairs(body, nodes)},
          {"flowing", flowing},
          {"gradient", loop(gradient_flops, gradient_instructions, gradient)},
          {"force", loop(force_flops, force_instructions, force)},
          {"stress", {{"bytes", stress}}}};
}

template <class V> double bytes(const std::vector<V> &v) { return static_cast<double>(v.capacity() * sizeof(V)); }
template <class... Arrays> double bytes_of(const Arrays &...arrays) { return (bytes(arrays) + ...); }

/// Bytes of the arrays of a disc of particles, from their capacity.
template <class Body, class T> Json memory_of(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &p = body.points;
  const auto &d = body.pair_data;
  const auto &n = body.neighbours;
  double points = bytes_of(p.velocity_gradient, p.quasi_static_yield, p.yield_strain, p.yield_temperature,
                           body.point_mass, body.viscous_energy);
  ogive::for_each_point_field(p, [&](const char *, const char *, const auto &field) { points += bytes(field); });
  const double pair_data = bytes_of(d.motion, d.flux, d.pressure, d.smoothing);
  const double of_nodes = bytes_of(nodes.position, nodes.velocity, nodes.force, nodes.mass, nodes.held);
  return {{"nodes", of_nodes * static_cast<double>(body.nodes.size()) / static_cast<double>(nodes.size())},
          {"points", points},
          {"pair_data", pair_data},
          {"neighbours", bytes_of(n.order, n.images, n.built_at)},
          {"lists", bytes_of(n.cluster_begin, n.list, n.within)},
          {"bonds", bytes_of(body.bonds.begin, body.bonds.other, body.bonds.images, body.bonds.moment,
                             body.bonds.energy, body.bonds.ends)}};
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
  std::vector<double> sizes{3000, 25000, 100000, 1000000}; ///< particles of the computed quarter
  int steps = 0;      ///< that are timed; 0: whole cycles between two rebuilds of the neighbour lists
  int repeats = 3;    ///< measurements, of which the median counts
  bool quick = false; ///< short measurements of the machine
  std::vector<std::string> methods{"paper", "stabilised"};
  double seconds = 3; ///< at least, of one measurement: the steps are repeated from the same state
};

/// A quarter of about so many particles: 12 mm Weldox 460 E, blunt projectile, 303.5 m/s; with the damage that the
/// method needs.
inline auto make_shot(double particles, const std::string &name) {
  const ogive::Method method = name == "paper" ? ogive::Method::paper : ogive::Method::stabilised;
  ogive::PerforationCase<double> shot{.thickness = 12e-3, .sph_radius = 24e-3, .initial_velocity = 303.5};
  shot.spacing = std::cbrt(0.25 * std::numbers::pi * shot.sph_radius * shot.sph_radius * shot.thickness / particles);
  const auto metal = ogive::with_damage_of(method, ogive::library::weldox_460e_mjc<double>());
  return ogive::make_perforation(shot, metal, ogive::library::arne_tool_steel<double>(),
                                 ogive::choices_of<double>(method).numerics);
}

using Shot = decltype(make_shot(1.0, ""));

/// Some steps and what they took.
struct Window {
  std::array<double, ogive::phase_count> seconds{};
  int steps = 0, rebuilds = 0;
  double rebuild_seconds = 0; ///< of the phase neighbours, in the steps with new lists
};

/// Steps, as run() does them, until `done(window)`.
template <class Done> Window advance_until(Shot &model, Done &&done) {
  // Differs before and after new lists were built: the positions then are kept.
  const auto lists_mark = [&] { return ogive::hash_values(0, ogive::plate_particles(model).neighbours.built_at); };
  Window w;
  const auto before = model.times;
  auto mark = lists_mark();
  while (!done(w)) {
    const double neighbours = model.times[Phase::neighbours];
    ogive::Lap lap(model.times);
    const double dt = model.steps % ogive::RunOptions<double>{}.time_step_every == 0 ? ogive::stable_time_step(model)
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

/// Number of steps to time and of new lists in them: `steps`, or whole cycles, each ending with the step that builds
/// lists, at least ten steps.
inline std::pair<int, int> whole_cycles(Shot model, int steps) {
  int seen = 0;
  const Window w = advance_until(model, [&](const Window &now) {
    const bool built = now.rebuilds > std::exchange(seen, now.rebuilds);
    return steps > 0 ? now.steps == steps : (built && now.steps >= 10) || now.steps >= 100;
  });
  return {w.steps, w.rebuilds};
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Times with a number of threads, medians of the repeats: of a step with its phases, and what a step with new
/// neighbour lists takes longer. The hash is that of the state after the steps, all zeros if the repeats differ.
inline Json time_steps(const Shot &loaded, int steps, int threads, const Plan &plan) {
  omp_set_num_threads(threads);
  std::array<std::vector<double>, ogive::phase_count> phases;
  std::vector<double> step, rebuild;
  std::uint64_t first = 0;
  bool equal = true;
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
      if (repeat == 0 && rounds == 0) first = hash;
      equal = equal && hash == first;
    }
    for (std::size_t k = 0; k < ogive::phase_count; ++k) phases[k].push_back(sum.seconds[k] / sum.steps);
    step.push_back(total / sum.steps);
    const double others = sum.seconds[static_cast<std::size_t>(Phase::neighbours)] - sum.rebuild_seconds;
    const bool both = sum.rebuilds > 0 && sum.rebuilds < sum.steps;
    rebuild.push_back(both ? sum.rebuild_seconds / sum.rebuilds - others / (sum.steps - sum.rebuilds) : 0);
  }
  Json medians;
  for (std::size_t k = 0; k < ogive::phase_count; ++k)
    medians[std::string(ogive::name(static_cast<Phase>(k)))] = median(phases[k]);
  const auto [least, most] = std::minmax_element(step.begin(), step.end());
  char hash[32];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(equal ? first : 0));
  return {{"threads", threads},  {"step_s", median(step)},       {"spread", (*most - *least) / median(step)},
          {"phases_s", medians}, {"rebuild_s", median(rebuild)}, {"state_hash", hash}};
}

/// Shoots a quarter of about `particles` particles. `progress(text)` is called now and then.
inline Json measure_shot(double particles, const std::string &method, const Plan &plan,
                         const std::function<void(const std::string &)> &progress) {
  omp_set_num_threads(*std::max_element(plan.threads.begin(), plan.threads.end()));
  progress("loading the plate");
  const double before = restart_peak();
  Shot loaded = make_shot(particles, method);
  // Until the plate is loaded, at 2 us, and its lists have just been built, so that cycles of them begin here.
  advance_until(loaded, [&](const Window &w) { return w.steps >= 30 && loaded.time >= 2e-6; });
  advance_until(loaded, [](const Window &w) { return w.rebuilds > 0 || w.steps >= 100; });
  const auto &disc = ogive::plate_particles(loaded);
  Json result{{"method", method}};
  result.update(work_of(disc, loaded.nodes));
  result["memory_bytes"] = memory_of(disc, loaded.nodes);
  result["memory_bytes"]["process"] = peak_bytes() - before;
  result["spacing_m"] = disc.spacing;
  result["hexes"] = ogive::plate_hexes(loaded).hexes.size() + ogive::projectile(loaded).hexes.size();
  std::size_t slaves = 0;
  for (const auto &contact : loaded.contacts) slaves += contact.slaves.size();
  result["slaves"] = slaves;
  result["start_time_s"] = loaded.time;
  result["start_step"] = loaded.steps;
  const auto [steps, rebuilds] = whole_cycles(loaded, plan.steps);
  result["steps"] = steps;
  result["rebuilds"] = rebuilds;
  for (const int threads : plan.threads) {
    progress(std::to_string(threads) + (threads == 1 ? " thread" : " threads"));
    result["timings"].push_back(time_steps(loaded, steps, threads, plan));
  }
  return result;
}

} // namespace bench
