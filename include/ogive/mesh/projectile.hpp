// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/facets.hpp"
#include "ogive/mesh/grading.hpp"
#include "ogive/mesh/hex_mesh.hpp"
#include "ogive/mesh/mesh_check.hpp"
#include "ogive/mesh/o_grid.hpp"
#include "ogive/mesh/projectile_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Hex meshes of projectiles, tip at z = 0, body at z > 0. Every cross section is an O-grid.
///
/// Blunt: hexes of 1.35 to 1.95 times the particle distance in the cross section (1.8 along the rim, which is sharp), a
/// little less in the four corners of the core; along the axis 1.5 times the particle distance at the face and growing
/// to a sixth of the diameter towards the tail: finer ones would set the time step. A rounded edge is one facet at 45
/// degrees that cuts off the same volume; it stays within 0.06 edge radii of the arc. Conical and ogival: the cross
/// section shrinks with the nose down to the flat tip, with fewer hexes across (3.2 times the particle distance along
/// the shank's circumference, 2.8 times along its radius) because they all meet at the tip; see raise_time_step for the
/// thin ones there. Hemispherical: the shell of the O-grid wraps around the front (a cubed sphere) with hexes of 1.4
/// times the particle distance along the surface, none of them thin. A sphere is two of those. A chisel is a blunt
/// projectile whose front is pushed back; a profile scales the cross section as sharp noses do, with nodes at its
/// kinks.
///
/// Surface nodes lie a little outside of the true circle, such that the polygon has the circle's area: shank and cone
/// have exactly the analytic volume.

