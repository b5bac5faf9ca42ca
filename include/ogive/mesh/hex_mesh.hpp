// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <array>
#include <vector>

namespace ogive {

/// A quadrilateral on the surface of hexes: four nodes, counter-clockwise seen from outside, and the hex it belongs to.
struct Facet {
  std::array<Index, 4> nodes{}; ///< indices into the mesh or into Nodes
  Index hex = 0;                ///< number in the mesh
};

/// Eight-node hexahedra. Corners in the usual order: 0-3 the lower face counter-clockwise seen from above, 4-7 above
/// them.
template <class T> struct HexMesh {
  std::vector<Vec3<T>> positions;          ///< m
  std::vector<std::array<Index, 8>> hexes; ///< corners, indices into positions
};

} // namespace ogive
