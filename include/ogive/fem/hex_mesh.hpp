#pragma once

#include "ogive/core/types.hpp"

#include <array>
#include <vector>

namespace ogive {

/// A quadrilateral on the surface of hexes: four nodes, counter-clockwise seen from outside, and the hex it belongs to.
struct Facet {
  std::array<Index, 4> nodes{};
  Index hex = 0;
};

/// Eight-node hexahedra. Corners in the usual order: 0-3 the lower face counter-clockwise seen from above, 4-7 above
/// them.
template <class T> struct HexMesh {
  std::vector<Vec3<T>> positions;          ///< m
  std::vector<std::array<Index, 8>> hexes; ///< corners, indices into positions
};

} // namespace ogive
