// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/johnson_cook.hpp"

#include <algorithm>
#include <array>
#include <string>

/// \file
/// The three laws of the Johnson-Cook family as one: five parameters and a form.

namespace ogive {

/// The rate factor between hardening and softening.
enum class FlowForm {
  modified,    ///< rate^C, rate in 1/s (Liu et al. 2012, Eq. 2)
  logarithmic, ///< 1 + C ln(rate/rate0), 1 below rate0 (Johnson & Cook 1983)
  power        ///< (1 + rate/rate0)^C (Camacho & Ortiz 1997)
};
/// All forms, in the order of the enumerators.
inline constexpr std::array<FlowForm, 3> all_flow_forms{FlowForm::modified, FlowForm::logarithmic, FlowForm::power};

/// A + B eps^a.
struct Hardening {
  double A{}; ///< Pa
  double B{}; ///< Pa
  double a{}; ///< exponent
};

/// Constants of a law besides its five parameters.
struct FlowFrame {
  FlowForm form = FlowForm::modified; ///< rate factor
  double reference_rate = 1;          ///< 1/s, of the classical law
  double room = 293;                  ///< Tr, K
  double melting{};                   ///< Tm, K
  /// The two temperatures.
  ReferenceTemperatures<double> temperatures() const { return {room, melting}; }
};

/// The modified law with these parameters.
inline ModifiedJohnsonCook<double> modified_law(const Hardening &h, double C, double b) {
  return {.A = h.A, .B = h.B, .a = h.a, .C = C, .b = b};
}

/// The classical law with these parameters; a and b are its n and m.
inline JohnsonCook<double> classical_law(const FlowFrame &f, const Hardening &h, double C, double b) {
  return {.A = h.A,
          .B = h.B,
          .n = h.a,
          .C = C,
          .m = b,
          .reference_rate = f.reference_rate,
          .rate_factor = f.form == FlowForm::power ? RateFactor::power : RateFactor::logarithmic};
}

/// Flow stress, Pa.
inline double flow_stress_value(const FlowFrame &f, const Hardening &h, double C, double b, double plastic_strain,
                                double rate, double temperature) {
  const auto of = [&](const auto &law) {
    return flow_stress(law, plastic_strain, rate, temperature, f.temperatures()).value;
  };
  return f.form == FlowForm::modified ? of(modified_law(h, C, b)) : of(classical_law(f, h, C, b));
}

/// The rate factor alone.
inline double rate_factor(const FlowFrame &f, double C, double rate) {
  return flow_stress_value(f, {1, 0, 1}, C, 1, 0, rate, f.room);
}

} // namespace ogive
