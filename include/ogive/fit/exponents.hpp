// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/johnson_cook_form.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ogive {

/// One point's equation for C, linear in it: y = C z, to be weighted with x.
struct RateEquation {
  double x, y, z; ///< of y = C z with the weight x
};

/// The equation of a point whose stress is `ratio` times that of the quasi-static curve, ratio = R(rate)/R(rate0).
///
/// In the laws with a power the logarithm is taken: ln ratio = C ln(rate/rate0), or with rate + reference in both
/// places. In the logarithmic one ratio (1 + C L0) = 1 + C L, with L = ln(rate/reference), not below 0. The weight x
/// holds no measured number, so that scatter does not shift C.
inline RateEquation rate_equation(const FlowFrame &f, double ratio, double rate, double quasi_static_rate) {
  if (f.form == FlowForm::logarithmic) {
    const double L = std::log(std::max(rate / f.reference_rate, 1.0));
    const double L0 = std::log(std::max(quasi_static_rate / f.reference_rate, 1.0));
    return {L - L0, ratio - 1, L - ratio * L0};
  }
  const double shift = f.form == FlowForm::power ? f.reference_rate : 0;
  const double span = std::log((shift + rate) / (shift + quasi_static_rate));
  return {span, std::log(ratio), span};
}

/// A softening to be fitted by 1 - T*^b.
struct SofteningPoint {
  double scaled{}; ///< T* = (T - Tr)/(Tm - Tr), between 0 and 1
  double factor{}; ///< stress over that of the law at room temperature
};

/// Half the slope of the square (factor - 1 + T*^b)^2 by b.
inline double softening_slope(const SofteningPoint &p, double b) {
  if (!(p.scaled > 0)) return 0;
  const double power = std::pow(p.scaled, b);
  return (p.factor - 1 + power) * power * std::log(p.scaled);
}

/// Least squares of 1 - T*^b between 0.02 and 20; nothing if the best b lies at an end of that range.
inline std::optional<double> fit_thermal_exponent(const std::vector<SofteningPoint> &points) {
  constexpr int steps = 60;
  const auto exponent = [](int k) { return 0.02 * std::pow(1000.0, double(k) / steps); };
  const auto squares = [&](double b) {
    double sum = 0;
    for (const auto &p : points) {
      const double error = p.factor - 1 + std::pow(p.scaled, b);
      sum += error * error;
    }
    return sum;
  };
  int best = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= steps; ++k)
    if (const double sum = squares(exponent(k)); sum < smallest) smallest = sum, best = k;
  if (best == 0 || best == steps) return std::nullopt;

  const auto slope = [&](double b) {
    double sum = 0;
    for (const auto &p : points) sum += softening_slope(p, b);
    return sum;
  };
  // The sum falls before its smallest value and rises after it.
  double low = exponent(best - 1), high = exponent(best + 1);
  while (high - low > 4e-16 * high) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (slope(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace ogive
