// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

namespace ogive {

/// Shape of a projectile's front.
enum class Nose { blunt, conical, ogival, hemispherical };

/// All noses, in the order of the enumerators.
inline constexpr std::array<Nose, 4> all_noses = {Nose::blunt, Nose::conical, Nose::ogival, Nose::hemispherical};

/// Name of a nose: its enumerator.
inline std::string_view name(Nose nose) {
  constexpr std::array<std::string_view, 4> names = {"blunt", "conical", "ogival", "hemispherical"};
  return names[static_cast<std::size_t>(nose)];
}

/// A round projectile: a cylindrical shank and a nose in front of it. SI units.
template <class T> struct ProjectileShape {
  Nose nose = Nose::blunt; ///< shape of the front
  T diameter{};            ///< of the shank, m
  T shank_length{};        ///< m
  T nose_length{}; ///< m: 0 if blunt; of the frustum if conical; of the ogive without flat; the radius if hemispherical
  T tip_diameter{}; ///< flat at the tip of a conical or ogival nose, m
  T edge_radius{};  ///< of the edge between face and shank of a blunt projectile, m; 0: sharp
};

/// The projectiles of Liu et al. 2012, Fig. 4: 20 mm and about 197 g. The ogive (tangent, radius 59.45 mm) is given a
/// flat of 1 mm. The hemispherical one is not in the paper: its shank is chosen for the same 197 g.
template <class T> ProjectileShape<T> paper_projectile(Nose nose) {
  switch (nose) {
  case Nose::blunt:
    return {nose, T(20e-3), T(80e-3), T(0), T(0)};
  case Nose::conical:
    return {nose, T(20e-3), T(68e-3), T(30e-3), T(2e-3)};
  case Nose::ogival:
    return {nose, T(20e-3), T(62e-3), T(33e-3), T(1e-3)};
  case Nose::hemispherical:
    return {nose, T(20e-3), T(73.2e-3), T(10e-3), T(0)};
  }
  throw SetupError("nose = " + std::to_string(static_cast<int>(nose)) + ": must be one of the enumerators");
}

/// Throws SetupError if a dimension is out of range.
template <class T> void check(const ProjectileShape<T> &s) {
  const auto positive = [](T value, const char *thing) {
    require(std::isfinite(value) && value > T(0), thing, value, "must be positive and finite");
  };
  positive(s.diameter, "projectile diameter (m)");
  positive(s.shank_length, "projectile shank length (m)");
  const T radius = s.diameter / T(2);
  if (s.nose == Nose::blunt) {
    require(s.nose_length == T(0), "nose length (m)", s.nose_length, "must be 0 if blunt");
    require(s.edge_radius >= T(0) && s.edge_radius <= std::min(radius / T(4), s.shank_length / T(2)), "edge radius (m)",
            s.edge_radius, "must lie between 0 and an eighth of the diameter or half the length");
  } else {
    require(s.edge_radius == T(0), "edge radius (m)", s.edge_radius, "must be 0 unless blunt");
  }
  if (s.nose == Nose::hemispherical)
    require(std::abs(s.nose_length - radius) <= T(1e-5) * radius, "nose length (m)", s.nose_length,
            "must be the radius if hemispherical");
  if (s.nose == Nose::blunt || s.nose == Nose::hemispherical) {
    require(s.tip_diameter == T(0), "tip diameter (m)", s.tip_diameter, "must be 0 if blunt or hemispherical");
    return;
  }
  positive(s.nose_length, "nose length (m)");
  require(s.tip_diameter >= T(0.02) * s.diameter && s.tip_diameter < s.diameter, "tip diameter (m)", s.tip_diameter,
          "must lie between 0.02 diameters and the diameter");
  if (s.nose == Nose::ogival)
    require(s.nose_length > radius, "nose length (m)", s.nose_length, "must exceed the radius for a tangent ogive");
}

/// Radius of the arc of a tangent ogive, m: (R^2 + L^2)/(2 R).
template <class T> T ogive_radius(const ProjectileShape<T> &s) {
  const T radius = s.diameter / T(2);
  return (radius * radius + s.nose_length * s.nose_length) / s.diameter;
}

/// Distance from the flat tip to the shoulder, m: the nose length, less what the flat cuts off an ogive.
template <class T> T nose_height(const ProjectileShape<T> &s) {
  if (s.nose != Nose::ogival) return s.nose_length;
  const T arc = ogive_radius(s), inner = arc - s.diameter / T(2) + s.tip_diameter / T(2);
  return std::sqrt(arc * arc - inner * inner);
}

/// Length from tip to tail, m.
template <class T> T length(const ProjectileShape<T> &s) { return nose_height(s) + s.shank_length; }

/// Radius at the distance z (m) behind the tip, m.
template <class T> T radius_at(const ProjectileShape<T> &s, T z) {
  const T radius = s.diameter / T(2), height = nose_height(s);
  const T before = std::max(T(0), height - z);
  switch (s.nose) {
  case Nose::blunt: {
    const T left = std::max(T(0), s.edge_radius - z);
    return radius - s.edge_radius + std::sqrt(s.edge_radius * s.edge_radius - left * left);
  }
  case Nose::conical:
    return radius - (radius - s.tip_diameter / T(2)) * before / height;
  case Nose::ogival: {
    const T arc = ogive_radius(s);
    return std::sqrt(arc * arc - before * before) - (arc - radius);
  }
  case Nose::hemispherical:
    return std::sqrt(std::max(T(0), radius * radius - before * before));
  }
  return radius;
}

/// Volume that a rounded edge lacks against a sharp one, over pi, m3: the integral of R^2 - radius_at(z)^2.
template <class T> T edge_loss(const ProjectileShape<T> &s) {
  constexpr T pi = std::numbers::pi_v<T>;
  const T r = s.edge_radius, radius = s.diameter / T(2);
  return r * r * ((T(2) - pi / T(2)) * radius - (T(5) / T(3) - pi / T(2)) * r);
}

/// Analytic volume, m3.
template <class T> T volume(const ProjectileShape<T> &s) {
  constexpr T pi = std::numbers::pi_v<T>;
  const T radius = s.diameter / T(2), tip = s.tip_diameter / T(2), height = nose_height(s);
  T nose = -pi * edge_loss(s);
  if (s.nose == Nose::conical) nose = pi / T(3) * height * (radius * radius + radius * tip + tip * tip);
  if (s.nose == Nose::hemispherical) nose = T(2) / T(3) * pi * radius * radius * radius;
  if (s.nose == Nose::ogival) {
    // The integral of (sqrt(arc^2 - u^2) - offset)^2 over the distance u from the shoulder.
    const T arc = ogive_radius(s), offset = arc - radius, u = height;
    nose = pi * ((arc * arc + offset * offset) * u - u * u * u / T(3) -
                 offset * (u * std::sqrt(arc * arc - u * u) + arc * arc * std::asin(u / arc)));
  }
  return pi * radius * radius * s.shank_length + nose;
}

/// Analytic mass, kg, for a density in kg/m3.
template <class T> T mass(const ProjectileShape<T> &s, T density) { return density * volume(s); }

} // namespace ogive
