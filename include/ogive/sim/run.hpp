// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/extremes.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/erosion.hpp"
#include "ogive/sim/guard.hpp"
#include "ogive/sim/step.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace ogive {

/// End, intervals and limits of a run.
template <class T> struct RunOptions {
  T end_time{};                ///< s
  T observe_every = T(0.5e-6); ///< s between calls of the observer
  int time_step_every = 10; ///< steps between two checks of the stable time step, the stable one is that of all bodies
  int check_every = 20;     ///< steps between two checks of positions, velocities, hexes and contacts
  T eroded_step_fraction = T(0.1);    ///< of the first time step; hexes below it are removed from bodies that erode
  T smallest_step_fraction = T(0.02); ///< of the first time step; below it the run stops
  T largest_energy_error = T(0.05);   ///< of the initial energy; beyond it the run stops
  T domain_ratio = T(10);             ///< size of the domain, see find_astray(); the run stops when a node leaves it
};

/// State of the loop of run() between two steps: with the model, all that it needs to resume.
template <class T> struct RunState {
  T first_step{};                ///< s
  T time_step{};                 ///< s, of the step to come
  T next_observation{};          ///< s, time of the observer's next call
  T initial_energy{};            ///< J
  Start<T> start{};              ///< of the model
  std::int64_t observed_at = -1; ///< the step of the observer's last call; -1: the run has not begun
};

/// Calls `f(name, value)` for each number of a run's state.
template <class R, class F> void for_each_run_field(R &&run, F &&f) {
  f("first step", run.first_step);
  f("time step", run.time_step);
  f("next observation", run.next_observation);
  f("initial energy", run.initial_energy);
  f("middle at the start", run.start.middle);
  f("width at the start", run.start.width);
  f("speed at the start", run.start.speed);
  f("last observation", run.observed_at);
}

/// Reasons for the end of a run.
enum class StopReason { end_time, observer, pause, fault };

/// The end of a run.
struct RunResult {
  StopReason reason = StopReason::end_time; ///< reason for the end
  std::optional<Fault> fault;               ///< set if the reason is a fault
};

/// Calls `f(body)` for each body that deforms.
template <class T, class Bodies, class F> void for_each_deformable(const Model<T, Bodies> &model, F &&f) {
  for_each_body(model, [&](const auto &body) {
    for (const RigidPart<T> &part : model.rigid_parts)
      if (part.nodes.begin <= body.nodes.begin && body.nodes.end <= part.nodes.end) return;
    f(body);
  });
}

/// Largest stable step of all bodies that deform, s.
template <class T, class Bodies> T stable_time_step(const Model<T, Bodies> &model) {
  T dt = std::numeric_limits<T>::max();
  for_each_deformable(model, [&](const auto &body) { dt = least(dt, stable_time_step(body, model.nodes)); });
  for (const auto &contact : model.contacts)
    if (contact.state.reference_time_step > T(0)) dt = std::min(dt, T(1.5) * contact.state.reference_time_step);
  return dt;
}

/// The state of a run that begins with this model.
template <class T, class Bodies> RunState<T> begin_run(const Model<T, Bodies> &model, const RunOptions<T> &options) {
  const T dt = stable_time_step(model);
  return {dt, dt, model.time + options.observe_every, total(energy(model)), start_of(model), -1};
}

/// The first fault of nodes, hexes and contacts, if any.
template <class T, class Bodies>
std::optional<Fault> find_fault(const Model<T, Bodies> &model, const RunOptions<T> &options, const RunState<T> &state) {
  if (auto fault = find_not_finite(model)) return fault;
  if (auto fault = find_inverted(model)) return fault;
  if (auto fault = find_turned(model)) return fault;
  if (auto fault = find_lost(model)) return fault;
  return find_astray(model, state.start, options.domain_ratio);
}

/// A collapse of the time step to come, if it has: what it comes from, if that can be seen.
template <class T, class Bodies>
std::optional<Fault> find_small_step(const Model<T, Bodies> &model, const RunOptions<T> &options,
                                     const RunState<T> &state) {
  if (state.time_step >= options.smallest_step_fraction * state.first_step) return std::nullopt;
  if (auto fault = find_inverted(model)) return fault;
  if (auto fault = find_not_finite(model)) return fault;
  auto what = text_stream();
  what << "the stable time step fell to " << state.time_step << " s, from " << state.first_step << " s";
  Fault fault{FaultKind::small_step, what.str(), "model", -1, double(model.time) * 1e6};
  T shortest = std::numeric_limits<T>::max();
  for_each_deformable(model, [&](const auto &body) {
    const T dt = stable_time_step(body, model.nodes);
    if (!(dt < shortest || is_nan(dt))) return;
    shortest = dt;
    fault.body = body.name, fault.id = shortest_step_at(body, model.nodes);
  });
  return fault;
}

