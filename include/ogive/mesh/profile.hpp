// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ogive {

/// A point of the outline of a body of revolution.
template <class T> struct ProfilePoint {
  T z{};      ///< m, from the front to the rear
  T radius{}; ///< m
  /// Both are the same.
  bool operator==(const ProfilePoint &) const = default;
};

/// The outline of a body of revolution, from the front to the rear, straight between its points.
template <class T> using Profile = std::vector<ProfilePoint<T>>;

/// Most points of a profile.
inline constexpr std::size_t most_profile_points = 10000;

/// Smallest radius of a profile over its largest: hexes need a flat at the tip.
inline constexpr double least_profile_radius = 0.02;

/// Throws SetupError unless the profile has 2 to 10000 points, each behind the one before, with radii that are nowhere
/// below least_profile_radius of the largest.
template <class T> void check(const Profile<T> &profile) {
  require(profile.size() >= 2 && profile.size() <= most_profile_points, "points of the profile", profile.size(),
          "must be 2 to " + std::to_string(most_profile_points));
  T widest{};
  for (const auto &p : profile) widest = std::max(widest, p.radius);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const std::string point = "of point " + std::to_string(k + 1) + " of the profile (m)";
    const auto &[z, radius] = profile[k];
    require(std::isfinite(z) && (k == 0 || z > profile[k - 1].z), "z " + point, z,
            "must be finite and larger than that of the point before");
    require(std::isfinite(radius) && radius > T(0), "radius " + point, radius, "must be positive and finite");
    require(radius >= T(least_profile_radius) * widest, "radius " + point, radius,
            "must be at least 0.02 of the largest: hexes need a flat at the tip");
  }
}

/// Radius at z (m), m, straight between the points; that of the first or last one beyond them.
template <class T> T radius_at(const Profile<T> &profile, T z) {
  const auto behind =
      std::lower_bound(profile.begin(), profile.end(), z, [](const auto &p, T value) { return p.z < value; });
  if (behind == profile.begin()) return profile.front().radius;
  if (behind == profile.end()) return profile.back().radius;
  const auto &a = *(behind - 1), &b = *behind;
  return a.radius + (b.radius - a.radius) * (z - a.z) / (b.z - a.z);
}

/// Volume of the body, m3: that of its frusta.
template <class T> T volume(const Profile<T> &profile) {
  T sum{};
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const auto &a = profile[k - 1], &b = profile[k];
    sum += (b.z - a.z) * (a.radius * a.radius + a.radius * b.radius + b.radius * b.radius);
  }
  return std::numbers::pi_v<T> / T(3) * sum;
}

/// The places (m) where the outline turns by more than `least_turn` (rad), at least `least_distance` (m) apart from
/// each other and from the ends, which are the first and the last entry: a mesh should have nodes there.
template <class T> std::vector<T> kinks(const Profile<T> &profile, T least_distance, T least_turn = T(0.15)) {
  const auto slope = [&](std::size_t k) {
    return std::atan2(profile[k].radius - profile[k - 1].radius, profile[k].z - profile[k - 1].z);
  };
  const T end = profile.back().z;
  std::vector<T> places{profile.front().z};
  for (std::size_t k = 1; k + 1 < profile.size(); ++k)
    if (std::abs(slope(k + 1) - slope(k)) > least_turn && profile[k].z - places.back() >= least_distance &&
        end - profile[k].z >= least_distance)
      places.push_back(profile[k].z);
  places.push_back(end);
  return places;
}

} // namespace ogive
