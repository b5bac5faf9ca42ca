// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/hex_mesh.hpp"
#include "ogive/mesh/mesh_check.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ogive {

/// Connection of the parts of a body where they meet.
enum class Parts {
  tied,    ///< they share nodes, and deform together
  touching ///< each has nodes of its own: they slide on each other, and may come apart
};

/// A mesh of a body of several parts, which share the nodes where they meet unless they are separated().
template <class T> struct PartMesh {
  HexMesh<T> mesh;                                  ///< of all parts
  std::vector<std::size_t> part_of{};               ///< of each hex, its place in `parts`; empty: all are of the first
  std::vector<std::string> parts{std::string("1")}; ///< names
};

/// The hexes of one part, with the nodes of all.
template <class T> HexMesh<T> mesh_of_part(const PartMesh<T> &body, std::size_t part) {
  if (body.part_of.empty()) return body.mesh;
  HexMesh<T> mesh{body.mesh.positions, {}};
  for (std::size_t e = 0; e < body.part_of.size(); ++e)
    if (body.part_of[e] == part) mesh.hexes.push_back(body.mesh.hexes[e]);
  return mesh;
}

/// Facets of the whole mesh with the numbers that their hexes have in their parts, see mesh_of_part().
template <class T> std::vector<Facet> facets_of_parts(std::vector<Facet> facets, const PartMesh<T> &body) {
  if (body.part_of.empty()) return facets;
  std::vector<Index> place, count(body.parts.size(), 0);
  for (const std::size_t part : body.part_of) place.push_back(count[part]++);
  for (Facet &facet : facets) facet.hex = place[facet.hex];
  return facets;
}

/// The body and its mirror image, see with_mirror_image() of a mesh.
template <class T> PartMesh<T> with_mirror_image(PartMesh<T> body, int axis) {
  body.mesh = with_mirror_image(body.mesh, axis);
  const std::vector<std::size_t> half = body.part_of;
  body.part_of.insert(body.part_of.end(), half.begin(), half.end());
  return body;
}

/// A quarter (x >= 0, y >= 0) as a quarter, a half (y >= 0) or a full body.
template <class T> PartMesh<T> extended(const PartMesh<T> &quarter, Extent extent) {
  if (extent == Extent::quarter) return quarter;
  const PartMesh<T> half = with_mirror_image(quarter, 0);
  return extent == Extent::half ? half : with_mirror_image(half, 1);
}

/// The body without the hexes for which `is_gone(e)`, and without nodes that no other hex has; the rest keeps its
/// order.
template <class T, class F> PartMesh<T> without_hexes(const PartMesh<T> &body, F &&is_gone) {
  PartMesh<T> rest;
  rest.parts = body.parts;
  std::vector<Index> place(body.mesh.positions.size(), -1);
  for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) {
    if (is_gone(static_cast<Index>(e))) continue;
    rest.mesh.hexes.push_back(body.mesh.hexes[e]);
    if (!body.part_of.empty()) rest.part_of.push_back(body.part_of[e]);
    for (const Index n : body.mesh.hexes[e]) place[n] = 0;
  }
  for (std::size_t n = 0; n < place.size(); ++n) {
    if (place[n] < 0) continue;
    place[n] = static_cast<Index>(rest.mesh.positions.size());
    rest.mesh.positions.push_back(body.mesh.positions[n]);
  }
  for (auto &hex : rest.mesh.hexes)
    for (Index &n : hex) n = place[n];
  return rest;
}

/// The body with nodes of its own for each part: nodes that parts share are there once for each of them. Nodes are in
/// the order of the parts, and within a part in that of the body; hexes keep their order.
template <class T> PartMesh<T> separated(const PartMesh<T> &body) {
  if (body.part_of.empty()) return body;
  PartMesh<T> apart{{{}, body.mesh.hexes}, body.part_of, body.parts};
  for (std::size_t part = 0; part < body.parts.size(); ++part) {
    std::vector<Index> place(body.mesh.positions.size(), -1);
    for (std::size_t e = 0; e < body.part_of.size(); ++e)
      if (body.part_of[e] == part)
        for (const Index n : body.mesh.hexes[e]) place[n] = 0;
    for (std::size_t n = 0; n < place.size(); ++n) {
      if (place[n] < 0) continue;
      place[n] = static_cast<Index>(apart.mesh.positions.size());
      apart.mesh.positions.push_back(body.mesh.positions[n]);
    }
    for (std::size_t e = 0; e < body.part_of.size(); ++e)
      if (body.part_of[e] == part)
        for (Index &n : apart.mesh.hexes[e]) n = place[n];
  }
  return apart;
}

/// Exact volume of each part, m3.
template <class T> std::vector<T> part_volumes(const PartMesh<T> &body) {
  std::vector<T> volumes(body.parts.size(), T(0));
  for (Index e = 0; e < static_cast<Index>(body.mesh.hexes.size()); ++e)
    volumes[body.part_of.empty() ? 0 : body.part_of[e]] += hex_volume<T>(corners(body.mesh, e));
  return volumes;
}

} // namespace ogive
