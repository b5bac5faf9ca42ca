// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

/// \file
/// Scalars, vectors and tensors. Everything in the library is in SI units.

namespace ogive {

/// Index of a node, an element or a particle.
using Index = std::int32_t;

/// A vector in space (x, y, z).
template <class T> using Vec3 = Eigen::Matrix<T, 3, 1>;

/// A second-order tensor, row first: `L(i, j)` is component ij.
template <class T> using Mat3 = Eigen::Matrix<T, 3, 3>;

/// A symmetric second-order tensor (stress in Pa, rate of deformation in 1/s).
template <class T> struct Sym3 {
  T xx{}, yy{}, zz{}, xy{}, yz{}, zx{}; ///< components

  ///@{
  /// Component by component.
  constexpr Sym3 &operator+=(const Sym3 &o) {
    xx += o.xx, yy += o.yy, zz += o.zz, xy += o.xy, yz += o.yz, zx += o.zx;
    return *this;
  }
  constexpr Sym3 &operator*=(T f) {
    xx *= f, yy *= f, zz *= f, xy *= f, yz *= f, zx *= f;
    return *this;
  }
  friend constexpr Sym3 operator+(Sym3 a, const Sym3 &b) { return a += b; }
  friend constexpr Sym3 operator-(Sym3 a, const Sym3 &b) { return a += T(-1) * b; }
  friend constexpr Sym3 operator*(T f, Sym3 a) { return a *= f; }
  ///@}
};

/// Trace of a symmetric tensor.
template <class T> constexpr T trace(const Sym3<T> &a) { return a.xx + a.yy + a.zz; }

/// Double contraction a : b.
template <class T> constexpr T double_dot(const Sym3<T> &a, const Sym3<T> &b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + T(2) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}

/// f times the identity.
template <class T> constexpr Sym3<T> spherical(T f) { return {f, f, f, T(0), T(0), T(0)}; }

/// Deviatoric part.
template <class T> constexpr Sym3<T> deviator(const Sym3<T> &a) { return a - spherical(trace(a) / T(3)); }

/// Symmetric part of a general tensor.
template <class T> Sym3<T> symmetric_part(const Mat3<T> &a) {
  return {a(0, 0),
          a(1, 1),
          a(2, 2),
          T(0.5) * (a(0, 1) + a(1, 0)),
          T(0.5) * (a(1, 2) + a(2, 1)),
          T(0.5) * (a(2, 0) + a(0, 2))};
}

/// A symmetric tensor as a full 3x3 matrix.
template <class T> Mat3<T> full(const Sym3<T> &a) {
  Mat3<T> m;
  m << a.xx, a.xy, a.zx, a.xy, a.yy, a.yz, a.zx, a.yz, a.zz;
  return m;
}

/// Von Mises equivalent of a deviatoric stress, Pa.
template <class T> T von_mises(const Sym3<T> &s) {
  using std::sqrt;
  return sqrt(T(1.5) * double_dot(s, s));
}

/// Inverse of a 3x3 matrix by its adjugate. The determinant must not vanish.
template <class T> Mat3<T> inverse(const Mat3<T> &a) {
  const Vec3<T> c0 = a.col(0), c1 = a.col(1), c2 = a.col(2);
  Mat3<T> r;
  r.row(0) = Vec3<T>(c1[1] * c2[2] - c1[2] * c2[1], c1[2] * c2[0] - c1[0] * c2[2], c1[0] * c2[1] - c1[1] * c2[0]);
  r.row(1) = Vec3<T>(c2[1] * c0[2] - c2[2] * c0[1], c2[2] * c0[0] - c2[0] * c0[2], c2[0] * c0[1] - c2[1] * c0[0]);
  r.row(2) = Vec3<T>(c0[1] * c1[2] - c0[2] * c1[1], c0[2] * c1[0] - c0[0] * c1[2], c0[0] * c1[1] - c0[1] * c1[0]);
  const T det = c0[0] * r(0, 0) + c0[1] * r(0, 1) + c0[2] * r(0, 2);
  return r * (T(1) / det);
}

/// Product of two 3x3 matrices, in one piece for packs too: Eigen's is a loop with calls there.
template <class T> [[gnu::always_inline]] inline Mat3<T> product(const Mat3<T> &a, const Mat3<T> &b) {
  Mat3<T> ab;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) ab(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
  return ab;
}

/// Cross product (Eigen's lives in a heavier header).
template <class T> Vec3<T> cross(const Vec3<T> &a, const Vec3<T> &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Determinant of a 3x3 matrix.
template <class T> T determinant(const Mat3<T> &a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

} // namespace ogive
