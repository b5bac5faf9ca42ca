// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/core/types.hpp"

#include <span>
#include <vector>

namespace ogive {

/// Mirror image of a point.
struct MirrorImage {
  Index parent = 0;        ///< point
  Reflection reflection{}; ///< that makes the image
};

/// Largest distance of the points at `positions` (m) behind each plane x, y, z = 0, m; 0 if none is behind it.
template <class T> Vec3<T> furthest_behind(std::span<const Vec3<T>> positions) {
  Vec3<T> behind = Vec3<T>::Zero();
  for (const Vec3<T> &x : positions) behind = behind.cwiseMax(-x);
  return behind;
}

/// Calls `f(reflection)` for each reflection that shows the model in its mirror planes.
template <class F> void for_each_reflection(SymmetryPlanes planes, F &&f) {
  if (planes.x) f(Reflection{1, 0});
  if (planes.y) f(Reflection{0, 1});
  if (planes.x && planes.y) f(Reflection{1, 1});
}

/// Mirror images of all points that another one can have within `reach` (m). A point may have been pushed across a
/// plane: the reach is longer by as far as the furthest one lies behind it, so that pairs find each other both ways.
template <class T>
std::vector<MirrorImage> mirror_images(std::span<const Vec3<T>> positions, SymmetryPlanes planes, T reach) {
  const Vec3<T> behind = furthest_behind(positions);
  std::vector<MirrorImage> images;
  for_each_reflection(planes, [&](Reflection in) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      if ((!in.x || positions[i][0] < reach + behind[0]) && (!in.y || positions[i][1] < reach + behind[1]))
        images.push_back({static_cast<Index>(i), in});
  });
  return images;
}

} // namespace ogive
