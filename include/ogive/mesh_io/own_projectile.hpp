// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh_io/check_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// \file
/// A projectile from a mesh of its own: the quarter, half or whole that a model computes, its tip at z = 0.

namespace ogive {

/// A projectile with a mesh of its own, for one extent of the model.
struct OwnProjectile {
  PartMesh<double> body;         ///< of the computed part, m
  ProjectileShape<double> shape; ///< its sizes, with the nose Nose::mesh
};

namespace own_detail {

constexpr std::array<char, 2> axis_names = {'x', 'y'};

/// Smallest and largest coordinate along an axis, m.
inline std::pair<double, double> range_of(const std::vector<Vec3<double>> &positions, int axis) {
  std::pair<double, double> range{positions.front()[axis], positions.front()[axis]};
  for (const auto &x : positions) range = {std::min(range.first, x[axis]), std::max(range.second, x[axis])};
  return range;
}

/// Moves nodes that lie in the plane where the coordinate `axis` is zero, but for `tolerance` (m), into it.
inline void snap_to_plane(PartMesh<double> &body, int axis, double tolerance) {
  for (Vec3<double> &x : body.mesh.positions)
    if (std::abs(x[axis]) <= tolerance) x[axis] = 0;
}

/// Throws SetupError unless no hex lies on both sides of the plane and nodes, hexes and parts have their images.
inline void require_symmetric(const FileMesh &mesh, int axis, double tolerance) {
  const auto &positions = mesh.body.mesh.positions;
  const auto &hexes = mesh.body.mesh.hexes;
  const std::string plane = std::string(1, axis_names[axis]) + " = 0";
  const std::string need = ": the mesh must be symmetric about " + plane + ", or the model a full one";
  for (Index e = 0; e < static_cast<Index>(hexes.size()); ++e) {
    const auto on_side = [&](double sign) {
      return std::any_of(hexes[e].begin(), hexes[e].end(),
                         [&](Index n) { return sign * positions[n][axis] > tolerance; });
    };
    if (on_side(1) && on_side(-1))
      throw SetupError(hex_place(mesh, e) + ": straddles the plane " + plane + ": the mesh cannot be cut there");
  }
  const PlaceIndex index = index_of(positions, tolerance);
  std::vector<Index> image(positions.size());
  for (Index n = 0; n < static_cast<Index>(positions.size()); ++n) {
    Vec3<double> mirrored = positions[n];
    mirrored[axis] = -mirrored[axis];
    image[n] = std::abs(mirrored[axis]) <= tolerance ? n : point_at(index, mirrored);
    if (image[n] < 0) throw SetupError(node_place(mesh, n) + ": has no image at " + place_in_mm(mirrored) + need);
  }
  const auto key_of = [&](Index e, bool mirrored) {
    std::array<Index, 9> key{};
    for (std::size_t a = 0; a < 8; ++a) key[a] = mirrored ? image[hexes[e][a]] : hexes[e][a];
    std::sort(key.begin(), key.begin() + 8);
    key[8] = mesh.body.part_of.empty() ? 0 : static_cast<Index>(mesh.body.part_of[e]);
    return key;
  };
  std::set<std::array<Index, 9>> all;
  for (Index e = 0; e < static_cast<Index>(hexes.size()); ++e) all.insert(key_of(e, false));
  for (Index e = 0; e < static_cast<Index>(hexes.size()); ++e)
    if (!all.contains(key_of(e, true))) throw SetupError(hex_place(mesh, e) + ": has no image of the same part" + need);
}

/// The side of the plane with positive coordinates.
inline PartMesh<double> positive_side(const PartMesh<double> &body, int axis) {
  return without_hexes(body, [&](Index e) {
    double sum = 0;
    for (const Index n : body.mesh.hexes[e]) sum += body.mesh.positions[n][axis];
    return sum < 0;
  });
}

} // namespace own_detail

/// The computed part of a checked mesh: cut in the mirror planes of the extent that it lies on both sides of, mirrored
/// in those that it ends at and the extent does not have, and moved along z until its tip is at zero. The tip is the
/// end with the smallest z. Throws SetupError if one of its `pieces`, which share no nodes, is not symmetric where it
/// must be cut.
inline PartMesh<double> computed_part(const FileMesh &mesh, Extent extent, const std::vector<FileMesh> &pieces) {
  using namespace own_detail;
  const double tolerance = place_tolerance(mesh);
  const SymmetryPlanes planes = symmetry_planes(extent);
  PartMesh<double> body = mesh.body;
  std::array<bool, 2> is_cut{}, is_mirrored{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = range_of(mesh.body.mesh.positions, axis);
    const std::string name(1, axis_names[axis]);
    const bool one_sided = low >= -tolerance;
    if (high <= tolerance || low > tolerance)
      throw SetupError(printable(mesh.file) + ": lies at " + name + " = " + with_digits(1e3 * low, 6) + " to " +
                       with_digits(1e3 * high, 6) + " mm: must lie on both sides of " + name +
                       " = 0, or end there and lie where " + name + " is positive");
    const bool needs = axis == 0 ? planes.x : planes.y;
    is_mirrored[axis] = one_sided && !needs;
    is_cut[axis] = !one_sided && needs;
    if (one_sided || needs) snap_to_plane(body, axis, tolerance);
    for (const FileMesh &piece : pieces)
      if (is_cut[axis]) require_symmetric(piece, axis, tolerance);
  }
  for (int axis = 0; axis < 2; ++axis)
    if (is_cut[axis]) body = positive_side(body, axis);
  for (int axis = 0; axis < 2; ++axis)
    if (is_mirrored[axis]) body = with_mirror_image(body, axis);
  const double tip = range_of(body.mesh.positions, 2).first;
  for (Vec3<double> &x : body.mesh.positions) x[2] -= tip;
  return body;
}

/// The sizes of a projectile from the mesh of its computed part: its diameter is that of the smallest cylinder about
/// the z axis, its tip the nodes within a thousandth of the length of z = 0, its shoulder the foremost node within 1 %
/// of the largest radius. Throws SetupError unless its centre lies on the axis.
inline ProjectileShape<double> shape_of(const PartMesh<double> &body, Extent extent, const std::string &file) {
  double radius = 0, end = 0, tip = 0;
  const auto distance = [](const Vec3<double> &x) { return std::hypot(x[0], x[1]); };
  for (const auto &x : body.mesh.positions) radius = std::max(radius, distance(x)), end = std::max(end, x[2]);
  double shoulder = end;
  for (const auto &x : body.mesh.positions) {
    if (distance(x) >= 0.99 * radius) shoulder = std::min(shoulder, x[2]);
    if (x[2] <= 1e-3 * end) tip = std::max(tip, distance(x));
  }
  const SymmetryPlanes planes = symmetry_planes(extent);
  double whole = 0;
  Vec3<double> centre = Vec3<double>::Zero();
  for (Index e = 0; e < static_cast<Index>(body.mesh.hexes.size()); ++e) {
    const Corners<double> x = corners(body.mesh, e);
    const double part = hex_volume<double>(x);
    whole += part, centre += part * Vec3<double>(x.colwise().mean().transpose());
  }
  centre /= whole;
  for (int axis = 0; axis < 2; ++axis)
    if (!(axis == 0 ? planes.x : planes.y) && std::abs(centre[axis]) > 0.1 * radius)
      throw SetupError(printable(file) + ": centre of volume at " + own_detail::axis_names[axis] + " = " +
                       with_digits(1e3 * centre[axis], 6) + " mm: must lie on the z axis, the line of flight");
  ProjectileShape<double> shape{Nose::mesh, 2 * radius};
  shape.nose_length = shoulder, shape.shank_length = end - shoulder, shape.tip_diameter = 2 * tip;
  shape.mesh_volume = planes.copies() * whole;
  return shape;
}

/// A projectile from a mesh of a file, for an extent of the model. Throws SetupError, one line, if the mesh is not one
/// closed body of well-shaped hexes, or cannot be cut as the extent needs it. Parts that touch are one such body each:
/// they may have nodes of their own where they meet, or share them.
inline OwnProjectile own_projectile(const FileMesh &mesh, Extent extent, Parts parts = Parts::tied) {
  std::vector<FileMesh> pieces;
  if (parts == Parts::touching)
    for (std::size_t k = 0; k < mesh.body.parts.size(); ++k) pieces.push_back(part_of_mesh(mesh, k));
  else
    pieces.push_back(mesh);
  for (const FileMesh &piece : pieces) check(piece);
  PartMesh<double> body = computed_part(mesh, extent, pieces);
  ProjectileShape<double> shape = shape_of(body, extent, mesh.file);
  return {std::move(body), std::move(shape)};
}

} // namespace ogive
