// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <cmath>

namespace ogive {

/// A rotation in space as a unit quaternion. Its four numbers stay a rotation to the last bits over any number of
/// products, if each product is normalised.
template <class T> struct Rotation {
  T scalar = T(1);                  ///< cosine of half the angle
  Vec3<T> vector = Vec3<T>::Zero(); ///< axis times the sine of half the angle
};

/// The rotation by the angle |`turn`| (rad) about the axis `turn`.
template <class T> Rotation<T> rotation_by(const Vec3<T> &turn) {
  const T half = T(0.5) * turn.norm();
  // sin(h)/h to round-off where h^6/5040 vanishes beside 1.
  const T ratio = half < T(1e-3) ? T(1) - half * half / T(6) * (T(1) - half * half / T(20)) : std::sin(half) / half;
  return {std::cos(half), T(0.5) * ratio * turn};
}

/// `first`, then `second`, normalised.
template <class T> Rotation<T> combined(const Rotation<T> &second, const Rotation<T> &first) {
  const T scalar = second.scalar * first.scalar - second.vector.dot(first.vector);
  const Vec3<T> vector =
      second.scalar * first.vector + first.scalar * second.vector + cross<T>(second.vector, first.vector);
  const T norm = std::sqrt(scalar * scalar + vector.squaredNorm());
  return {scalar / norm, vector / norm};
}

/// The rotation as a matrix.
template <class T> Mat3<T> matrix_of(const Rotation<T> &r) {
  const T s = r.scalar, x = r.vector[0], y = r.vector[1], z = r.vector[2];
  Mat3<T> m;
  m << T(1) - T(2) * (y * y + z * z), T(2) * (x * y - s * z), T(2) * (x * z + s * y), //
      T(2) * (x * y + s * z), T(1) - T(2) * (x * x + z * z), T(2) * (y * z - s * x),  //
      T(2) * (x * z - s * y), T(2) * (y * z + s * x), T(1) - T(2) * (x * x + y * y);
  return m;
}

} // namespace ogive
