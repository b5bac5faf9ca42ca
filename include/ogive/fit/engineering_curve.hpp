// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace ogive {

/// What becomes of a curve of engineering stress and strain.
struct TrueCurve {
  std::vector<double> strain;    ///< true plastic strain
  std::vector<double> stress;    ///< true stress, Pa
  std::vector<std::size_t> from; ///< index of each point in the engineering curve
  std::size_t elastic = 0;       ///< points left out because their plastic strain is below `least_plastic_strain`
  std::size_t necked = 0;        ///< points left out behind the largest engineering stress
  double necking_strain = 0;     ///< true plastic strain there
};

/// Where yielding ends and hardening begins: 0.2 % plastic strain.
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

} // namespace ogive
