// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/mesh/hex_geometry.hpp"

#include <limits>

namespace ogive {

/// Natural coordinates of the point `x` (m) in the hex with the corners given (m): Newton's method on the trilinear
/// map. Points somewhat outside get coordinates beyond [-1, 1], that is, extrapolation. `shape_functions` of the result
/// are weights that reproduce linear fields: sum N_a x_a = x. Throws SetupError if the iteration does not converge (a
/// point far outside a distorted hex).
template <class T> Vec3<T> natural_coordinates(const Corners<T> &corners, const Vec3<T> &x) {
  const T size = (corners.rowwise() - corners.row(0)).cwiseAbs().maxCoeff();
  const T tolerance = T(16) * std::numeric_limits<T>::epsilon() * (size + corners.cwiseAbs().maxCoeff());
  Vec3<T> xi = Vec3<T>::Zero();
  T residual = T(0);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Vec3<T> gap = x - corners.transpose() * shape_functions<T>(xi);
    residual = gap.norm();
    if (residual <= tolerance) return xi;
    xi += inverse<T>(jacobian(corners, xi)) * gap;
  }
  require(residual <= T(1e-6) * size, "distance of a point to its image in a hex (m)", residual,
          "must vanish: the point lies too far from the hex");
  return xi;
}

} // namespace ogive
