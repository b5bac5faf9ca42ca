// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/mesh/facets.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// \file
/// The surface of a body whose hexes go one by one: a face shows where there is no hex behind it, or none any more.

namespace ogive {

/// For each hex and face (in the order of hex_faces) the hex behind it, or one of the two below.
using FaceNeighbours = std::vector<std::array<Index, 6>>;

/// Behind a face of the surface.
inline constexpr Index no_neighbour = -1;

/// Behind a face in a mirror plane: its own image, so that it never shows.
inline constexpr Index mirror_neighbour = -2;

/// Which hexes share faces. Faces whose nodes a mirror plane holds have their image behind them.
template <class T>
FaceNeighbours face_neighbours(const std::vector<std::array<Index, 8>> &hexes, const Nodes<T> &nodes,
                               SymmetryPlanes planes) {
  const std::vector<SortedFace> faces = sorted_faces(hexes);
  FaceNeighbours neighbours(hexes.size());
  for (auto &of_hex : neighbours) of_hex.fill(no_neighbour);
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
    if (faces[i].sorted == faces[i + 1].sorted) {
      const std::size_t a = faces[i].place, b = faces[i + 1].place;
      neighbours[a / 6][a % 6] = static_cast<Index>(b / 6);
      neighbours[b / 6][b % 6] = static_cast<Index>(a / 6);
    }
  const auto lies_in = [&](const std::array<Index, 4> &face, Held plane) {
    return std::all_of(face.begin(), face.end(), [&](Index n) { return (nodes.held[n] & plane) != 0; });
  };
  for (std::size_t e = 0; e < hexes.size(); ++e)
    for (std::size_t f = 0; f < 6; ++f)
      if (const auto face = face_nodes(hexes[e], f);
          neighbours[e][f] == no_neighbour &&
          ((planes.x && lies_in(face, held_x)) || (planes.y && lies_in(face, held_y))))
        neighbours[e][f] = mirror_neighbour;
  return neighbours;
}

/// The faces of present hexes with nothing behind them, in the order of the hexes; `is_gone(e)` is true for hexes that
/// are no longer there.
template <class F>
std::vector<Facet> exposed_facets(const std::vector<std::array<Index, 8>> &hexes, const FaceNeighbours &neighbours,
                                  F &&is_gone) {
  std::vector<Facet> facets;
  for (Index e = 0; e < static_cast<Index>(hexes.size()); ++e) {
    if (is_gone(e)) continue;
    for (std::size_t f = 0; f < 6; ++f)
      if (const Index behind = neighbours[e][f]; behind == no_neighbour || (behind >= 0 && is_gone(behind)))
        facets.push_back({face_nodes(hexes[e], f), e});
  }
  return facets;
}

} // namespace ogive
