#pragma once

#include "ogive/fem/hex_time_step.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/guard.hpp"
#include "ogive/sim/step.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace ogive {

/// When to stop, look and check.
template <class T> struct RunOptions {
  T end_time{};                       ///< s
  T observe_every = T(0.5e-6);        ///< s between calls of the observer
  int time_step_every = 10;           ///< steps between two looks at the stable time step
  int check_every = 20;               ///< steps between two checks for NaN and inverted hexes
  T smallest_step_fraction = T(0.02); ///< of the first time step; below it the run stops
  T largest_energy_error = T(0.05);   ///< of the initial energy; beyond it the run stops
};

/// How a run ended.
enum class StopReason { end_time, observer, fault };

/// The end of a run.
struct RunResult {
  StopReason reason = StopReason::end_time;
  std::optional<Fault> fault; ///< set if the reason is a fault
};

/// Largest stable step of all bodies that deform, s.
template <class T, class... Bodies> T stable_time_step(const Model<T, Bodies...> &model) {
  T dt = std::numeric_limits<T>::max();
  for_each_body(model, [&](const auto &body) {
    for (const RigidPart &part : model.rigid_parts)
      if (part.nodes.begin <= body.nodes.begin && body.nodes.end <= part.nodes.end) return;
    dt = std::min(dt, stable_time_step(body, model.nodes));
  });
  for (const auto &contact : model.contacts)
    if (contact.reference_time_step > T(0)) dt = std::min(dt, T(1.5) * contact.reference_time_step);
  return dt;
}

/// Steps the model until `options.end_time` is reached. `observer(model, ledger)` (model const) is called at the start,
/// every `observe_every` and at the end, after a fault too; if it returns false the run stops. Prints nothing and
/// throws nothing of its own.
template <class T, class... Bodies, class Observer>
RunResult run(Model<T, Bodies...> &model, const RunOptions<T> &options, Observer &&observer) {
  RunResult result;
  const T first_step = stable_time_step(model), initial_energy = total(energy(model));
  T dt = first_step, next_look = model.time + options.observe_every;
  auto looked_at = model.steps;
  const auto stop_at = [&](Fault fault) {
    result = {StopReason::fault, std::move(fault)};
    observer(std::as_const(model), energy(model));
    return result;
  };
  if (const auto fault = find_not_finite(model)) return stop_at(*fault);
  if (!observer(std::as_const(model), energy(model))) return {StopReason::observer, std::nullopt};

  while (model.time < options.end_time * (T(1) - std::numeric_limits<T>::epsilon())) {
    Lap lap(model.times);
    if (model.steps % options.time_step_every == 0) {
      dt = stable_time_step(model);
      if (!(dt >= options.smallest_step_fraction * first_step)) {
        if (const auto fault = find_inverted(model)) return stop_at(*fault);
        if (const auto fault = find_not_finite(model)) return stop_at(*fault);
        std::ostringstream what;
        what << "the stable time step fell to " << dt << " s, from " << first_step << " s";
        return stop_at({what.str(), "model", -1, double(model.time) * 1e6});
      }
    }
    lap(Phase::checks);
    step(model, dt);
    lap.restart();
    if (model.steps % options.check_every == 0) {
      if (const auto fault = find_not_finite(model)) return stop_at(*fault);
      if (const auto fault = find_inverted(model)) return stop_at(*fault);
    }
    lap(Phase::checks);
    if (model.time < next_look) continue;
    next_look += options.observe_every;
    looked_at = model.steps;
    const Energy<T> ledger = energy(model);
    if (const T error = total(ledger) / initial_energy - T(1);
        initial_energy > T(0) && !(std::abs(error) <= options.largest_energy_error)) {
      if (const auto fault = find_not_finite(model)) return stop_at(*fault);
      std::ostringstream what;
      what << "the energy balance is off by " << double(error) * 100 << " %";
      return stop_at({what.str(), "model", -1, double(model.time) * 1e6});
    }
    lap(Phase::checks);
    const bool goes_on = observer(std::as_const(model), ledger);
    lap(Phase::observer);
    if (!goes_on) return {StopReason::observer, std::nullopt};
  }
  if (looked_at != model.steps) observer(std::as_const(model), energy(model));
  return result;
}

} // namespace ogive
