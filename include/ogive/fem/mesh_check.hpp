// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/fem/hex8.hpp"
#include "ogive/fem/hex_mesh.hpp"

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
