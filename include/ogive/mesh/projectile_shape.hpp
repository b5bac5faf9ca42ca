// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/types.hpp"
#include "ogive/mesh/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace ogive {

/// Shape of a projectile's front.
enum class Nose {
  blunt,         ///< flat
  conical,       ///< a frustum
  ogival,        ///< a tangent ogive with a flat at the tip
  hemispherical, ///< half a sphere
  chisel,        ///< a flat between two inclined ones, as fragment simulators have; symmetric in x and in y
  sphere,        ///< the whole projectile is one
  profile,       ///< the whole projectile is a body of revolution with a profile of its own
  mesh           ///< the whole projectile is a mesh of its own
};

/// All noses, in the order of the enumerators.
inline constexpr std::array<Nose, 8> all_noses = {Nose::blunt,  Nose::conical, Nose::ogival,  Nose::hemispherical,
                                                  Nose::chisel, Nose::sphere,  Nose::profile, Nose::mesh};

/// The noses of paper_projectile().
inline constexpr std::array<Nose, 4> paper_noses = {Nose::blunt, Nose::conical, Nose::ogival, Nose::hemispherical};

/// Name of a nose: its enumerator.
inline std::string_view name(Nose nose) {
  constexpr std::array<std::string_view, 8> names = {"blunt",  "conical", "ogival",  "hemispherical",
                                                     "chisel", "sphere",  "profile", "mesh"};
  return names[static_cast<std::size_t>(nose)];
}

/// A projectile: a cylindrical shank and a nose in front of it. Behind, the shank may taper to a boat tail. SI units.
template <class T> struct ProjectileShape {
  Nose nose = Nose::blunt; ///< shape of the front
  T diameter{};            ///< of the shank, m
  T shank_length{};        ///< m, boat tail included; 0 of a sphere
  T nose_length{};         ///< m: 0 if blunt; of the frustum if conical; of the ogive without flat; the radius if
                   ///< hemispherical; depth of the inclined flats of a chisel; diameter of a sphere; up to the widest
                   ///< place of a profile or mesh
  T tip_diameter{};     ///< flat at the tip of a conical or ogival nose or of a mesh, width of that of a chisel, m
  T edge_radius{};      ///< of the edge between face and shank of a blunt projectile, m; 0: sharp
  T tail_length{};      ///< of the boat tail, m; 0: none
  T tail_diameter{};    ///< of its rear end, m
  Profile<T> profile{}; ///< of a projectile that has its own
  /// Surfaces within the projectile, from the inside out, each closed by flats at both ends; z from the tip. Each
  /// bounds a part of another metal, see nested_mesh.hpp.
  std::vector<Profile<T>> inner{};
  bool is_hollow = false; ///< there is nothing within the first of those surfaces
  T mesh_volume{};        ///< of the whole of a mesh of its own, m3
};

/// Whether the projectile pushes the plate aside, and has perforated once its tail has left; else it pushes a plug out.
template <class T> bool is_sharp(const ProjectileShape<T> &s) {
  if (s.nose == Nose::mesh) return s.tip_diameter < T(0.5) * s.diameter;
  return s.nose != Nose::blunt && s.nose != Nose::chisel;
}

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
  default:
    break;
  }
  throw SetupError("nose = " + std::to_string(static_cast<int>(nose)) + ": must be one of paper_noses");
}

/// A projectile with this nose for which nothing else is given: paper_projectile(); a chisel with the proportions of
/// the 20 mm fragment simulator, see projectile_library.hpp; a sphere. All have a diameter of 20 mm but a profile,
/// which has no dimensions.
template <class T> ProjectileShape<T> default_projectile(Nose nose) {
  if (nose == Nose::chisel) return {nose, T(20e-3), T(18.9e-3), T(3.7e-3), T(9.3e-3)};
  if (nose == Nose::sphere) return {nose, T(20e-3), T(0), T(20e-3), T(0)};
  if (nose == Nose::profile) return {nose};
  return paper_projectile<T>(nose);
}

