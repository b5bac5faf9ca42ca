// SPDX-License-Identifier: BSD-3-Clause
#include "shot.hpp"

#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace bench {

namespace {

using ogive::Phase;

const ogive::PerforationCase<double> the_case{.thickness = 12e-3, .sph_radius = 24e-3, .initial_velocity = 303.5};

auto make_shot(double spacing) {
  auto shot = the_case;
  shot.spacing = spacing;
  return ogive::make_perforation(shot, ogive::library::weldox_460e_mjc<double>(),
                                 ogive::library::arne_tool_steel<double>());
}

using Shot = decltype(make_shot(1.0));

/// Particle distance (m) that gives about so many particles.
double spacing_for(double particles) {
  return std::cbrt(0.25 * std::numbers::pi * the_case.sph_radius * the_case.sph_radius * the_case.thickness /
                   particles);
}

/// One step, as run() does it.
void advance(Shot &model) {
  ogive::Lap lap(model.times);
  const double dt = ogive::is_time_step_due(model, ogive::RunOptions<double>{}.time_step_every)
                        ? ogive::stable_time_step(model)
                        : model.last_step;
  lap(Phase::checks);
  ogive::step(model, dt);
}

/// Differs before and after new lists were built: the positions then are kept.
std::uint64_t lists_mark(const Shot &model) {
  return ogive::hash_values(0, ogive::plate_particles(model).neighbours.built_at);
}

/// Some steps and what they took.
struct Window {
  std::array<double, ogive::phase_count> seconds{};
  int steps = 0, rebuilds = 0;
  double rebuild_seconds = 0; ///< of the phase neighbours, in the steps with new lists
};

/// Steps until `done(window)`.
template <class Done> Window advance_until(Shot &model, Done &&done) {
  Window w;
  const auto before = model.times;
  auto mark = lists_mark(model);
  while (!done(w)) {
    const double neighbours = model.times[Phase::neighbours];
    advance(model);
    ++w.steps;
    const auto now = lists_mark(model);
    if (now == mark) continue;
    mark = now;
    ++w.rebuilds;
    w.rebuild_seconds += model.times[Phase::neighbours] - neighbours;
  }
  for (std::size_t k = 0; k < ogive::phase_count; ++k) w.seconds[k] = model.times.seconds[k] - before.seconds[k];
  return w;
}

double total(const Window &w) { return std::accumulate(w.seconds.begin(), w.seconds.end(), 0.0); }

void add(Window &sum, const Window &w) {
  for (std::size_t k = 0; k < ogive::phase_count; ++k) sum.seconds[k] += w.seconds[k];
  sum.steps += w.steps, sum.rebuilds += w.rebuilds, sum.rebuild_seconds += w.rebuild_seconds;
}

/// Steps until the plate is loaded and its lists have just been built, so that cycles of them begin here.
void load(Shot &model, const Plan &plan) {
  advance_until(model, [&](const Window &w) { return w.steps >= plan.load_steps && model.time >= plan.load_time; });
  advance_until(model, [](const Window &w) { return w.rebuilds > 0 || w.steps >= 100; });
}

/// Number of steps to time: whole cycles, each ending with the step that builds lists, at least ten steps.
int whole_cycles(Shot model) {
  int seen = 0;
  return advance_until(model,
                       [&](const Window &w) {
                         const bool built = w.rebuilds > std::exchange(seen, w.rebuilds);
                         return (built && w.steps >= 10) || w.steps >= 100;
                       })
      .steps;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Extra time of a step with new lists, s.
double rebuild_cost(const Window &w) {
  if (w.rebuilds == 0 || w.rebuilds == w.steps) return 0;
  const double others = w.seconds[static_cast<std::size_t>(Phase::neighbours)] - w.rebuild_seconds;
  return w.rebuild_seconds / w.rebuilds - others / (w.steps - w.rebuilds);
}

Timing measure(const Shot &loaded, int steps, int threads, const Plan &plan) {
  omp_set_num_threads(threads);
  Timing timing;
  timing.threads = threads;
  std::array<std::vector<double>, ogive::phase_count> phases;
  std::vector<double> step, rebuild;
  for (int repeat = 0; repeat < plan.repeats; ++repeat) {
    Window sum;
    int rounds = 0;
    while (rounds == 0 || (total(sum) < plan.seconds && rounds < 1000)) {
      Shot model = loaded;
      add(sum, advance_until(model, [&](const Window &w) { return w.steps == steps; }));
      ++rounds;
      const auto hash = ogive::state_hash(model);
      // Each round must end alike: else the hash is zero, which equals no other.
      timing.hash = repeat == 0 && rounds == 1 ? hash : timing.hash == hash ? hash : 0;
    }
    timing.rounds = rounds;
    timing.rebuilds = sum.rebuilds / rounds;
    for (std::size_t k = 0; k < ogive::phase_count; ++k) phases[k].push_back(sum.seconds[k] / sum.steps);
    step.push_back(total(sum) / sum.steps);
    rebuild.push_back(rebuild_cost(sum));
  }
  for (std::size_t k = 0; k < ogive::phase_count; ++k) timing.phases[k] = median(phases[k]);
  timing.step = median(step);
  timing.rebuild = median(rebuild);
  const auto [least, most] = std::minmax_element(step.begin(), step.end());
  timing.spread = (*most - *least) / timing.step;
  return timing;
}

} // namespace

bool equal_hashes(const ShotResult &result) {
  return std::all_of(result.timings.begin(), result.timings.end(),
                     [&](const Timing &t) { return t.hash != 0 && t.hash == result.timings.front().hash; });
}

ShotResult measure_shot(double particles, const Plan &plan, const std::function<void(const std::string &)> &progress) {
  ShotResult result;
  omp_set_num_threads(*std::max_element(plan.threads.begin(), plan.threads.end()));
  progress("making the model");
  const double before = resident_bytes();
  restart_peak();
  Shot loaded = make_shot(spacing_for(particles));
  progress("loading the plate");
  load(loaded, plan);
  const auto &disc = ogive::plate_particles(loaded);
  result.memory = memory_of(disc, loaded.nodes);
  result.memory.process = peak_bytes() - before;
  result.spacing = disc.spacing;
  result.start_time = loaded.time;
  result.start_step = loaded.steps;
  result.work = count_work(disc, loaded.nodes);
  result.hexes =
      static_cast<std::int64_t>(ogive::plate_hexes(loaded).hexes.size() + ogive::projectile(loaded).hexes.size());
  for (const auto &contact : loaded.contacts) result.slaves += static_cast<std::int64_t>(contact.slaves.size());
  result.steps = plan.steps > 0 ? plan.steps : whole_cycles(loaded);
  for (const int threads : plan.threads) {
    progress(std::to_string(threads) + (threads == 1 ? " thread" : " threads"));
    result.timings.push_back(measure(loaded, result.steps, threads, plan));
  }
  return result;
}

} // namespace bench
