#pragma once

#include "ogive/material/metal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ogive {

/// What the radial return found.
template <class T> struct PlasticStep {
  T increment{};   ///< of the equivalent plastic strain
  T flow_stress{}; ///< Pa, at the end of the step
};

/// Radial return (Wilkins 1964): finds the increment of plastic strain with
/// q_trial - 3 G increment = flow_stress(strain + increment, increment/dt, T + beta sigma increment/(rho cp)),
/// rate and temperature implicit, by Newton steps kept inside a bracket. `q_trial` in Pa, `dt` in s.
template <class T, class Law>
PlasticStep<T> radial_return(const Metal<T, Law> &metal, const MaterialPoint<T> &point, T q_trial, T dt) {
  const T three_g = T(3) * shear_modulus(metal.elasticity);
  const T heating = metal.specific_heat > T(0) ? metal.taylor_quinney / (metal.density * metal.specific_heat) : T(0);
  const T floor = metal.rate_floor;

  const auto still = flow_stress(metal.flow, point.plastic_strain, floor, point.temperature);
  if (q_trial <= still.value) return {T(0), still.value};

  T low = T(0), high = q_trial / three_g;
  T increment = std::clamp(point.plastic_strain_rate * dt, T(0), high);
  if (increment == T(0)) increment = (q_trial - still.value) / three_g * T(0.5);
  const T tolerance = T(1e-9) * q_trial + T(4) * std::numeric_limits<T>::epsilon() * q_trial;
  FlowStress<T> sigma = still;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const T rate = increment / dt;
    const T temperature = point.temperature + heating * sigma.value * increment;
    sigma = flow_stress(metal.flow, point.plastic_strain + increment, std::max(rate, floor), temperature);
    const T excess = q_trial - three_g * increment - sigma.value;
    if (std::abs(excess) <= tolerance) break;
    (excess > T(0) ? low : high) = increment;
    const T slope = three_g + sigma.by_plastic_strain + (rate > floor ? sigma.by_rate / dt : T(0)) +
                    sigma.by_temperature * heating * sigma.value;
    const T newton = increment + excess / slope;
    increment = newton > low && newton < high ? newton : T(0.5) * (low + high);
    if (high - low <= std::numeric_limits<T>::epsilon() * high) break;
  }
  return {increment, std::max(T(0), q_trial - three_g * increment)};
}

} // namespace ogive
