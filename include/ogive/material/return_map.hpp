// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/metal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ogive {

/// Result of the radial return.
template <class N> struct PlasticStep {
  N increment{};   ///< of the equivalent plastic strain
  N flow_stress{}; ///< Pa, at the end of the step
};

/// Radial return (Wilkins 1964): finds the increment of plastic strain with
/// q_trial - 3 G increment = flow_stress(strain + increment, increment/dt, T + beta sigma increment/(rho cp)),
/// rate and temperature implicit, by Newton steps kept inside a bracket. `q_trial` in Pa, `dt` in s; `concentration` of
/// the heat multiplies beta. `N` is T or a pack of T: then the iteration continues until all lanes have converged.
template <class T, class Law, class N>
PlasticStep<N> radial_return(const Metal<T, Law> &metal, const MaterialPoint<N> &point, N q_trial, T dt,
                             N concentration = N(1)) {
  using std::abs, std::max, std::min;
  const T three_g = T(3) * shear_modulus(metal.elasticity), inverse_dt = T(1) / dt;
  const N heating = concentration *
                    (metal.specific_heat > T(0) ? metal.taylor_quinney / (metal.density * metal.specific_heat) : T(0));
  const N floor = metal.rate_floor;

  const N sound = T(1) - metal.damage.softening * min(point.damage, N(1));
  const auto softened = [&](const N &strain, const N &rate, const N &temperature) {
    FlowStress<N> s = flow_stress(metal, strain, rate, temperature);
    s.value *= sound, s.by_plastic_strain *= sound, s.by_rate *= sound, s.by_temperature *= sound;
    return s;
  };
  const FlowStress<N> still = softened(point.plastic_strain, floor, point.temperature);
  const auto yields = q_trial > still.value;
  if (!any(yields)) return {N(0), still.value};

  N low = T(0), high = q_trial * (T(1) / three_g);
  N increment = min(point.plastic_strain_rate * dt, high);
  increment = select(increment > N(0), increment, (q_trial - still.value) * (T(0.5) / three_g));
  const N tolerance = (T(1e-8) + T(4) * std::numeric_limits<T>::epsilon()) * q_trial;
  FlowStress<N> sigma = still;
  auto open = yields;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const N rate = increment * inverse_dt;
    const N temperature = point.temperature + heating * sigma.value * increment;
    sigma = softened(N(point.plastic_strain + increment), N(max(rate, floor)), temperature);
    const N excess = q_trial - three_g * increment - sigma.value;
    open = open & (abs(excess) > tolerance);
    if (!any(open)) break;
    const auto below = excess > N(0);
    low = select(open & below, increment, low);
    high = select(open & !below, increment, high);
    const N slope = three_g + sigma.by_plastic_strain + select(rate > floor, sigma.by_rate * inverse_dt, N(0)) +
                    sigma.by_temperature * heating * sigma.value;
    const N newton = increment + excess / slope;
    const N next = select((newton > low) & (newton < high), newton, T(0.5) * (low + high));
    increment = select(open, next, increment);
    open = open & (high - low > std::numeric_limits<T>::epsilon() * high);
  }
  return {select(yields, increment, N(0)), select(yields, max(N(0), q_trial - three_g * increment), still.value)};
}

} // namespace ogive
