// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/flow_law.hpp"

#include <cmath>
#include <vector>

namespace ogive {

/// A point of a curve that a law gives.
struct LawPoint {
  double strain{};      ///< plastic
  double stress{};      ///< Pa
  double temperature{}; ///< K
};

/// Stress and temperature of a law with a metal's `reference` temperatures at `strains` (ascending, from 0 on) for a
/// test that keeps its heat: dT = heat_per_work sigma(eps, rate, T) d eps, by the classical Runge-Kutta rule with steps
/// of at most 1e-4, which leaves errors below 1e-4 K. `heat_per_work` (K/Pa) is beta/(rho cp), or 0 for an isothermal
/// test.
template <class Law>
requires HomologousFlowLaw<Law, double, double> std::vector<LawPoint>
adiabatic_curve(const Law &law, const ReferenceTemperatures<double> &reference, double rate, double start,
                double heat_per_work, const std::vector<double> &strains) {
  const auto stress = [&](double strain, double temperature) {
    return flow_stress(law, strain, rate, temperature, reference).value;
  };
  std::vector<LawPoint> points;
  double strain = 0, T = start;
  for (const double target : strains) {
    const int steps = static_cast<int>(std::ceil((target - strain) / 1e-4));
    const double h = steps > 0 ? (target - strain) / steps : 0;
    for (int k = 0; k < steps && heat_per_work > 0; ++k) {
      const double e = strain + k * h, q = heat_per_work * h;
      const double k1 = q * stress(e, T), k2 = q * stress(e + h / 2, T + k1 / 2),
                   k3 = q * stress(e + h / 2, T + k2 / 2), k4 = q * stress(e + h, T + k3);
      T += (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    }
    strain = target;
    points.push_back({strain, stress(strain, T), T});
  }
  return points;
}

} // namespace ogive
