// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/sim/energy.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/sim/step.hpp"

namespace sim_test {

using namespace ogive;

/// What a run has kept, in shares of what it began with.
struct Balance {
  double energy_error;   ///< largest change of the total energy, looked at every ten steps
  double momentum_error; ///< along z, what the supports have given taken into account
};

/// Steps a model until `time` (s).
template <class M> Balance follow(M &model, double time) {
  const double e = total(energy(model)), p = momentum(model)[2];
  Balance b{};
  while (model.time < time) {
    if (model.steps % 10 == 0) b.energy_error = std::max(b.energy_error, std::abs(total(energy(model)) / e - 1));
    step(model, stable_time_step(model));
  }
  const double given = model.symmetry.copies() * model.support_impulse[2];
  b.momentum_error = std::abs(momentum(model)[2] - p - given) / std::abs(p);
  return b;
}

} // namespace sim_test
