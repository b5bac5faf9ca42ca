// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

namespace ogive {

/// An axis-aligned box, m.
template <class T> struct Box {
  Vec3<T> low = Vec3<T>::Constant(T(1e30));   ///< least coordinates
  Vec3<T> high = Vec3<T>::Constant(T(-1e30)); ///< greatest coordinates; a new box is empty
};

/// Makes the box large enough to hold the point `p` (m).
template <class T> void extend(Box<T> &box, const Vec3<T> &p) {
  box.low = box.low.cwiseMin(p);
  box.high = box.high.cwiseMax(p);
}

/// True if the point `p` (m) lies in the box, faces included.
template <class T> bool is_inside(const Box<T> &box, const Vec3<T> &p) {
  return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
}

} // namespace ogive
