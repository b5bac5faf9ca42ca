// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/johnson_cook_form.hpp"

#include <cmath>

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

} // namespace ogive
