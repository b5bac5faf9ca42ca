// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/hex_geometry.hpp"

/// \file
/// Velocity gradients and forces of one trilinear eight-node hex: pure functions.

namespace ogive {

/// Gradients dN_a/dx (1/m) at one integration point and the volume that belongs to it (m3).
template <class T> struct PointGradient {
  Corners<T> gradient; ///< 1/m, row a is corner a
  T volume;            ///< m3
};

/// Gradients at the 2x2x2 Gauss point p.
template <class T> PointGradient<T> point_gradient(const Corners<T> &x, int p) {
  const Corners<T> D = shape_derivatives<T>(gauss_point<T>(p));
  const Mat3<T> J = x.transpose() * D;
  return {D * inverse<T>(J), determinant<T>(J)};
}

/// Mean velocity gradient L = sum_a v_a (x) b_a, 1/s, with respect to the positions behind `mean`, from the
/// coefficients of the velocity (m/s).
template <class T> Mat3<T> mean_velocity_gradient(const MeanGradient<T> &mean, const HexModes<T> &v) {
  return (T(8) / mean.volume) * (v.template topRows<6>().transpose() * mean.integral);
}

/// Velocity gradient at an integration point with its trace replaced by `mean_trace` (B-bar, Hughes 1980), 1/s.
template <class T> Mat3<T> b_bar_velocity_gradient(const PointGradient<T> &point, T mean_trace, const Corners<T> &v) {
  Mat3<T> L = v.transpose() * point.gradient;
  const T correction = (mean_trace - (L(0, 0) + L(1, 1) + L(2, 2))) / T(3);
  for (int k = 0; k < 3; ++k) L(k, k) += correction;
  return L;
}

/// Coefficients of the corner forces f_a = -V sigma b_a of a constant stress (Pa), N.
template <class T> HexModes<T> force_modes(const MeanGradient<T> &mean, const Mat3<T> &stress) {
  HexModes<T> f;
  f.template topRows<6>() = -(mean.integral * stress.transpose());
  f.row(6).setZero();
  return f;
}

/// Corner forces of the stress deviator (Pa) at an integration point through its own gradient, N. With the pressure
/// through the mean gradient, this is the transpose of `b_bar_velocity_gradient`.
template <class T> Corners<T> deviatoric_forces(const PointGradient<T> &point, const Mat3<T> &deviator) {
  return -point.volume * (point.gradient * deviator);
}

/// Integrals of the shape functions over the hex, m3: the shares of a lumped mass (row sums). They are positive for a
/// hex with positive corner Jacobians, add up to the exact volume and keep its centre.
template <class T> CornerWeights<T> lumped_volumes(const Corners<T> &x) {
  CornerWeights<T> share = CornerWeights<T>::Zero();
  for (int p = 0; p < 8; ++p)
    share += determinant<T>(jacobian(x, gauss_point<T>(p))) * shape_functions<T>(gauss_point<T>(p));
  return share;
}

} // namespace ogive
