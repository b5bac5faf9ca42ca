// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/hex_mesh.hpp"

#include <array>
#include <vector>

/// \file
/// A quarter (x >= 0, y >= 0) of a round body: a square core of hexes along the z axis with a shell around it, so that
/// no hex collapses on the axis. The shell covers the core's sides and, optionally, its front.

namespace ogive {

/// Numbers of hexes of an O-grid.
struct OGridCounts {
  Index core = 0;            ///< across half of the core
  Index shell = 0;           ///< through the shell
  Index along = 0;           ///< along the core
  bool covers_front = false; ///< the shell wraps around the front, z = smallest
};

/// Builds the O-grid. `core_at(i, j, k)` and `surface_at(i, j, k)` give the position (m) of a core node and, for a node
/// on the core's side or front, of its image on the body's surface; i, j = 0 to core, k = 0 (front) to along.
/// `shell_at(inner, outer, l)` gives the l-th shell node between the two, l = 1 to shell.
template <class T, class CoreAt, class SurfaceAt, class ShellAt>
HexMesh<T> o_grid(const OGridCounts &n, CoreAt &&core_at, SurfaceAt &&surface_at, ShellAt &&shell_at) {
  HexMesh<T> mesh;
  const Index row = n.core + 1;
  const auto core_node = [&](Index i, Index j, Index k) { return (k * row + j) * row + i; };
  std::vector<Index> first_shell_node(static_cast<std::size_t>(row) * row * (n.along + 1), -1);
  for (Index k = 0; k <= n.along; ++k)
    for (Index j = 0; j <= n.core; ++j)
      for (Index i = 0; i <= n.core; ++i) mesh.positions.push_back(core_at(i, j, k));
  for (Index k = 0; k <= n.along; ++k)
    for (Index j = 0; j <= n.core; ++j)
      for (Index i = 0; i <= n.core; ++i) {
        if (i < n.core && j < n.core && !(n.covers_front && k == 0)) continue;
        first_shell_node[core_node(i, j, k)] = static_cast<Index>(mesh.positions.size());
        const Vec3<T> inner = mesh.positions[core_node(i, j, k)], outer = surface_at(i, j, k);
        for (Index l = 1; l <= n.shell; ++l) mesh.positions.push_back(shell_at(inner, outer, l));
      }
  const auto node = [&](Index i, Index j, Index k, Index l) {
    return l == 0 ? core_node(i, j, k) : first_shell_node[core_node(i, j, k)] + l - 1;
  };

  const auto add = [&](std::array<Index, 4> lower, std::array<Index, 4> upper) {
    mesh.hexes.push_back({lower[0], lower[1], lower[2], lower[3], upper[0], upper[1], upper[2], upper[3]});
  };
  if (n.covers_front)
    for (Index l = n.shell - 1; l >= 0; --l) {
      for (Index j = 0; j < n.core; ++j)
        for (Index i = 0; i < n.core; ++i) {
          const auto face = [&](Index m) {
            return std::array{node(i, j, 0, m), node(i + 1, j, 0, m), node(i + 1, j + 1, 0, m), node(i, j + 1, 0, m)};
          };
          add(face(l + 1), face(l));
        }
    }
  for (Index k = 0; k < n.along; ++k) {
    for (Index j = 0; j < n.core; ++j)
      for (Index i = 0; i < n.core; ++i) {
        const auto face = [&](Index m) {
          return std::array{node(i, j, m, 0), node(i + 1, j, m, 0), node(i + 1, j + 1, m, 0), node(i, j + 1, m, 0)};
        };
        add(face(k), face(k + 1));
      }
    for (Index s = 0; s < n.core; ++s)
      for (Index l = 0; l < n.shell; ++l) {
        const Index c = n.core;
        const auto x_side = [&](Index m) {
          return std::array{node(c, s, m, l), node(c, s, m, l + 1), node(c, s + 1, m, l + 1), node(c, s + 1, m, l)};
        };
        const auto y_side = [&](Index m) {
          return std::array{node(s, c, m, l), node(s + 1, c, m, l), node(s + 1, c, m, l + 1), node(s, c, m, l + 1)};
        };
        add(x_side(k), x_side(k + 1));
        add(y_side(k), y_side(k + 1));
      }
  }
  return mesh;
}

/// O-grid with evenly spaced shell nodes.
template <class T, class CoreAt, class SurfaceAt>
HexMesh<T> o_grid(const OGridCounts &n, CoreAt &&core_at, SurfaceAt &&surface_at) {
  return o_grid<T>(n, core_at, surface_at, [&](const Vec3<T> &inner, const Vec3<T> &outer, Index l) -> Vec3<T> {
    return inner + T(l) / T(n.shell) * (outer - inner);
  });
}

} // namespace ogive
