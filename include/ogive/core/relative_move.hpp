// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/core/symmetry.hpp"

#include <algorithm>

namespace ogive {

/// How far two of `count` particles may have moved relative to each other, m, or more, if `move(k)` (m) is how far the
/// k-th has: no two displacements differ by more than the diagonal of the box around all of them, images included. NaN
/// if one is.
template <class T, class F> T largest_relative_move(Index count, F &&move, SymmetryPlanes planes) {
  struct Box {
    Vec3<T> low, high;
  };
  const Box box = ordered_fold(
      count, Box{Vec3<T>::Constant(T(1e30)), Vec3<T>::Constant(T(-1e30))},
      [&](Index k) {
        const Vec3<T> u = move(k);
        return Box{u, u};
      },
      [](const Box &a, const Box &b) {
        // Written so that a NaN stays: lists of such positions must not be built.
        Box c = a;
        for (int d = 0; d < 3; ++d) {
          if (!(b.low[d] >= a.low[d]) && a.low[d] == a.low[d]) c.low[d] = b.low[d];
          if (!(b.high[d] <= a.high[d]) && a.high[d] == a.high[d]) c.high[d] = b.high[d];
        }
        return c;
      });
  Vec3<T> extent = box.high - box.low;
  if (planes.x) extent[0] = std::max(extent[0], T(2) * std::max(box.high[0], -box.low[0]));
  if (planes.y) extent[1] = std::max(extent[1], T(2) * std::max(box.high[1], -box.low[1]));
  return extent.norm();
}

} // namespace ogive