/// The projectile of a profile, m. Throws SetupError for one that is no body.
template <class T> ProjectileShape<T> projectile_of(const Profile<T> &profile) {
  check(profile);
  ProjectileShape<T> s{Nose::profile};
  const auto widest = std::max_element(profile.begin(), profile.end(),
                                       [](const auto &a, const auto &b) { return a.radius < b.radius; });
  s.diameter = T(2) * widest->radius;
  s.nose_length = widest->z - profile.front().z;
  s.shank_length = profile.back().z - widest->z;
  s.profile = profile;
  for (ProfilePoint<T> &p : s.profile) p.z -= profile.front().z;
  return s;
}

/// Throws SetupError if a dimension is out of range.
template <class T> void check(const ProjectileShape<T> &s) {
  if (s.nose == Nose::mesh) {
    require(std::isfinite(s.diameter) && s.diameter > T(0), "projectile diameter (m)", s.diameter,
            "must be positive and finite");
    require(std::isfinite(s.mesh_volume) && s.mesh_volume > T(0), "volume of the projectile's mesh (m3)", s.mesh_volume,
            "must be positive and finite");
    return;
  }
  const auto positive = [](T value, const char *thing) {
    require(std::isfinite(value) && value > T(0), thing, value, "must be positive and finite");
  };
  positive(s.diameter, "projectile diameter (m)");
  const T radius = s.diameter / T(2);
  if (s.nose == Nose::sphere) {
    require(s.shank_length == T(0), "projectile shank length (m)", s.shank_length, "must be 0 of a sphere");
    require(std::abs(s.nose_length - s.diameter) <= T(1e-5) * s.diameter, "nose length (m)", s.nose_length,
            "must be the diameter of a sphere");
  } else if (s.nose != Nose::profile) {
    positive(s.shank_length, "projectile shank length (m)");
  }
  require(s.tail_length >= T(0) && (s.tail_length == T(0) || s.tail_length < s.shank_length), "tail length (m)",
          s.tail_length, "must be 0, or less than that of the shank");
  if (s.tail_length > T(0)) {
    require(s.nose != Nose::profile, "tail length (m)", s.tail_length, "must be 0 with a profile");
    require(s.tail_diameter >= T(0.25) * s.diameter && s.tail_diameter <= s.diameter, "tail diameter (m)",
            s.tail_diameter, "must lie between a quarter of the diameter and the diameter");
  }
  if (s.nose == Nose::profile) {
    check(s.profile);
    require(s.profile.front().z == T(0), "z of the profile's first point (m)", s.profile.front().z, "must be 0");
    const ProjectileShape<T> own = projectile_of(s.profile);
    require(std::abs(own.diameter - s.diameter) <= T(1e-5) * s.diameter, "projectile diameter (m)", s.diameter,
            "must be that of the profile, " + std::to_string(own.diameter));
    return;
  }
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
  if (s.nose == Nose::blunt || s.nose == Nose::hemispherical || s.nose == Nose::sphere) {
    require(s.tip_diameter == T(0), "tip diameter (m)", s.tip_diameter,
            "must be 0 if blunt, hemispherical or a sphere");
    return;
  }
  positive(s.nose_length, "nose length (m)");
  if (s.nose == Nose::chisel)
    require(T(2) * s.nose_length <= T(1.8) * (s.diameter - s.tip_diameter), "nose length (m)", s.nose_length,
            "must be at most 0.9 times the diameter less the width of the flat: flats inclined by 61 degrees");
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

/// Tangent of the angle between a chisel's inclined flats and its front.
template <class T> T chisel_slope(const ProjectileShape<T> &s) {
  return s.nose_length / (T(0.5) * (s.diameter - s.tip_diameter));
}

/// Depth of a chisel's front at the distance `x` (m) from its middle plane, m.
template <class T> T chisel_depth(const ProjectileShape<T> &s, T x) {
  return chisel_slope(s) * std::max(T(0), std::abs(x) - T(0.5) * s.tip_diameter);
}

/// Distance from the flat tip to the shoulder, m: the nose length, less what the flat cuts off an ogive.
template <class T> T nose_height(const ProjectileShape<T> &s) {
  if (s.nose != Nose::ogival) return s.nose_length;
  const T arc = ogive_radius(s), inner = arc - s.diameter / T(2) + s.tip_diameter / T(2);
  return std::sqrt(arc * arc - inner * inner);
}

/// Length from tip to tail, m.
template <class T> T length(const ProjectileShape<T> &s) { return nose_height(s) + s.shank_length; }

/// Radius at the distance z (m) behind the tip, m; of a chisel that of its shank.
template <class T> T radius_at(const ProjectileShape<T> &s, T z) {
  if (s.nose == Nose::profile) return radius_at(s.profile, z);
  const T radius = s.diameter / T(2), height = nose_height(s);
  if (const T tail = z - (height + s.shank_length - s.tail_length); s.tail_length > T(0) && tail > T(0))
    return radius - (radius - T(0.5) * s.tail_diameter) * tail / s.tail_length;
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
  case Nose::sphere:
    return std::sqrt(std::max(T(0), radius * radius - (z - radius) * (z - radius)));
  case Nose::chisel:
  case Nose::profile:
  case Nose::mesh:
    break;
  }
  return radius;
}

