// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
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

/// The mesh and its mirror image across the plane where coordinate `axis` (0 or 1) is zero. Nodes whose coordinate is
/// exactly zero are shared.
template <class T> HexMesh<T> with_mirror_image(const HexMesh<T> &mesh, int axis) {
  HexMesh<T> whole = mesh;
  std::vector<Index> image(mesh.positions.size());
  for (std::size_t n = 0; n < mesh.positions.size(); ++n) {
    image[n] = static_cast<Index>(n);
    if (mesh.positions[n][axis] == T(0)) continue;
    image[n] = static_cast<Index>(whole.positions.size());
    whole.positions.push_back(mesh.positions[n]);
    whole.positions.back()[axis] = -mesh.positions[n][axis];
  }
  constexpr std::array<std::size_t, 8> swapped = {1, 0, 3, 2, 5, 4, 7, 6};
  for (const auto &hex : mesh.hexes) {
    std::array<Index, 8> mirrored;
    for (std::size_t a = 0; a < 8; ++a) mirrored[a] = image[hex[swapped[a]]];
    whole.hexes.push_back(mirrored);
  }
  return whole;
}

/// A quarter mesh (x >= 0, y >= 0) as a quarter, a half (y >= 0) or a full mesh.
template <class T> HexMesh<T> extended(const HexMesh<T> &quarter, Extent extent) {
  if (extent == Extent::quarter) return quarter;
  const HexMesh<T> half = with_mirror_image(quarter, 0);
  return extent == Extent::half ? half : with_mirror_image(half, 1);
}

} // namespace ogive
