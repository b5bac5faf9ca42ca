// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/facets.hpp"
#include "ogive/mesh/projectile.hpp"
#include "ogive/mesh_io/file_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// \file
/// Whether a mesh of a file is one closed body of well-shaped hexes. All checks throw SetupError with file, hex or
/// node, value and what is allowed.

namespace ogive {

/// Finds the point at a place, up to a tolerance, in constant time.
struct PlaceIndex {
  double tolerance = 0;                                       ///< m, in each coordinate
  const std::vector<Vec3<double>> *points = nullptr;          ///< m
  std::unordered_map<std::uint64_t, std::vector<Index>> in{}; ///< the points of each cell, by its hash
};

namespace place_detail {

/// Hash of the cell with these numbers.
inline std::uint64_t hash_of(std::int64_t i, std::int64_t j, std::int64_t k) {
  std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
  for (const std::int64_t n : {i, j, k}) {
    hash ^= static_cast<std::uint64_t>(n);
    hash *= 0xff51afd7ed558ccdULL;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Number of the cell, four tolerances wide, that a coordinate lies in.
inline std::int64_t cell_of(double coordinate, double tolerance) {
  return static_cast<std::int64_t>(std::floor(coordinate / (4 * tolerance)));
}

} // namespace place_detail

/// An index of points (m), which must outlive it. They must be less than 1e12 tolerances from the origin.
inline PlaceIndex index_of(const std::vector<Vec3<double>> &points, double tolerance) {
  PlaceIndex index{tolerance, &points};
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Vec3<double> &x = points[n];
    const auto cell = [&](int d) { return place_detail::cell_of(x[d], tolerance); };
    index.in[place_detail::hash_of(cell(0), cell(1), cell(2))].push_back(static_cast<Index>(n));
  }
  return index;
}

/// The first point at this place but `other`, or -1.
inline Index point_at(const PlaceIndex &index, const Vec3<double> &x, Index other = -1) {
  Index first = -1;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<std::int64_t, 3> cell{};
    for (int d = 0; d < 3; ++d)
      cell[d] =
          place_detail::cell_of(x[d] + ((corner >> d & 1) != 0 ? index.tolerance : -index.tolerance), index.tolerance);
    const auto found = index.in.find(place_detail::hash_of(cell[0], cell[1], cell[2]));
    if (found == index.in.end()) continue;
    for (const Index n : found->second)
      if (n != other && (first < 0 || n < first) && ((*index.points)[n] - x).cwiseAbs().maxCoeff() <= index.tolerance)
        first = n;
  }
  return first;
}

/// Diagonal of the box around all nodes, m.
inline double width_of(const FileMesh &mesh) {
  Vec3<double> low = mesh.body.mesh.positions.front(), high = low;
  for (const Vec3<double> &x : mesh.body.mesh.positions) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return (high - low).norm();
}

/// Distance over which nodes count as at the same place, or as in a mirror plane, m: a hundred-thousandth of the mesh.
inline double place_tolerance(const FileMesh &mesh) { return 1e-5 * width_of(mesh); }

/// "(1, 2, 3) mm", of a position in m.
inline std::string place_in_mm(const Vec3<double> &x) {
  return "(" + with_digits(1e3 * x[0], 6) + ", " + with_digits(1e3 * x[1], 6) + ", " + with_digits(1e3 * x[2], 6) +
         ") mm";
}

/// Refuses hexes that are inverted or badly shaped.
inline void check_shapes(const FileMesh &mesh) {
  for (Index e = 0; e < static_cast<Index>(mesh.body.mesh.hexes.size()); ++e) {
    const Corners<double> x = corners(mesh.body.mesh, e);
    const auto refuse = [&](const std::string &what) { throw SetupError(hex_place(mesh, e) + ": " + what); };
    const double smallest = smallest_corner_jacobian<double>(x), scaled = scaled_jacobian<double>(x);
    if (!(smallest > 0) || !(hex_volume<double>(x) > 0))
      refuse("is inverted, the smallest Jacobian of its corners = " + with_digits(8e9 * smallest, 3) +
             " mm3: must be positive; nodes 1 to 4 are the lower face, counter-clockwise seen from nodes 5 to 8 above");
    if (!(scaled >= least_projectile_jacobian))
      refuse("scaled Jacobian = " + with_digits(scaled, 3) + ": must be at least " +
             shortest(least_projectile_jacobian));
  }
}

/// Refuses nodes at the same place: the mesh would be open between them.
inline void check_nodes_apart(const FileMesh &mesh) {
  const auto &x = mesh.body.mesh.positions;
  const PlaceIndex index = index_of(x, place_tolerance(mesh));
  for (Index n = 0; n < static_cast<Index>(x.size()); ++n)
    if (const Index other = point_at(index, x[n], n); other >= 0)
      throw SetupError(node_place(mesh, n) + ": lies where node " + std::to_string(mesh.node_numbers[other]) +
                       " lies, at " + place_in_mm(x[n]) +
                       ": must be one node, tied parts share the nodes where they meet");
}

/// Refuses hexes that overlap or are not connected by faces.
inline void check_faces(const FileMesh &mesh) {
  const auto &hexes = mesh.body.mesh.hexes;
  std::vector<std::size_t> group(hexes.size());
  std::iota(group.begin(), group.end(), std::size_t(0));
  const auto root = [&](std::size_t e) {
    while (group[e] != e) e = group[e] = group[group[e]];
    return e;
  };
  const auto faces = sorted_faces(hexes);
  for (std::size_t i = 0, next = 0; i < faces.size(); i = next) {
    for (next = i + 1; next < faces.size() && faces[next].sorted == faces[i].sorted;) ++next;
    if (next == i + 1) continue;
    const std::size_t one = faces[i].place, two = faces[i + 1].place;
    const auto a = face_nodes(hexes[one / 6], one % 6), b = face_nodes(hexes[two / 6], two % 6);
    const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
    if (next > i + 2 || a[1] != b[(at + 3) % 4])
      throw SetupError(hex_place(mesh, static_cast<Index>(two / 6)) + ": overlaps hex " +
                       std::to_string(mesh.hex_numbers[one / 6]) +
                       ": a face may belong to two hexes, one on each side");
    group[std::max(root(one / 6), root(two / 6))] = std::min(root(one / 6), root(two / 6));
  }
  for (std::size_t e = 0; e < hexes.size(); ++e)
    if (root(e) != 0)
      throw SetupError(hex_place(mesh, static_cast<Index>(e)) + ": is not connected to hex " +
                       std::to_string(mesh.hex_numbers[0]) + ": all hexes must be one body, connected by faces");
}

/// Refuses a surface that is not closed: each edge must belong to two facets of it.
inline void check_surface(const FileMesh &mesh) {
  struct Edge {
    Index low, high, hex;
    bool operator<(const Edge &other) const { return std::pair(low, high) < std::pair(other.low, other.high); }
  };
  std::vector<Edge> edges;
  for (const Facet &facet : boundary_facets(mesh.body.mesh))
    for (std::size_t k = 0; k < 4; ++k) {
      const Index a = facet.nodes[k], b = facet.nodes[(k + 1) % 4];
      edges.push_back({std::min(a, b), std::max(a, b), facet.hex});
    }
  std::stable_sort(edges.begin(), edges.end());
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    for (next = i + 1; next < edges.size() && !(edges[i] < edges[next]);) ++next;
    if (next != i + 2)
      throw SetupError(hex_place(mesh, edges[i].hex) + ": its edge between nodes " +
                       std::to_string(mesh.node_numbers[edges[i].low]) + " and " +
                       std::to_string(mesh.node_numbers[edges[i].high]) + " belongs to " + std::to_string(next - i) +
                       " faces of the surface: must be 2, a closed surface");
  }
}

/// Refuses a mesh that is so small and so far from the origin that its coordinates have few digits.
inline void check_place(const FileMesh &mesh) {
  double farthest = 0;
  for (const Vec3<double> &x : mesh.body.mesh.positions) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  if (!(width_of(mesh) >= 1e-6 * farthest))
    throw SetupError(printable(mesh.file) + ": width = " + with_digits(1e3 * width_of(mesh), 3) +
                     " mm: must be at least a millionth of the distance from the origin, " +
                     with_digits(1e3 * farthest, 3) + " mm");
}

/// All checks of a mesh as one closed body.
inline void check(const FileMesh &mesh) {
  check_place(mesh);
  check_shapes(mesh);
  check_nodes_apart(mesh);
  check_faces(mesh);
  check_surface(mesh);
}

} // namespace ogive