/// Volume that a rounded edge lacks against a sharp one, over pi, m3: the integral of R^2 - radius_at(z)^2.
template <class T> T edge_loss(const ProjectileShape<T> &s) {
  constexpr T pi = std::numbers::pi_v<T>;
  const T r = s.edge_radius, radius = s.diameter / T(2);
  return r * r * ((T(2) - pi / T(2)) * radius - (T(5) / T(3) - pi / T(2)) * r);
}

/// Volume that the boat tail lacks against the shank, m3.
template <class T> T tail_loss(const ProjectileShape<T> &s) {
  const T radius = s.diameter / T(2), end = s.tail_diameter / T(2);
  return std::numbers::pi_v<T> * s.tail_length *
         (radius * radius - (radius * radius + radius * end + end * end) / T(3));
}

/// Volume of a chisel in front of its shoulder, m3: the cylinder less two wedges, of which the integral of
/// slope (x - c) 2 sqrt(R^2 - x^2) from c to R is half.
template <class T> T chisel_volume(const ProjectileShape<T> &s) {
  const T radius = s.diameter / T(2), c = s.tip_diameter / T(2), chord = std::sqrt(radius * radius - c * c);
  const T wedge = T(2) / T(3) * chord * chord * chord - c * (radius * radius * std::acos(c / radius) - c * chord);
  return std::numbers::pi_v<T> * radius * radius * s.nose_length - T(2) * chisel_slope(s) * wedge;
}

/// Analytic volume within the outer surface, m3, a bore included.
template <class T> T outer_volume(const ProjectileShape<T> &s) {
  if (s.nose == Nose::mesh) return s.mesh_volume;
  if (s.nose == Nose::profile) return volume(s.profile);
  constexpr T pi = std::numbers::pi_v<T>;
  const T radius = s.diameter / T(2), tip = s.tip_diameter / T(2), height = nose_height(s);
  T nose = -pi * edge_loss(s);
  if (s.nose == Nose::conical) nose = pi / T(3) * height * (radius * radius + radius * tip + tip * tip);
  if (s.nose == Nose::hemispherical) nose = T(2) / T(3) * pi * radius * radius * radius;
  if (s.nose == Nose::sphere) nose = T(4) / T(3) * pi * radius * radius * radius;
  if (s.nose == Nose::chisel) nose = chisel_volume(s);
  if (s.nose == Nose::ogival) {
    // The integral of (sqrt(arc^2 - u^2) - offset)^2 over the distance u from the shoulder.
    const T arc = ogive_radius(s), offset = arc - radius, u = height;
    nose = pi * ((arc * arc + offset * offset) * u - u * u * u / T(3) -
                 offset * (u * std::sqrt(arc * arc - u * u) + arc * arc * std::asin(u / arc)));
  }
  const T whole = pi * radius * radius * s.shank_length + nose;
  return s.tail_length > T(0) ? whole - tail_loss(s) : whole;
}

/// Analytic volume, m3, without that of a bore.
template <class T> T volume(const ProjectileShape<T> &s) {
  return s.is_hollow ? outer_volume(s) - volume(s.inner.front()) : outer_volume(s);
}

/// Analytic mass, kg, for a density in kg/m3.
template <class T> T mass(const ProjectileShape<T> &s, T density) { return density * volume(s); }

} // namespace ogive
