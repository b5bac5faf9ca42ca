// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/flow_law.hpp"

#include <cmath>

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

/// The two published rate factors of the classical law.
enum class RateFactor {
  logarithmic, ///< 1 + C ln(rate/rate0), 1 below rate0 (Johnson & Cook 1983)
  power        ///< (1 + rate/rate0)^C (Camacho & Ortiz 1997; Boervik et al. 2001)
};

/// Classical Johnson-Cook law: sigma = [A + B eps^n] f(rate) [1 - T*^m].
template <class T> struct JohnsonCook {
  T A{};                                            ///< Pa
  T B{};                                            ///< Pa
  T n{};                                            ///< hardening exponent
  T C{};                                            ///< rate coefficient
  T m{};                                            ///< thermal exponent
  T reference_rate = T(1);                          ///< 1/s
  RateFactor rate_factor = RateFactor::logarithmic; ///< which of the two
};

/// Johnson & Cook 1983, with either rate factor.
template <class T, class N>
FlowStress<N> flow_stress(const JohnsonCook<T> &law, N plastic_strain, N rate, N temperature,
                          const ReferenceTemperatures<T> &reference) {
  using std::log, std::max, std::pow;
  const auto hardening = power_hardening(law.A, law.B, law.n, plastic_strain);
  const auto thermal = thermal_factor(temperature, reference, law.m);
  const N scaled = rate * (T(1) / law.reference_rate);
  N factor, slope;
  if (law.rate_factor == RateFactor::power) {
    factor = pow(T(1) + scaled, law.C);
    slope = law.C * factor / (law.reference_rate + rate);
  } else {
    factor = T(1) + law.C * log(max(scaled, N(1)));
    slope = select(scaled > N(1), law.C / rate, N(0));
  }
  return {hardening.value * factor * thermal.value, hardening.slope * factor * thermal.value,
          hardening.value * slope * thermal.value, hardening.value * factor * thermal.slope};
}

} // namespace ogive
