// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/flow_law.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ogive {

/// A tensile test: true stress against plastic strain at one strain rate and one initial temperature.
struct StressCurve {
  std::string plate;          ///< tests of one plate share a hardening curve; empty if there is only one
  std::string specimen;       ///< empty if specimens are not distinguished
  double rate{};              ///< 1/s
  double temperature{};       ///< K, initial
  std::vector<double> strain; ///< true plastic strain, ascending
  std::vector<double> stress; ///< true stress, Pa
};

/// Temperature (K) at each point of a curve that keeps its heat: T = T0 + heat_per_work * integral of sigma d eps by
/// the trapezoidal rule on the measured curve, from eps = 0 with the first point's stress. `heat_per_work` is
/// beta/(rho cp) in K/Pa.
inline std::vector<double> adiabatic_temperature(const StressCurve &curve, double start, double heat_per_work) {
  std::vector<double> temperature;
  temperature.reserve(curve.strain.size());
  double work = 0, strain = 0, stress = curve.stress.empty() ? 0 : curve.stress.front();
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    work += 0.5 * (stress + curve.stress[i]) * (curve.strain[i] - strain);
    strain = curve.strain[i];
    stress = curve.stress[i];
    temperature.push_back(start + heat_per_work * work);
  }
  return temperature;
}

/// The true curve that follows from engineering stress and strain.
struct TrueCurve {
  std::vector<double> strain;    ///< true plastic strain
  std::vector<double> stress;    ///< true stress, Pa
  std::vector<std::size_t> from; ///< index of each point in the engineering curve
  std::size_t elastic = 0;       ///< points left out because their plastic strain is below `least_plastic_strain`
  std::size_t necked = 0;        ///< points left out behind the largest engineering stress
  double necking_strain = 0;     ///< true plastic strain there
};

/// Plastic strain at which yielding ends and hardening begins: 0.2 %.
inline constexpr double least_plastic_strain = 0.002;

/// True stress s (1 + e) and plastic strain ln(1 + e) - stress/young up to necking, where the engineering stress s is
/// largest (Considère 1885), without the elastic part. Strains e must be larger than -1 and ascend; stresses in Pa.
inline TrueCurve true_curve(const std::vector<double> &strain, const std::vector<double> &stress, double young) {
  TrueCurve result;
  std::size_t top = 0;
  for (std::size_t i = 0; i < stress.size(); ++i)
    if (stress[i] > stress[top]) top = i;
  result.necked = stress.empty() ? 0 : stress.size() - 1 - top;
  for (std::size_t i = 0; i < stress.size() && i <= top; ++i) {
    const double true_stress = stress[i] * (1 + strain[i]);
    const double plastic = std::log1p(strain[i]) - true_stress / young;
    if (i == top) result.necking_strain = plastic;
    if (plastic < least_plastic_strain) {
      ++result.elastic;
      continue;
    }
    result.strain.push_back(plastic);
    result.stress.push_back(true_stress);
    result.from.push_back(i);
  }
  return result;
}

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
