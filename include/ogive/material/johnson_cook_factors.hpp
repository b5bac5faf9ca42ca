// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/flow_law.hpp"

#include <cmath>

namespace ogive {

/// The two published rate factors of the classical law.
enum class RateFactor {
  logarithmic, ///< 1 + C ln(rate/rate0), 1 below rate0 (Johnson & Cook 1983), see smallest_rate_factor
  power        ///< (1 + rate/rate0)^C (Camacho & Ortiz 1997; Boervik et al. 2001)
};

/// Floor of the logarithmic rate factor: with a negative C it would reach zero at some rate, and the flow stress with
/// it.
inline constexpr double smallest_rate_factor = 0.1;

/// The factors by which the Johnson-Cook family multiplies its hardening: f(rate) [1 - T*^m].
template <class T> struct JohnsonCookFactors {
  T C{};                                            ///< rate coefficient, negative if the flow stress falls with rate
  T m{};                                            ///< thermal exponent
  T reference_rate = T(1);                          ///< 1/s
  RateFactor rate_factor = RateFactor::logarithmic; ///< which of the two
};

/// Hardening (Pa, with its slope by plastic strain) times the factors of rate (1/s) and temperature (K) of Johnson &
/// Cook 1983, with either rate factor.
template <class T, class N>
FlowStress<N> multiplied(const PowerHardening<N> &hardening, const JohnsonCookFactors<T> &factors, N rate,
                         N temperature, const ReferenceTemperatures<T> &reference) {
  using std::log, std::max, std::pow;
  const auto thermal = thermal_factor(temperature, reference, factors.m);
  const N scaled = rate * (T(1) / factors.reference_rate);
  N factor, slope;
  if (factors.rate_factor == RateFactor::power) {
    factor = pow(T(1) + scaled, factors.C);
    slope = factors.C * factor / (factors.reference_rate + rate);
  } else {
    const N free = T(1) + factors.C * log(max(scaled, N(1))), floor = T(smallest_rate_factor);
    factor = max(free, floor);
    slope = select((scaled > N(1)) & (free > floor), factors.C / rate, N(0));
  }
  return {hardening.value * factor * thermal.value, hardening.slope * factor * thermal.value,
          hardening.value * slope * thermal.value, hardening.value * factor * thermal.slope};
}

} // namespace ogive
