// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/mesh/hex_geometry.hpp"
#include "ogive/mesh/hex_mesh.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace ogive {

/// Positions of the corners of hex e, m.
template <class T> Corners<T> corners(const HexMesh<T> &mesh, Index e) {
  Corners<T> x;
  for (int a = 0; a < 8; ++a) x.row(a) = mesh.positions[mesh.hexes[e][a]].transpose();
  return x;
}

/// Exact volume of a mesh, m3.
template <class T> T volume(const HexMesh<T> &mesh) {
  T sum = T(0);
  for (Index e = 0; e < static_cast<Index>(mesh.hexes.size()); ++e) sum += hex_volume<T>(corners(mesh, e));
  return sum;
}

/// Smallest of the eight corners' scaled Jacobians: the determinant over the lengths of the edges that meet there. 1
/// for a brick, 0 where a corner is flat (Knupp 2000, Int. J. Numer. Methods Eng. 48:1165).
template <class T> T scaled_jacobian(const Corners<T> &x) {
  T smallest = T(1);
  for (int a = 0; a < 8; ++a) {
    const Mat3<T> J = jacobian(x, hex_corner<T>(a));
    smallest = std::min(smallest, determinant<T>(J) / (J.col(0).norm() * J.col(1).norm() * J.col(2).norm()));
  }
  return smallest;
}

/// Shapes of the hexes of a mesh.
template <class T> struct MeshQuality {
  T shortest_edge = T(1e30);         ///< m
  T longest_edge{};                  ///< m
  T largest_aspect{};                ///< longest over shortest edge of one hex
  T smallest_scaled_jacobian = T(1); ///< 1 for bricks
};

/// The worst of each over all hexes.
template <class T> MeshQuality<T> mesh_quality(const HexMesh<T> &mesh) {
  MeshQuality<T> q;
  for (Index e = 0; e < static_cast<Index>(mesh.hexes.size()); ++e) {
    const Corners<T> x = corners(mesh, e);
    T shortest = T(1e30), longest{};
    for (int a = 0; a < 8; ++a) {
      const Mat3<T> J = jacobian(x, hex_corner<T>(a)); // its columns are half the edges
      for (int d = 0; d < 3; ++d)
        shortest = std::min(shortest, T(2) * J.col(d).norm()), longest = std::max(longest, T(2) * J.col(d).norm());
    }
    q.shortest_edge = std::min(q.shortest_edge, shortest), q.longest_edge = std::max(q.longest_edge, longest);
    q.largest_aspect = std::max(q.largest_aspect, longest / shortest);
    q.smallest_scaled_jacobian = std::min(q.smallest_scaled_jacobian, scaled_jacobian<T>(x));
  }
  return q;
}

/// Throws SetupError, which begins with `name`, if the mesh has no hex, if a corner is no node of it, or if a hex has a
/// corner Jacobian or a volume that is not positive.
template <class T> void check_mesh(const HexMesh<T> &mesh, std::string_view name) {
  const std::string thing(name);
  const Index nodes = static_cast<Index>(mesh.positions.size());
  require(!mesh.hexes.empty(), thing + " number of hexes", mesh.hexes.size(), "must be at least 1");
  for (Index e = 0; e < static_cast<Index>(mesh.hexes.size()); ++e) {
    const auto hex = [&] { return thing + " hex " + std::to_string(e); };
    for (Index n : mesh.hexes[e])
      if (n < 0 || n >= nodes)
        require(false, hex() + " corner", n, "must be a node, 0 to " + std::to_string(nodes - 1));
    const Corners<T> x = corners(mesh, e);
    const T smallest = smallest_corner_jacobian<T>(x);
    if (!(smallest > T(0))) require(false, hex() + " corner Jacobian (m3)", smallest, "must be positive");
    const T v = hex_volume<T>(x);
    if (!(v > T(0))) require(false, hex() + " volume (m3)", v, "must be positive");
  }
}

} // namespace ogive
