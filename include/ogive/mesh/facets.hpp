// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/mesh/hex_geometry.hpp"
#include "ogive/mesh/hex_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <vector>

namespace ogive {

/// The nodes of face `face` of a hex.
inline std::array<Index, 4> face_nodes(const std::array<Index, 8> &hex, std::size_t face) {
  std::array<Index, 4> nodes;
  for (std::size_t k = 0; k < 4; ++k) nodes[k] = hex[hex_faces[face][k]];
  return nodes;
}

/// A face of a hex among those of all hexes.
struct SortedFace {
  std::array<Index, 4> sorted; ///< its nodes, ascending: equal for the two hexes that share it
  std::size_t place;           ///< 6 * hex + face
  /// By nodes, then by place.
  auto operator<=>(const SortedFace &) const = default;
};

/// All faces of the hexes, sorted so that shared ones follow each other.
inline std::vector<SortedFace> sorted_faces(const std::vector<std::array<Index, 8>> &hexes) {
  std::vector<SortedFace> faces;
  faces.reserve(6 * hexes.size());
  for (std::size_t place = 0; place < 6 * hexes.size(); ++place) {
    auto sorted = face_nodes(hexes[place / 6], place % 6);
    std::sort(sorted.begin(), sorted.end());
    faces.push_back({sorted, place});
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The faces that belong to one hex only, in the order of the hexes; their nodes are indices into the mesh.
template <class T> std::vector<Facet> boundary_facets(const HexMesh<T> &mesh) {
  const std::vector<SortedFace> faces = sorted_faces(mesh.hexes);
  std::vector<std::size_t> single;
  for (std::size_t i = 0, next; i < faces.size(); i = next) {
    for (next = i + 1; next < faces.size() && faces[next].sorted == faces[i].sorted;) ++next;
    if (next == i + 1) single.push_back(faces[i].place);
  }
  std::sort(single.begin(), single.end());
  std::vector<Facet> facets;
  facets.reserve(single.size());
  for (std::size_t place : single)
    facets.push_back({face_nodes(mesh.hexes[place / 6], place % 6), static_cast<Index>(place / 6)});
  return facets;
}

/// The facets whose four nodes all satisfy `keep(position)`.
template <class T, class Keep>
std::vector<Facet> facets_where(const std::vector<Facet> &facets, const std::vector<Vec3<T>> &positions, Keep &&keep) {
  std::vector<Facet> kept;
  for (const Facet &facet : facets)
    if (std::all_of(facet.nodes.begin(), facet.nodes.end(), [&](Index n) { return keep(positions[n]); }))
      kept.push_back(facet);
  return kept;
}

/// The facets that do not lie in a mirror plane. `tolerance` in m.
template <class T>
std::vector<Facet> facets_off_planes(const std::vector<Facet> &facets, const std::vector<Vec3<T>> &positions,
                                     SymmetryPlanes planes, T tolerance) {
  std::vector<Facet> kept;
  const auto lies_in = [&](const Facet &facet, int axis) {
    return std::all_of(facet.nodes.begin(), facet.nodes.end(),
                       [&](Index n) { return std::abs(positions[n][axis]) <= tolerance; });
  };
  for (const Facet &facet : facets)
    if (!(planes.x && lies_in(facet, 0)) && !(planes.y && lies_in(facet, 1))) kept.push_back(facet);
  return kept;
}

/// The facets whose nodes lie on the cylinder of `radius` about the z axis. Lengths in m.
template <class T>
std::vector<Facet> facets_on_cylinder(const std::vector<Facet> &facets, const std::vector<Vec3<T>> &positions, T radius,
                                      T tolerance) {
  return facets_where(facets, positions,
                      [&](const Vec3<T> &p) { return std::abs(std::hypot(p[0], p[1]) - radius) <= tolerance; });
}

/// The facets with `node_offset` added to their nodes: from indices into a mesh to indices into Nodes.
inline std::vector<Facet> shifted(std::vector<Facet> facets, Index node_offset) {
  for (Facet &facet : facets)
    for (Index &n : facet.nodes) n += node_offset;
  return facets;
}

} // namespace ogive
