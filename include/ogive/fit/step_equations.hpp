// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/exponents.hpp"
#include "ogive/fit/test_series.hpp"

#include <optional>
#include <vector>

/// \file
/// The data that a point of a test gives to the steps of three_steps().

namespace ogive {

/// A law to be fitted. C and b may be known beforehand.
struct FlowChoice {
  FlowFrame frame;                ///< form of the law and what is given
  std::optional<double> C{}, b{}; ///< fitted unless given
};

/// The parameters as the steps see them: hardening is that of the quasi-static curve, A0 and B0.
struct StepParameters {
  std::vector<Hardening> hardening; ///< one for each of TestSeries::hardenings
  double C{}, b{};                  ///< rate and thermal exponent
};

/// Rate factor over that of the quasi-static curve.
inline double relative_rate_factor(const FlowFrame &f, double C, double rate, double quasi_static_rate) {
  return rate_factor(f, C, rate) / rate_factor(f, C, quasi_static_rate);
}

/// Quasi-static stress at room temperature, Pa.
inline double quasi_static_stress(const Hardening &h, double strain) {
  return power_hardening(h.A, h.B, h.a, strain).value;
}

/// The equation for C of a point of a faster curve.
inline RateEquation rate_equation(const FlowFrame &f, const Hardening &h, double b, const TestPoint &p,
                                  double quasi_static_rate) {
  const double softening = thermal_factor(p.temperature, f.temperatures(), b).value;
  return rate_equation(f, p.stress / (quasi_static_stress(h, p.strain) * softening), p.rate, quasi_static_rate);
}

/// Softening of a point of a hotter curve.
inline SofteningPoint softening_point(const FlowFrame &f, const Hardening &h, double C, const TestPoint &p,
                                      double quasi_static_rate) {
  const double cold = quasi_static_stress(h, p.strain) * relative_rate_factor(f, C, p.rate, quasi_static_rate);
  return {(p.temperature - f.room) / (f.melting - f.room), p.stress / cold};
}

/// The part of a quasi-static point's stress that is not hardening.
inline double quasi_static_factor(const FlowFrame &f, double C, double b, const TestPoint &p,
                                  double quasi_static_rate) {
  return relative_rate_factor(f, C, p.rate, quasi_static_rate) *
         thermal_factor(p.temperature, f.temperatures(), b).value;
}

/// True if C is taken from this point.
inline bool gives_rate(const TestSeries &s, const TestPoint &p) {
  return p.use == CurveUse::rate && holds(s.settings.rate_window, p.strain);
}
/// True if b is taken from this point.
inline bool gives_softening(const TestSeries &s, const TestPoint &p) {
  return p.use == CurveUse::thermal && holds(s.settings.thermal_window, p.strain);
}

} // namespace ogive