/// An energy error beyond the limit, if there is one, or the numbers that are not finite or the inverted hex behind it.
template <class T, class Bodies>
std::optional<Fault> find_energy_error(const Model<T, Bodies> &model, const RunOptions<T> &options,
                                       const RunState<T> &state, const Energy<T> &ledger) {
  const T error = total(ledger) / state.initial_energy - T(1);
  if (!(state.initial_energy > T(0)) || std::abs(error) <= options.largest_energy_error) return std::nullopt;
  if (auto fault = find_not_finite(model)) return fault;
  if (auto fault = find_inverted(model)) return fault;
  auto what = text_stream();
  what << "the error of the energy balance is " << double(error) * 100 << " %: " << total(ledger) << " J, from "
       << state.initial_energy << " J";
  return Fault{FaultKind::energy, what.str(), "model", -1, double(model.time) * 1e6};
}

/// Steps the model until `options.end_time` is reached. `observer(model, ledger)` (model const) is called at the start,
/// every `observe_every` and at the end, after a fault too; if it returns false the run stops. `pause(model, state)`
/// (both const) is asked before every step and before the end; if it returns true the run pauses. A later call with the
/// same `state` resumes there with the same results as without a pause; a new state begins a run. Prints nothing and
/// throws nothing of its own. Exceptions of a flow law, a kernel, `observer` or `pause` reach the caller, with any
/// number of threads: the state of the model is then unspecified, and files that were written before are whole.
template <class T, class Bodies, class Observer, class Pause>
RunResult run(Model<T, Bodies> &model, const RunOptions<T> &options, RunState<T> &state, Observer &&observer,
              Pause &&pause) {
  const auto observe = [&](const Energy<T> &ledger) {
    state.observed_at = model.steps;
    return observer(std::as_const(model), ledger);
  };
  const auto stop_at = [&](Fault fault) {
    observe(energy(model));
    return RunResult{StopReason::fault, std::move(fault)};
  };
  if (state.observed_at < 0) {
    state = begin_run(model, options);
    if (auto fault = find_not_finite(model)) return stop_at(*fault);
    if (!observe(energy(model))) return {StopReason::observer, std::nullopt};
  }
  for (;;) {
    Lap lap(model.times);
    if (pause(std::as_const(model), std::as_const(state))) return {StopReason::pause, std::nullopt};
    lap(Phase::observer);
    if (!(model.time < options.end_time * (T(1) - std::numeric_limits<T>::epsilon()))) break;
    if (model.steps % options.time_step_every == 0) {
      state.time_step = stable_time_step(model);
      if (auto fault = find_small_step(model, options, state)) return stop_at(*fault);
    }
    lap(Phase::checks);
    step(model, state.time_step);
    lap.restart();
    // Hexes of several points are checked in each step, see below.
    erode(model, options.eroded_step_fraction * state.first_step, model.steps % options.time_step_every == 0 ? 1 : 2);
    // One of several points can lose its volume and have it back, with any stress, before the next check of all.
    const bool all = model.steps % options.check_every == 0;
    if (auto fault = all ? find_fault(model, options, state) : find_inverted(model, 2)) return stop_at(*fault);
    lap(Phase::checks);
    if (model.time < state.next_observation) continue;
    state.next_observation += options.observe_every;
    const Energy<T> ledger = energy(model);
    if (auto fault = find_energy_error(model, options, state, ledger)) return stop_at(*fault);
    lap(Phase::checks);
    const bool continues = observe(ledger);
    lap(Phase::observer);
    if (!continues) return {StopReason::observer, std::nullopt};
  }
  // However short the run was.
  const Energy<T> ledger = energy(model);
  auto fault = find_fault(model, options, state);
  if (!fault) fault = find_energy_error(model, options, state, ledger);
  if (fault) return stop_at(*fault);
  if (state.observed_at != model.steps) observe(ledger);
  return {};
}

/// Runs a model without pauses, as run() with them.
template <class T, class Bodies, class Observer>
RunResult run(Model<T, Bodies> &model, const RunOptions<T> &options, Observer &&observer) {
  RunState<T> state;
  return run(model, options, state, observer, [](const auto &, const auto &) { return false; });
}

} // namespace ogive
