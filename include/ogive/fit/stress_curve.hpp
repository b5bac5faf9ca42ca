// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

} // namespace ogive