namespace ogive {

/// Outline of the O-grid's core as fractions of the radius: half its width, half its diagonal in the cross section,
/// half its diagonal in space (where the shell wraps around it). Its sides bulge, so that the hexes at its corners stay
/// well shaped. The values in use give about the largest stable step.
template <class T> struct CoreOutline {
  T side{};           ///< half its width
  T diagonal{};       ///< half its diagonal in the cross section
  T space_diagonal{}; ///< half its diagonal in space
};

/// Point of the bulged unit core at the fractions p, q (cross section) and w (towards a wrapped front), in radii.
template <class T> Vec3<T> core_point(const CoreOutline<T> &core, T p, T q, T w) {
  const T edge = core.side - core.diagonal / std::sqrt(T(2));
  const T corner = core.space_diagonal / std::sqrt(T(3)) - core.side + T(2) * edge;
  const auto along = [&](T t, T u, T v) { return t * (core.side - edge * (u * u + v * v) + corner * u * u * v * v); };
  return {along(p, q, w), along(q, p, w), along(w, p, q)};
}

/// Direction in which a point of the core's side or front is projected on the surface: equal angles on a cubed sphere.
template <class T> Vec3<T> surface_direction(T p, T q, T w) {
  constexpr T eighth_turn = std::numbers::pi_v<T> / T(4);
  const auto tangent = [&](T t) { return t == T(1) ? T(1) : std::tan(eighth_turn * t); };
  const Vec3<T> d(tangent(p), tangent(q), tangent(w));
  return d / d.norm();
}

/// Length of face and of shank that a facet at 45 degrees cuts off with as much volume as the rounded edge, m.
template <class T> T edge_cut(const ProjectileShape<T> &s) {
  T cut = T(0);
  // R c^2 - c^3/3 = edge_loss: contracts by about c/(6 R) < 1/36 each time.
  for (int k = 0; k < 12; ++k) cut = std::sqrt(edge_loss(s) / (s.diameter / T(2) - cut / T(3)));
  return cut;
}

/// Smallest scaled Jacobian that a projectile's hexes may have. The noses have 0.5 and more.
inline constexpr double least_projectile_jacobian = 0.2;

/// Largest difference between the volumes of a mesh and of the shape it is made for, over the latter. Facets for curved
/// noses cost 0.7 % where hexes are coarsest.
inline constexpr double largest_volume_error = 0.02;

/// Stations (m) along a body from the tip on: in each stretch between two of the `places` (m) they begin as far apart
/// as they were before, `first` (m) in front, and grow by a tenth up to `fine` (m) as far as `shoulder` (m) and
/// `longest` (m) behind it.
template <class T>
std::vector<T> stretched_stations(const std::vector<T> &places, T first, T fine, T longest, T shoulder) {
  std::vector<T> stations = {places.front()};
  for (std::size_t k = 1; k < places.size(); ++k) {
    const T begin = places[k - 1];
    const auto stretch =
        graded_stations(places[k] - begin, first, T(1.1), places[k] <= shoulder ? std::max(first, fine) : longest);
    for (std::size_t s = 1; s < stretch.size(); ++s) stations.push_back(begin + stretch[s]);
    stations.back() = places[k];
    first = std::clamp(stations.back() - stations[stations.size() - 2], T(0.5) * first, longest);
  }
  return stations;
}

/// A sphere of two halves: the mesh of the front one, whose nodes with z = `middle` (m) are its rear end, and its
/// image.
template <class T> HexMesh<T> with_rear_half(HexMesh<T> half, T middle) {
  for (Vec3<T> &p : half.positions) p[2] -= middle;
  HexMesh<T> whole = with_mirror_image(half, 2);
  for (Vec3<T> &p : whole.positions) p[2] += middle;
  return whole;
}

/// Pushes the front of a blunt projectile's mesh back to that of a chisel; hexes along the whole length take part.
template <class T> void push_back_front(HexMesh<T> &mesh, const ProjectileShape<T> &shape) {
  const T whole = length(shape);
  for (Vec3<T> &p : mesh.positions) p[2] += chisel_depth(shape, p[0]) * (T(1) - p[2] / whole);
}

/// Throws SetupError for hexes that are badly shaped and for a mesh without the volume of its shape.
template <class T> void check_quality(const HexMesh<T> &quarter, const ProjectileShape<T> &shape) {
  const T least = mesh_quality(quarter).smallest_scaled_jacobian;
  require(least >= T(least_projectile_jacobian), "smallest scaled Jacobian of the projectile's hexes", least,
          "must be at least " + std::to_string(least_projectile_jacobian) +
              ": a finer particle distance, or a shape with gentler slopes");
  const T ratio = T(4) * volume(quarter) / volume(shape);
  require(std::abs(ratio - T(1)) <= T(largest_volume_error), "volume of the projectile's hexes over that of its shape",
          ratio, "must be 1 within " + std::to_string(largest_volume_error) + ": a finer particle distance");
}

/// Mesh of a projectile for plates with the particle distance `spacing` (m). Throws SetupError for a dimension out of
/// range, for hexes that would be inverted or badly shaped, and if they lack the volume of the shape.
template <class T> HexMesh<T> projectile_mesh(const ProjectileShape<T> &shape, T spacing, Extent extent) {
  check(shape);
  require(spacing > T(0) && spacing <= shape.diameter / T(4), "particle distance (m)", spacing,
          "must be positive and at most a quarter of the projectile's diameter");
  constexpr T eighth_turn = std::numbers::pi_v<T> / T(4);
  const T radius = shape.diameter / T(2), height = shape.nose == Nose::sphere ? radius : nose_height(shape);
  const bool wraps = shape.nose == Nose::hemispherical || shape.nose == Nose::sphere;
  const bool has_profile = shape.nose == Nose::profile;
  const bool sharp = shape.nose == Nose::conical || shape.nose == Nose::ogival ||
                     (has_profile && shape.profile.front().radius < radius / T(2));

  OGridCounts n;
  const auto at_least = [](Index least, T value) { return std::max(least, static_cast<Index>(std::lround(value))); };
  const T edge = spacing * (sharp ? T(3.2) : wraps ? T(1.4) : T(1.8));
  n.core = at_least(sharp ? 2 : 3, eighth_turn * radius / edge);
  n.shell = at_least(2, (sharp ? T(0.6) : wraps ? T(0.45) : T(0.55)) * T(n.core));
  n.covers_front = wraps;

  const T polygon_angle = eighth_turn / T(n.core);
  const T outward = std::sqrt(polygon_angle / std::sin(polygon_angle));

  // Stations of the core: the nose's, then the shank's. In a wrapped nose they follow from the core's shape, and the
  // surface nodes, moved outward, put the tip at zero.
  const T shoulder = wraps ? outward * height : height;
  std::vector<T> stations = {T(0)};
  if (sharp && !has_profile) stations = graded_stations(height, spacing, T(1.1), T(2) * spacing);
  const Index nose_levels = wraps ? n.core : static_cast<Index>(stations.size()) - 1;
  if (wraps) stations.assign(nose_levels + 1, shoulder);
  const T longest = std::max(shape.diameter / T(6), T(2) * spacing);
  const T first = (sharp ? T(2) : wraps ? T(1) : T(1.5)) * spacing;
  if (has_profile) {
    stations = stretched_stations(kinks(shape.profile, T(0.5) * spacing), sharp ? spacing : first, T(2) * spacing,
                                  longest, height);
  } else if (shape.nose != Nose::sphere) {
    const bool is_chisel = shape.nose == Nose::chisel;
    const T straight = (is_chisel ? length(shape) : shape.shank_length) - shape.tail_length;
    const T from = is_chisel ? T(0) : shoulder;
    const auto shank = graded_stations(straight, first, T(1.1), longest);
    for (std::size_t k = 1; k < shank.size(); ++k) stations.push_back(from + shank[k]);
    if (shape.tail_length > T(0))
      for (const T z : graded_stations(shape.tail_length, std::min(longest, shape.tail_length), T(1), longest))
        if (z > T(0)) stations.push_back(from + straight + z);
  }
  n.along = static_cast<Index>(stations.size()) - 1;
  const T cut = edge_cut(shape);
  require(cut <= (n.along > 1 ? stations[1] : T(0)), "edge radius (m)", shape.edge_radius,
          "must be at most twice the particle distance, and 0 if the projectile is one hex long: one facet rounds it");

  const CoreOutline<T> core =
      wraps ? CoreOutline<T>{T(0.52), T(0.73), T(0.80)} : CoreOutline<T>{T(0.62), T(0.78), T(1)};
  const auto fraction = [&](Index i) { return T(i) / T(n.core); };
  const auto front_fraction = [&](Index k) { return wraps && k < nose_levels ? T(1) - T(k) / T(nose_levels) : T(0); };
  const auto scale_at = [&](Index k) {
    if (sharp || has_profile) return radius_at(shape, stations[k]);
    const T before = stations.back() - stations[k];
    return before < shape.tail_length ? radius_at(shape, length(shape) - before) : radius;
  };
  const auto placed = [&](const Vec3<T> &unit, Index k) {
    const T scale = scale_at(k);
    return Vec3<T>(scale * unit[0], scale * unit[1], stations[k] - scale * unit[2]);
  };
  const auto on_surface = [&](Index i, Index j, Index k) -> Vec3<T> {
    Vec3<T> point = placed(outward * surface_direction(fraction(i), fraction(j), front_fraction(k)), k);
    if (cut > T(0) && k == 0) point.template head<2>() *= T(1) - cut / radius;
    if (cut > T(0) && k == 1) point[2] = cut;
    return point;
  };
  HexMesh<T> quarter = o_grid<T>(
      n,
      [&](Index i, Index j, Index k) {
        return placed(core_point(core, fraction(i), fraction(j), front_fraction(k)), k);
      },
      on_surface);
  if (shape.nose == Nose::sphere) quarter = with_rear_half(std::move(quarter), shoulder);
  if (shape.nose == Nose::chisel) push_back_front(quarter, shape);
  HexMesh<T> mesh = extended(quarter, extent);
  check_mesh(mesh, std::string(name(shape.nose)) + " projectile");
  check_quality(quarter, shape);
  return mesh;
}

/// The outer surface of a projectile mesh, tail included, without the mirror planes of the extent.
template <class T> std::vector<Facet> contact_facets(const HexMesh<T> &mesh, Extent extent) {
  return facets_off_planes(boundary_facets(mesh), mesh.positions, symmetry_planes(extent), T(0));
}

} // namespace ogive
