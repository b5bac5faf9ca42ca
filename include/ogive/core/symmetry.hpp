// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"

#include <cmath>
#include <cstdint>

namespace ogive {

/// Computed part of the round model.
enum class Extent { full, half, quarter };

/// Mirror planes x = 0 and y = 0 (the planes yz and xz). A half model has the plane y = 0, a quarter model both.
struct SymmetryPlanes {
  bool x = false; ///< mirror plane x = 0
  bool y = false; ///< mirror plane y = 0
  /// Copies of the model that make up the whole: 1, 2 or 4.
  int copies() const { return (x ? 2 : 1) * (y ? 2 : 1); }
};

/// The mirror planes of an extent.
inline SymmetryPlanes symmetry_planes(Extent extent) { return {extent == Extent::quarter, extent != Extent::full}; }

/// Reflections in mirror planes.
struct Reflection {
  std::uint8_t x = 0; ///< 1: in the plane x = 0
  std::uint8_t y = 0; ///< 1: in the plane y = 0
};

/// A vector or position as the mirrors show it.
template <class T> Vec3<T> reflected(const Vec3<T> &v, Reflection reflection) {
  return {reflection.x ? -v[0] : v[0], reflection.y ? -v[1] : v[1], v[2]};
}

/// The reflection that brings a position (m) to the model's side of its mirror planes, x >= 0 and y >= 0.
template <class T> Reflection to_model_side(const Vec3<T> &position, SymmetryPlanes planes) {
  return {planes.x && position[0] < T(0), planes.y && position[1] < T(0)};
}

/// Holds the nodes that lie in a mirror plane in the direction normal to it. `tolerance` in m.
template <class T> void hold_on_planes(Nodes<T> &nodes, NodeRange range, SymmetryPlanes planes, T tolerance) {
  for (Index n = range.begin; n < range.end; ++n) {
    if (planes.x && std::abs(nodes.position[n][0]) <= tolerance) nodes.held[n] |= held_x;
    if (planes.y && std::abs(nodes.position[n][1]) <= tolerance) nodes.held[n] |= held_y;
  }
}

} // namespace ogive
