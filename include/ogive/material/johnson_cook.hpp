// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/johnson_cook_factors.hpp"

namespace ogive {

/// Modified Johnson-Cook law (Liu et al. 2012, Eq. 2): sigma = [A + B eps^a] rate^C [1 - T*^b], rate in 1/s, without a
/// reference rate.
template <class T> struct ModifiedJohnsonCook {
  T A{}; ///< Pa
  T B{}; ///< Pa
  T a{}; ///< hardening exponent
  T C{}; ///< rate exponent
  T b{}; ///< thermal exponent
};

/// Liu et al. 2012, Eq. 2. The rate must be positive (see Metal::rate_floor).
template <class T, class N>
FlowStress<N> flow_stress(const ModifiedJohnsonCook<T> &law, N plastic_strain, N rate, N temperature,
                          const ReferenceTemperatures<T> &reference) {
  using std::pow;
  const auto hardening = power_hardening(law.A, law.B, law.a, plastic_strain);
  const N rate_factor = pow(rate, law.C);
  const auto thermal = thermal_factor(temperature, reference, law.b);
  const N value = hardening.value * rate_factor * thermal.value;
  return {value, hardening.slope * rate_factor * thermal.value, value * law.C / rate,
          hardening.value * rate_factor * thermal.slope};
}

/// Classical Johnson-Cook law: sigma = [A + B eps^n] f(rate) [1 - T*^m].
template <class T> struct JohnsonCook {
  T A{};                                            ///< Pa
  T B{};                                            ///< Pa
  T n{};                                            ///< hardening exponent
  T C{};                                            ///< rate coefficient, negative if the flow stress falls with rate
  T m{};                                            ///< thermal exponent
  T reference_rate = T(1);                          ///< 1/s
  RateFactor rate_factor = RateFactor::logarithmic; ///< which of the two
};

/// Johnson & Cook 1983, with either rate factor.
template <class T, class N>
FlowStress<N> flow_stress(const JohnsonCook<T> &law, N plastic_strain, N rate, N temperature,
                          const ReferenceTemperatures<T> &reference) {
  const JohnsonCookFactors<T> factors{law.C, law.m, law.reference_rate, law.rate_factor};
  return multiplied(power_hardening(law.A, law.B, law.n, plastic_strain), factors, rate, temperature, reference);
}

} // namespace ogive
