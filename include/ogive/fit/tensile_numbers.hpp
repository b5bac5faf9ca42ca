// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/text.hpp"
#include "ogive/material/power_law.hpp"
#include "ogive/material/voce.hpp"

#include <cmath>
#include <numbers>

/// \file
/// Hardening laws from the few numbers of a tensile test that a mill certificate has. The neck begins where the true
/// stress equals its slope by the true strain (Considere 1885); there the force is largest.

namespace ogive {

/// Numbers of a tensile test, engineering values.
struct TensileNumbers {
  double yield = 0;    ///< 0.2 % proof stress, Pa
  double strength = 0; ///< tensile strength: largest force over first area, Pa
  double young = 0;    ///< Young's modulus, Pa
};

namespace tensile_detail {

inline void check(const TensileNumbers &t) {
  require(std::isfinite(t.young) && t.young > 0, "Young's modulus (Pa)", t.young, "must be positive and finite");
  require(t.yield > 0 && t.yield < 0.02 * t.young, "yield stress (Pa)", t.yield,
          "must be positive and below 0.02 times Young's modulus");
  require(std::isfinite(t.strength) && t.strength > t.yield, "tensile strength (Pa)", t.strength,
          "must be above the yield stress");
}

/// The zero of a function that rises from `low` to `high`.
template <class F> double zero_of(F &&rising, double low, double high) {
  for (int k = 0; k < 100; ++k) {
    const double middle = (low + high) / 2;
    (rising(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

} // namespace tensile_detail

/// The power law Y (E eps/Y)^n with the yield stress and tensile strength of a test; without an effect of rate and
/// temperature. Its neck begins at the true strain n, so that strength/Y = (E n/Y)^n exp(-n). Throws SetupError, also
/// if the strength is too far above yield for n up to 0.6.
inline PowerLaw<double> power_law_of(const TensileNumbers &t) {
  tensile_detail::check(t);
  const auto excess = [&](double n) {
    return n * std::log(t.young * n / t.yield) - n - std::log(t.strength / t.yield);
  };
  constexpr double largest = 0.6;
  require(excess(largest) >= 0, "tensile strength (Pa)", t.strength,
          "must be at most " + shortest(std::floor(t.strength * std::exp(excess(largest)) / 1e6) * 1e6) +
              " Pa, which needs a hardening exponent of 0.6");
  // Up to e Y/E the law would have its largest force at yield.
  const double n = tensile_detail::zero_of(excess, std::numbers::e * t.yield / t.young, largest);
  return {t.yield, t.young, n, {.C = 0, .m = 1}};
}

/// Voce's law with one term, with the yield stress and tensile strength of a test whose largest force is at the
/// engineering strain `uniform_elongation`; without an effect of rate and temperature. Throws SetupError, also if no
/// curve that flattens has its largest force there.
inline Voce<double> voce_of(const TensileNumbers &t, double uniform_elongation) {
  tensile_detail::check(t);
  require(uniform_elongation > 0 && uniform_elongation < 1, "uniform elongation", uniform_elongation,
          "must lie between 0 and 1");
  const double stress = t.strength * (1 + uniform_elongation), strain = std::log(1 + uniform_elongation);
  const double plastic = strain - stress / t.young, slope = stress / (1 - stress / t.young);
  // With x = C1 plastic: Q1 (1 - e^-x) = stress - yield and Q1 C1 e^-x = slope, so that x/(e^x - 1) = share.
  const double share = slope * plastic / (stress - t.yield);
  require(plastic > 0 && share < 1, "uniform elongation", uniform_elongation,
          "does not fit yield stress and tensile strength: no curve that flattens has its largest force there");
  const double x = tensile_detail::zero_of([&](double y) { return share - y / std::expm1(y); }, 1e-9, 700);
  return {t.yield, (stress - t.yield) / -std::expm1(-x), x / plastic, 0, 0, {.C = 0, .m = 1}};
}

} // namespace ogive
