// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>

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

/// Box around the displacements `move(k)` (m) of `count` points. NaN if one of them is: lists of such positions must
/// not be built.
template <class T, class F> Box<T> box_of_moves(Index count, F &&move) {
  return ordered_fold(
      count, Box<T>{},
      [&](Index k) {
        const Vec3<T> u = move(k);
        return Box<T>{u, u};
      },
      [](const Box<T> &a, const Box<T> &b) {
        Box<T> c = a;
        for (int d = 0; d < 3; ++d) {
          if (!(b.low[d] >= a.low[d]) && a.low[d] == a.low[d]) c.low[d] = b.low[d];
          if (!(b.high[d] <= a.high[d]) && a.high[d] == a.high[d]) c.high[d] = b.high[d];
        }
        return c;
      });
}

/// Upper bound of the relative displacement of any two points whose displacements lie in `box` (m), mirror images
/// included, m: its diagonal. NaN if one of them is.
template <class T> T largest_relative_move(const Box<T> &box, SymmetryPlanes planes) {
  Vec3<T> extent = box.high - box.low;
  if (planes.x) extent[0] = std::max(extent[0], T(2) * std::max(box.high[0], -box.low[0]));
  if (planes.y) extent[1] = std::max(extent[1], T(2) * std::max(box.high[1], -box.low[1]));
  return extent.norm();
}

/// Upper bound of the relative displacement of any two of `count` points with the displacements `move(k)` (m).
template <class T, class F> T largest_relative_move(Index count, F &&move, SymmetryPlanes planes) {
  return largest_relative_move(box_of_moves<T>(count, move), planes);
}

} // namespace ogive
