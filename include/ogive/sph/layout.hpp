// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/search/columns.hpp"
#include "ogive/sph/body.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

namespace ogive {

/// A round disc of particles between z = 0 and z = -thickness.
template <class T> struct DiscShape {
  T radius{};    ///< m
  T thickness{}; ///< m
  T spacing{};   ///< target particle distance, m
};

/// Whole number of layers nearest to thickness / spacing, at least 1.
template <class T> Index layer_count(T thickness, T spacing) {
  return std::max(Index(1), static_cast<Index>(std::lround(thickness / spacing)));
}

/// Throws SetupError unless radius, thickness and spacing are positive and the spacing at most half the thickness.
template <class T> void check(const DiscShape<T> &disc) {
  const auto good = [](T v) { return std::isfinite(v) && v > T(0); };
  require(good(disc.radius), "disc radius (m)", disc.radius, "must be positive");
  require(good(disc.thickness), "disc thickness (m)", disc.thickness, "must be positive");
  require(good(disc.spacing) && disc.spacing <= T(0.5) * disc.thickness, "particle distance (m)", disc.spacing,
          "must be positive and at most half the thickness");
}

/// Sorts particles into columns, as neighbour lists do: particles that are near each other in memory and in lists.
template <class T> void sort_by_columns(ParticleLayout<T> &layout) {
  const std::span<const Vec3<T>> positions(layout.positions);
  const Columns<T> columns = sort_into_columns(positions, column_width(layout.spacing));
  ParticleLayout<T> sorted{layout.spacing, {}, {}};
  for (std::size_t k = 0; k < columns.order.size(); ++k) {
    const Index i = columns.order[k];
    if (k > 0 && i == columns.order[k - 1]) continue; // fills a cluster
    sorted.positions.push_back(layout.positions[i]);
    sorted.volumes.push_back(layout.volumes[i]);
  }
  layout = std::move(sorted);
}

/// Simple cubic lattice cut at the radius; the mirror planes lie midway between particles. A thickness that the spacing
/// does not divide gets the nearest whole number of layers, and the spacing follows from it.
template <class T> ParticleLayout<T> cubic_disc(const DiscShape<T> &disc, Extent extent) {
  check(disc);
  const Index layers = layer_count(disc.thickness, disc.spacing);
  ParticleLayout<T> layout;
  const T s = layout.spacing = disc.thickness / T(layers);
  const Index reach = static_cast<Index>(disc.radius / s) + 1;
  const SymmetryPlanes planes = symmetry_planes(extent);
  for (Index k = 0; k < layers; ++k)
    for (Index j = planes.y ? 0 : -reach; j < reach; ++j)
      for (Index i = planes.x ? 0 : -reach; i < reach; ++i) {
        const T x = (T(i) + T(0.5)) * s, y = (T(j) + T(0.5)) * s;
        if (x * x + y * y >= disc.radius * disc.radius) continue;
        layout.positions.push_back({x, y, -(T(k) + T(0.5)) * s});
        layout.volumes.push_back(s * s * s);
      }
  sort_by_columns(layout);
  return layout;
}

/// Concentric rings, each with a whole number of particles of nearly equal distance; volumes follow from the ring's
/// area. Every second layer has one ring more and one particle more in each quarter of a ring, so that particles form
/// neither columns nor cylinders along which the plate would part too easily.
template <class T> ParticleLayout<T> ring_disc(const DiscShape<T> &disc, Extent extent) {
  check(disc);
  const Index layers = layer_count(disc.thickness, disc.spacing);
  ParticleLayout<T> layout;
  layout.spacing = disc.thickness / T(layers);
  const Index fewest = std::max(Index(1), static_cast<Index>(std::lround(disc.radius / layout.spacing)));
  const T pi = std::numbers::pi_v<T>, angle = T(2) * pi / T(symmetry_planes(extent).copies());
  const Index quarters = 4 / symmetry_planes(extent).copies();
  for (Index k = 0; k < layers; ++k) {
    const Index more = k % 2, rings = fewest + more;
    const T width = disc.radius / T(rings);
    for (Index r = 0; r < rings; ++r) {
      const T radius = (T(r) + T(0.5)) * width;
      const Index in_quarter =
          std::max(Index(1), static_cast<Index>(std::lround(T(0.5) * pi * radius / layout.spacing)));
      const Index count = (in_quarter + more) * quarters;
      for (Index c = 0; c < count; ++c) {
        const T phi = angle * (T(c) + T(0.5)) / T(count);
        layout.positions.push_back({radius * std::cos(phi), radius * std::sin(phi), -(T(k) + T(0.5)) * layout.spacing});
        layout.volumes.push_back(angle / T(count) * radius * width * layout.spacing);
      }
    }
  }
  sort_by_columns(layout);
  return layout;
}

/// A number of a sequence of random ones between 0 and 1, the same on all machines: SplitMix64 (Steele, Lea & Flood
/// 2014, OOPSLA).
inline double random_number(std::uint64_t seed, std::uint64_t place) {
  std::uint64_t z = seed * 0xd1342543de82ef95U + (place + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  z ^= z >> 31;
  return std::ldexp(static_cast<double>(z >> 11), -53);
}

/// Largest distance of a disturbed particle from its place on the lattice along each axis, over the particle distance.
inline constexpr double largest_disturbance = 0.05;

/// Another arrangement of the same disc, for what depends on how its particles lie: a whole disc is turned about its
/// axis, and each particle moves at random by up to largest_disturbance particle distances along each axis; those of
/// the outermost layers stay in their plane, and none leaves the disc. Volumes stay. `seed` chooses the arrangement.
template <class T>
void disturb(ParticleLayout<T> &layout, const DiscShape<T> &disc, Extent extent, std::uint64_t seed) {
  const T most = T(largest_disturbance) * layout.spacing, edge = disc.radius - T(0.25) * layout.spacing;
  const bool whole = symmetry_planes(extent).copies() == 1;
  const T angle = whole ? T(2) * std::numbers::pi_v<T> * T(random_number(seed, 0)) : T(0);
  for (std::size_t i = 0; i < layout.positions.size(); ++i) {
    Vec3<T> &p = layout.positions[i];
    const auto random = [&](std::uint64_t axis) { return most * T(2 * random_number(seed, 3 * i + 1 + axis) - 1); };
    if (whole)
      p = {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2]};
    const Vec3<T> moved = p + Vec3<T>(random(0), random(1), T(0));
    if (std::hypot(moved[0], moved[1]) < edge) p = moved;
    if (p[2] < -layout.spacing && p[2] > layout.spacing - disc.thickness) p[2] += random(2);
  }
}

} // namespace ogive
