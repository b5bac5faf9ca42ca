// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/part_mesh.hpp"
#include "ogive/mesh/projectile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Bodies of revolution with surfaces within them: a core in a filler in a jacket, a tube, a cup. Every cross section
/// is an O-grid with more shells: its nodes lie on all surfaces, so that no hex has two metals. In front of an inner
/// surface and behind it its shell continues, closer to the axis where the body narrows. Nodes of surfaces lie a little
/// outside of the true circles, as those of projectile_mesh(): parts between frusta have exactly the analytic volume.

namespace ogive {

/// Most surfaces within a projectile: two metals within the jacket, or one and a bore.
inline constexpr std::size_t most_inner_surfaces = 2;

/// Names of the parts of a body with so many of them, from the outside in.
inline std::vector<std::string> nested_part_names(std::size_t parts) {
  if (parts == 2) return {"jacket", "core"};
  if (parts == 3) return {"jacket", "filler", "core"};
  return {"1"};
}

/// Names of the parts of a shape, from the outside in.
template <class T> std::vector<std::string> part_names(const ProjectileShape<T> &s) {
  return nested_part_names(s.inner.size() + (s.is_hollow ? 0 : 1));
}

/// Volumes of the parts, m3, from the outside in.
template <class T> std::vector<T> part_volumes(const ProjectileShape<T> &s) {
  std::vector<T> volumes;
  T outer = outer_volume(s);
  for (auto surface = s.inner.rbegin(); surface != s.inner.rend(); ++surface) {
    volumes.push_back(outer - volume(*surface));
    outer = volume(*surface);
  }
  if (!s.is_hollow) volumes.push_back(outer);
  return volumes;
}

/// A surface of constant radius from the depth `depth` (m) before the rear end of a body of this length (m) to that
/// end.
template <class T> Profile<T> bore(T radius, T depth, T length) {
  return {{std::max(T(0), length - depth), radius}, {length, radius}};
}

/// Radii of all surfaces at the distance z (m) behind the tip, from the inside out, the outer surface last, m.
template <class T> std::vector<T> surface_radii(const ProjectileShape<T> &s, T z) {
  std::vector<T> radii(s.inner.size() + 1);
  radii.back() = radius_at(s, z);
  for (std::size_t j = s.inner.size(); j-- > 0;) {
    const Profile<T> &surface = s.inner[j];
    const bool is_there = z >= surface.front().z && z <= surface.back().z;
    radii[j] = is_there ? radius_at(surface, z) : std::min(radius_at(surface, z), T(0.7) * radii[j + 1]);
  }
  return radii;
}

/// Throws SetupError unless the surfaces within a shape are profiles, each within the next one and within the shape.
template <class T> void check_inner(const ProjectileShape<T> &s) {
  const bool has_nose = s.nose == Nose::blunt || s.nose == Nose::conical || s.nose == Nose::ogival;
  require(has_nose || s.nose == Nose::profile, "nose of a projectile with parts or a bore", name(s.nose),
          "must be blunt, conical, ogival or profile");
  require(s.edge_radius == T(0), "edge radius (m)", s.edge_radius, "must be 0 of a projectile with parts or a bore");
  require(s.inner.size() <= most_inner_surfaces, "surfaces within the projectile", s.inner.size(),
          "must be at most " + std::to_string(most_inner_surfaces));
  for (std::size_t j = 0; j < s.inner.size(); ++j) {
    const Profile<T> &surface = s.inner[j];
    check(surface);
    const std::string thing = " of inner surface " + std::to_string(j + 1) + " (m)";
    require(surface.front().z >= T(0), "first z" + thing, surface.front().z, "must not be negative");
    require(surface.back().z <= length(s) * (T(1) + T(1e-9)), "last z" + thing, surface.back().z,
            "must be at most the length, " + std::to_string(length(s)));
    std::vector<T> places;
    for (const auto &point : surface) places.push_back(point.z);
    if (j + 1 < s.inner.size())
      for (const auto &point : s.inner[j + 1])
        if (point.z > surface.front().z && point.z < surface.back().z) places.push_back(point.z);
    if (s.nose == Nose::profile)
      for (const auto &point : s.profile)
        if (point.z > surface.front().z && point.z < surface.back().z) places.push_back(point.z);
    for (const T z : places) {
      const T within = surface_radii(s, z)[j + 1];
      require(radius_at(surface, z) <= T(0.98) * within, "radius at z = " + std::to_string(z) + " m" + thing,
              radius_at(surface, z), "must be at most 0.98 of the surface around it, " + std::to_string(within));
    }
  }
}

namespace nested_detail {

/// Positions of the nodes of a nested mesh along the axis, m: the ends of all surfaces, and kinks that are not close to
/// them.
template <class T> std::vector<T> places_of(const ProjectileShape<T> &s, T least_distance) {
  std::vector<T> places = {T(0), length(s)}, kinks_there;
  for (const Profile<T> &surface : s.inner) {
    places.push_back(surface.front().z), places.push_back(std::min(surface.back().z, length(s)));
    const auto own = kinks(surface, least_distance);
    kinks_there.insert(kinks_there.end(), own.begin(), own.end());
  }
  if (s.nose == Nose::profile) {
    const auto own = kinks(s.profile, least_distance);
    kinks_there.insert(kinks_there.end(), own.begin(), own.end());
  } else {
    if (nose_height(s) > T(0)) places.push_back(nose_height(s));
    if (s.tail_length > T(0)) places.push_back(length(s) - s.tail_length);
  }
  for (const T kink : kinks_there)
    if (std::all_of(places.begin(), places.end(), [&](T z) { return std::abs(z - kink) >= least_distance; }))
      places.push_back(kink);
  std::sort(places.begin(), places.end());
  std::vector<T> apart = {places.front()};
  for (const T z : places)
    if (z - apart.back() > T(1e-6) * length(s)) apart.push_back(z);
  apart.back() = length(s);
  return apart;
}

} // namespace nested_detail

/// Mesh of a projectile with surfaces within it, for plates with the particle distance `spacing` (m). Throws SetupError
/// for a dimension out of range, for badly shaped hexes, and if they lack the volume of the shape.
template <class T> PartMesh<T> nested_mesh(const ProjectileShape<T> &shape, T spacing, Extent extent) {
  check(shape), check_inner(shape);
  require(spacing > T(0) && spacing <= shape.diameter / T(4), "particle distance (m)", spacing,
          "must be positive and at most a quarter of the projectile's diameter");
  constexpr T eighth_turn = std::numbers::pi_v<T> / T(4);
  const T radius = shape.diameter / T(2);
  const bool sharp = radius_at(shape, T(0)) < T(0.5) * radius;
  const std::size_t surfaces = shape.inner.size() + 1;

  const T longest = std::max(shape.diameter / T(6), T(2) * spacing);
  const std::vector<T> stations =
      stretched_stations(nested_detail::places_of(shape, T(0.5) * spacing), sharp ? spacing : T(1.5) * spacing,
                         T(2) * spacing, longest, nose_height(shape));
  std::vector<std::vector<T>> radii;
  std::vector<T> thickest(surfaces, T(0));
  for (const T z : stations) {
    radii.push_back(surface_radii(shape, z));
    for (std::size_t j = 1; j < surfaces; ++j)
      thickest[j] = std::max(thickest[j], radii.back()[j] - radii.back()[j - 1]);
  }

  const auto at_least = [](Index least, T value) { return std::max(least, static_cast<Index>(std::lround(value))); };
  const T edge = T(1.8) * spacing;
  OGridCounts n;
  n.core = at_least(sharp ? 2 : 3, eighth_turn * radius / (sharp ? T(1.6) * edge : edge));
  n.along = static_cast<Index>(stations.size()) - 1;
  // Shells up to each surface, from the inside out. A wall around a bore bends: with one hex it would have no
  // stiffness.
  std::vector<Index> shells = {at_least(1, T(0.5) * T(n.core))};
  for (std::size_t j = 1; j < surfaces; ++j)
    shells.push_back(shells.back() + at_least(shape.is_hollow ? 2 : 1, thickest[j] / edge));
  n.shell = shells.back();

  const CoreOutline<T> core{T(0.62), T(0.78), T(1)};
  const T polygon_angle = eighth_turn / T(n.core), outward = std::sqrt(polygon_angle / std::sin(polygon_angle));
  const auto fraction = [&](Index i) { return T(i) / T(n.core); };
  Index level = 0; // of the last node on the surface, for the shells below it
  const auto on_surface = [&](Index i, Index j, Index k) -> Vec3<T> {
    level = k;
    const Vec3<T> direction = outward * surface_direction(fraction(i), fraction(j), T(0));
    return {radii[k].back() * direction[0], radii[k].back() * direction[1], stations[k]};
  };
  const auto in_shell = [&](const Vec3<T> &inner, const Vec3<T> &outer, Index l) -> Vec3<T> {
    const auto on = [&](std::size_t j) -> Vec3<T> {
      const T share = radii[level][j] / radii[level].back();
      return {share * outer[0], share * outer[1], outer[2]};
    };
    std::size_t j = 0;
    while (l > shells[j]) ++j;
    const Vec3<T> low = j == 0 ? inner : on(j - 1), high = on(j);
    const Index before = j == 0 ? 0 : shells[j - 1];
    return low + T(l - before) / T(shells[j] - before) * (high - low);
  };
  PartMesh<T> quarter;
  quarter.mesh = o_grid<T>(
      n,
      [&](Index i, Index j, Index k) -> Vec3<T> {
        const Vec3<T> unit = core_point(core, fraction(i), fraction(j), T(0));
        return {radii[k].front() * unit[0], radii[k].front() * unit[1], stations[k]};
      },
      on_surface, in_shell);

  // The region of a hex: within how many surfaces, from the inside out, in the order in which o_grid() makes hexes.
  std::vector<std::size_t> regions;
  const auto region_of = [&](std::size_t within, Index k) {
    const T z = T(0.5) * (stations[k] + stations[k + 1]);
    std::size_t j = within;
    while (j < shape.inner.size() && !(z > shape.inner[j].front().z && z < shape.inner[j].back().z)) ++j;
    return j;
  };
  for (Index k = 0; k < n.along; ++k) {
    regions.insert(regions.end(), static_cast<std::size_t>(n.core) * static_cast<std::size_t>(n.core), region_of(0, k));
    for (Index s = 0; s < n.core; ++s) {
      std::size_t j = 0;
      for (Index l = 0; l < n.shell; ++l) {
        while (l >= shells[j]) ++j;
        regions.insert(regions.end(), 2, region_of(j, k));
      }
    }
  }
  quarter.parts = part_names(shape);
  for (const std::size_t region : regions)
    quarter.part_of.push_back(std::min(shape.inner.size() - region, quarter.parts.size() - 1));
  if (shape.is_hollow) quarter = without_hexes(quarter, [&](Index e) { return regions[e] == 0; });
  check_quality(quarter.mesh, shape);
  PartMesh<T> body = extended(quarter, extent);
  check_mesh(body.mesh, "projectile with parts");
  return body;
}

} // namespace ogive
