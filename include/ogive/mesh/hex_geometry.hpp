// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/types.hpp"

#include <Eigen/Core>
#include <array>
#include <limits>
#include <numbers>

/// \file
/// Geometry of one trilinear eight-node hex. Corner a lies at (xi, eta, zeta) = `hex_corner<T>(a)` in [-1, 1]^3.

namespace ogive {

/// One vector for each corner of a hex: row a is corner a.
template <class T> using Corners = Eigen::Matrix<T, 8, 3>;

/// Values of the eight shape functions or weights.
template <class T> using CornerWeights = Eigen::Matrix<T, 8, 1>;

/// First natural coordinate of each corner.
inline constexpr std::array<int, 8> hex_xi = {-1, 1, 1, -1, -1, 1, 1, -1};
/// Second natural coordinate of each corner.
inline constexpr std::array<int, 8> hex_eta = {-1, -1, 1, 1, -1, -1, 1, 1};
/// Third natural coordinate of each corner.
inline constexpr std::array<int, 8> hex_zeta = {-1, -1, -1, -1, 1, 1, 1, 1};

/// Corners of the six faces of a hex, counter-clockwise seen from outside.
inline constexpr std::array<std::array<int, 4>, 6> hex_faces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Natural coordinates of corner a.
template <class T> Vec3<T> hex_corner(int a) {
  const auto c = static_cast<std::size_t>(a);
  return {T(hex_xi[c]), T(hex_eta[c]), T(hex_zeta[c])};
}

/// The point p of the 2x2x2 Gauss rule, next to corner p; all weights are 1.
template <class T> Vec3<T> gauss_point(int p) { return hex_corner<T>(p) * T(1 / std::numbers::sqrt3); }

/// Trilinear shape functions N_a at the natural coordinates xi; they add up to one.
template <class T> CornerWeights<T> shape_functions(const Vec3<T> &xi) {
  CornerWeights<T> N;
  for (int a = 0; a < 8; ++a) {
    const Vec3<T> c = hex_corner<T>(a);
    N[a] = T(0.125) * (T(1) + c[0] * xi[0]) * (T(1) + c[1] * xi[1]) * (T(1) + c[2] * xi[2]);
  }
  return N;
}

/// dN_a/dxi_j at xi, row a, column j.
template <class T> Corners<T> shape_derivatives(const Vec3<T> &xi) {
  Corners<T> D;
  for (int a = 0; a < 8; ++a) {
    const Vec3<T> c = hex_corner<T>(a);
    const Vec3<T> f(T(1) + c[0] * xi[0], T(1) + c[1] * xi[1], T(1) + c[2] * xi[2]);
    D(a, 0) = T(0.125) * c[0] * f[1] * f[2];
    D(a, 1) = T(0.125) * c[1] * f[2] * f[0];
    D(a, 2) = T(0.125) * c[2] * f[0] * f[1];
  }
  return D;
}

/// Jacobian dx_i/dxi_j at xi, m.
template <class T> Mat3<T> jacobian(const Corners<T> &x, const Vec3<T> &xi) {
  return x.transpose() * shape_derivatives(xi);
}

/// Smallest Jacobian determinant of the eight corners, m3 per unit of natural volume (a brick of volume V has V/8).
/// A hex is usable if it is positive.
template <class T> T smallest_corner_jacobian(const Corners<T> &x) {
  T smallest = determinant<T>(jacobian(x, hex_corner<T>(0)));
  for (int a = 1; a < 8; ++a) {
    const T det = determinant<T>(jacobian(x, hex_corner<T>(a)));
    if (!(det >= smallest)) smallest = det;
  }
  return smallest;
}

/// The seven non-constant coefficients of a trilinear field, row m:
/// xi, eta, zeta, eta zeta, zeta xi, xi eta, xi eta zeta.
template <class T> using HexModes = Eigen::Matrix<T, 7, 3>;

/// Coefficients of the trilinear field with the corner values `u`.
template <class T> HexModes<T> modes(const Corners<T> &u) {
  HexModes<T> m;
  for (int i = 0; i < 3; ++i) {
    const T s01 = u(0, i) + u(1, i), d01 = u(1, i) - u(0, i);
    const T s23 = u(3, i) + u(2, i), d23 = u(2, i) - u(3, i);
    const T s45 = u(4, i) + u(5, i), d45 = u(5, i) - u(4, i);
    const T s67 = u(7, i) + u(6, i), d67 = u(6, i) - u(7, i);
    const T eighth = T(0.125);
    m(0, i) = eighth * ((d01 + d23) + (d45 + d67));
    m(1, i) = eighth * ((s23 - s01) + (s67 - s45));
    m(2, i) = eighth * ((s45 + s67) - (s01 + s23));
    m(3, i) = eighth * ((s67 - s45) - (s23 - s01));
    m(4, i) = eighth * ((d45 + d67) - (d01 + d23));
    m(5, i) = eighth * ((d23 - d01) + (d67 - d45));
    m(6, i) = eighth * ((d67 - d45) - (d23 - d01));
  }
  return m;
}

/// Corner values of the trilinear field with the coefficients `m` and no constant part: the inverse of `modes`.
template <class T> Corners<T> corner_values(const HexModes<T> &m) {
  Corners<T> u;
  for (int i = 0; i < 3; ++i) {
    const T p = m(0, i) + m(1, i), q = m(1, i) - m(0, i), r = m(3, i) + m(4, i), s = m(3, i) - m(4, i);
    const T above = m(5, i) + m(2, i), below = m(5, i) - m(2, i), t = m(6, i);
    u(0, i) = below - p + r - t;
    u(1, i) = t - above - q + s;
    u(2, i) = below + p - r - t;
    u(3, i) = t - above + q - s;
    u(4, i) = above - p - r + t;
    u(5, i) = -below - q - s - t;
    u(6, i) = above + p + r + t;
    u(7, i) = q - below + s - t;
  }
  return u;
}

/// Volume V and the mean gradient operator b_a of a hex. V b_a = integral of dN_a/dx is kept by its coefficients: they
/// are six, the constant and the trilinear one vanish.
template <class T> struct MeanGradient {
  Eigen::Matrix<T, 6, 3> integral; ///< m2, rows in the order of HexModes
  T volume;                        ///< m3
};

/// The exact mean gradient operator in closed form (Flanagan & Belytschko 1981): V b_a = dV/dx_a, from the coefficients
/// of the trilinear map, of which the last one drops out.
template <class T> MeanGradient<T> mean_gradient(const HexModes<T> &x) {
  const Vec3<T> a1 = x.row(0), a2 = x.row(1), a3 = x.row(2), c1 = x.row(3), c2 = x.row(4), c3 = x.row(5);
  const T third = T(1) / T(3);
  MeanGradient<T> mean;
  mean.integral.row(0) = cross<T>(a2, a3) - third * cross<T>(c2, c3);
  mean.integral.row(1) = cross<T>(a3, a1) - third * cross<T>(c3, c1);
  mean.integral.row(2) = cross<T>(a1, a2) - third * cross<T>(c1, c2);
  mean.integral.row(3) = third * (cross<T>(a3, c2) + cross<T>(c3, a2));
  mean.integral.row(4) = third * (cross<T>(a1, c3) + cross<T>(c1, a3));
  mean.integral.row(5) = third * (cross<T>(a2, c1) + cross<T>(c2, a1));
  mean.volume = T(8) * third * mean.integral.cwiseProduct(x.template topRows<6>()).sum();
  return mean;
}

/// V b_a = integral of dN_a/dx dV for each corner a, m2.
template <class T> Corners<T> corner_integrals(const MeanGradient<T> &mean) {
  HexModes<T> m;
  m.template topRows<6>() = mean.integral;
  m.row(6).setZero();
  return corner_values<T>(m);
}

/// The exact mean gradient operator of a hex with the corners `x` (m).
template <class T> MeanGradient<T> mean_gradient(const Corners<T> &x) { return mean_gradient<T>(modes<T>(x)); }

/// Exact volume, m3.
template <class T> T hex_volume(const Corners<T> &x) { return mean_gradient<T>(x).volume; }

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

/// True if the point `x` (m) lies in the hex with the corners given (m), each of whose faces is four triangles around
/// its middle, as contacts see it: in one of the tetrahedra between these triangles and the middle of the hex.
template <class T> bool lies_in_hex(const Corners<T> &corners, const Vec3<T> &x) {
  constexpr T round_off = T(64) * std::numeric_limits<T>::epsilon();
  const Vec3<T> inside = corners.colwise().mean().transpose(), to_point = x - inside;
  for (const std::array<int, 4> &face : hex_faces) {
    const auto at = [&](int k) { return Vec3<T>(corners.row(face[k % 4]).transpose() - inside); };
    const Vec3<T> middle = T(0.25) * (at(0) + at(1) + at(2) + at(3));
    for (int k = 0; k < 4; ++k) {
      const Vec3<T> a = at(k), b = at(k + 1), across = cross<T>(b, middle);
      const T volume = a.dot(across);
      const Vec3<T> weights(to_point.dot(across), to_point.dot(cross<T>(middle, a)), to_point.dot(cross<T>(a, b)));
      if (volume > T(0) && weights.minCoeff() >= -round_off * volume && weights.sum() <= (T(1) + round_off) * volume)
        return true;
    }
  }
  return false;
}

} // namespace ogive
