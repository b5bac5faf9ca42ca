// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/grading.hpp"
#include "ogive/mesh/hex_mesh.hpp"
#include "ogive/mesh/mesh_check.hpp"
#include "ogive/mesh/o_grid.hpp"
#include "ogive/mesh/projectile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ogive {

/// A round plate of hexes, between z = 0 and -thickness.
template <class T> struct PlateShapeOfHexes {
  T struck_radius{};  ///< of the projectile: one ring of hexes lies astride it, m
  T fine_radius{};    ///< rings are about as wide as the hexes are high up to here, m
  T outer_radius{};   ///< clamp, m
  T thickness{};      ///< m
  T size{};           ///< target edge of the hexes, m
  T growth = T(1.15); ///< from one ring to the next beyond the fine ones
};

/// Layers of hexes through the thickness, at least 2.
template <class T> Index layers(const PlateShapeOfHexes<T> &shape) {
  return std::max(Index(2), static_cast<Index>(std::lround(shape.thickness / shape.size)));
}

/// One conforming mesh: an O-grid up to the ring astride the projectile's edge, which is as wide as the hexes are high,
/// rings of about that size, then rings that grow out to the clamp. All hexes below the projectile are near cubes. The
/// plug is sheared off in that one ring: its width decides how much work that takes. Throws SetupError for a dimension
/// out of range.
template <class T> HexMesh<T> plate_mesh(const PlateShapeOfHexes<T> &shape, Extent extent) {
  require(shape.size > T(0) && shape.size <= shape.struck_radius / T(2), "hex size (m)", shape.size,
          "must be positive and at most half the projectile's radius");
  require(shape.thickness > T(0), "plate thickness (m)", shape.thickness, "must be positive");
  require(shape.fine_radius > shape.struck_radius + shape.size && shape.outer_radius > shape.fine_radius,
          "radius of the fine hexes (m)", shape.fine_radius, "must lie between projectile and clamp");
  OGridCounts n;
  n.along = layers(shape);
  const T size = shape.thickness / T(n.along);
  const T inside = shape.struck_radius - T(0.5) * size;
  std::vector<T> radii = {inside + size};
  const auto append = [&](const std::vector<T> &stations) {
    const T from = radii.back();
    for (std::size_t k = 1; k < stations.size(); ++k) radii.push_back(from + stations[k]);
  };
  append(graded_stations(shape.fine_radius - radii.back(), size, T(1), size));
  append(graded_stations(shape.outer_radius - radii.back(), shape.growth * size, shape.growth,
                         std::numeric_limits<T>::max()));

  const auto at_least = [](Index least, T value) { return std::max(least, static_cast<Index>(std::lround(value))); };
  n.core = at_least(2, std::numbers::pi_v<T> / T(4) * inside / size);
  // Outline and shell between near cubes and the largest stable step.
  const CoreOutline<T> core{T(0.7), T(0.86), T(1)};
  const Index between = at_least(1, T(0.31) * T(n.core));
  n.shell = between + static_cast<Index>(radii.size());
  const auto fraction = [&](Index i) { return T(i) / T(n.core); };
  const auto placed = [&](const Vec3<T> &unit, Index k) -> Vec3<T> {
    return {inside * unit[0], inside * unit[1], shape.thickness * (T(k) / T(n.along) - T(1))};
  };
  const HexMesh<T> quarter = o_grid<T>(
      n, [&](Index i, Index j, Index k) { return placed(core_point(core, fraction(i), fraction(j), T(0)), k); },
      [&](Index i, Index j, Index k) { return placed(surface_direction(fraction(i), fraction(j), T(0)), k); },
      [&](const Vec3<T> &inner, const Vec3<T> &outer, Index l) -> Vec3<T> {
        if (l <= between) return inner + T(l) / T(between) * (outer - inner);
        const T scale = radii[l - between - 1] / inside;
        return {scale * outer[0], scale * outer[1], outer[2]};
      });
  HexMesh<T> mesh = extended(quarter, extent);
  check_mesh(mesh, "plate");
  return mesh;
}

} // namespace ogive
