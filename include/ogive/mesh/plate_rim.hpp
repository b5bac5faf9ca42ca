// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/mesh/facets.hpp"
#include "ogive/mesh/grading.hpp"
#include "ogive/mesh/hex_mesh.hpp"
#include "ogive/mesh/mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ogive {

/// The part of a round plate that is made of hexes: a ring around the disc of particles, between z = 0 and -thickness.
template <class T> struct RimShape {
  T inner_radius{};   ///< edge of the disc of particles, m
  T outer_radius{};   ///< clamp, m
  T thickness{};      ///< m
  T inner_size{};     ///< edge of the hexes at the inner radius, m
  T growth = T(1.15); ///< from one ring to the next
};

/// Throws SetupError if a dimension is out of range.
template <class T> void check(const RimShape<T> &shape) {
  const auto positive = [](T value, const char *thing) {
    require(std::isfinite(value) && value > T(0), thing, value, "must be positive and finite");
  };
  positive(shape.inner_radius, "rim inner radius (m)");
  positive(shape.thickness, "rim thickness (m)");
  positive(shape.inner_size, "rim hex size (m)");
  require(std::isfinite(shape.outer_radius) && shape.outer_radius > shape.inner_radius, "rim outer radius (m)",
          shape.outer_radius, "must lie beyond the inner radius");
  require(std::isfinite(shape.growth) && shape.growth >= T(1), "rim growth", shape.growth, "must be at least 1");
}

/// Graded rings of hexes. The nodes of the first ring lie on the cylinder of the inner radius; through the thickness
/// there are round(thickness/inner_size) layers, at least 2. Throws SetupError for a dimension out of range.
template <class T> HexMesh<T> rim_mesh(const RimShape<T> &shape, Extent extent) {
  check(shape);
  constexpr T quarter_turn = std::numbers::pi_v<T> / T(2);
  const auto divisions = [&](T length, Index least) {
    return std::max(least, static_cast<Index>(std::lround(length / shape.inner_size)));
  };
  const Index layers = divisions(shape.thickness, 2);
  const Index sectors = divisions(quarter_turn * shape.inner_radius, 2);
  const std::vector<T> rings = graded_stations(shape.outer_radius - shape.inner_radius, shape.inner_size, shape.growth,
                                               std::numeric_limits<T>::max());
  const Index ring_count = static_cast<Index>(rings.size()) - 1;

  HexMesh<T> quarter;
  for (Index r = 0; r <= ring_count; ++r)
    for (Index s = 0; s <= sectors; ++s) {
      const T radius = shape.inner_radius + rings[r], angle = quarter_turn * T(s) / T(sectors);
      const T x = s == sectors ? T(0) : radius * std::cos(angle), y = s == 0 ? T(0) : radius * std::sin(angle);
      for (Index k = 0; k <= layers; ++k)
        quarter.positions.push_back({x, y, shape.thickness * (T(k) / T(layers) - T(1))});
    }
  const auto node = [&](Index r, Index s, Index k) { return (r * (sectors + 1) + s) * (layers + 1) + k; };
  for (Index r = 0; r < ring_count; ++r)
    for (Index s = 0; s < sectors; ++s)
      for (Index k = 0; k < layers; ++k)
        quarter.hexes.push_back({node(r, s, k), node(r + 1, s, k), node(r + 1, s + 1, k), node(r, s + 1, k),
                                 node(r, s, k + 1), node(r + 1, s, k + 1), node(r + 1, s + 1, k + 1),
                                 node(r, s + 1, k + 1)});
  HexMesh<T> mesh = extended(quarter, extent);
  check_mesh(mesh, "rim");
  return mesh;
}

/// The facets of a rim on its inner cylinder, where the particles begin.
template <class T> std::vector<Facet> inner_facets(const HexMesh<T> &rim, const RimShape<T> &shape) {
  return facets_on_cylinder(boundary_facets(rim), rim.positions, shape.inner_radius, T(1e-5) * shape.inner_radius);
}

} // namespace ogive
