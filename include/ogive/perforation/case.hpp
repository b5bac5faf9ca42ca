// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/mesh/nested_mesh.hpp"
#include "ogive/mesh/projectile.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace ogive {

/// Arrangement of the plate's particles.
enum class Lattice {
  cubic, ///< simple cubic, cut at the disc's edge
  ring   ///< concentric rings, layer by layer
};

/// A plate behind another one.
template <class T> struct PlateBehind {
  T gap{};       ///< m, from the rear face of the plate before; 0: they touch
  T thickness{}; ///< m
};

/// A projectile that strikes the middle of a clamped round plate, or of several behind each other. The plate lies
/// between z = 0 (front) and z = -thickness, the projectile flies towards -z; at an angle, towards +x too. SI units.
template <class T> struct PerforationCase {
  T thickness = T(12e-3);          ///< of the plate, of the first one if there are several, m
  T clamp_radius = T(250e-3);      ///< of the plate, m
  T sph_radius = T(24e-3);         ///< radius of the disc of particles, m
  T spacing = T(0.6e-3);           ///< target particle distance, m
  Lattice lattice = Lattice::ring; ///< cubic ones break up along their rows under tension
  std::uint64_t seed = 0;          ///< of an arrangement that is disturbed at random, see disturb(); 0: the lattice
  /// Shape of the projectile.
  ProjectileShape<T> projectile = paper_projectile<T>(Nose::blunt);
  PartMesh<T> own_mesh{};        ///< of the computed part of a projectile with Nose::mesh, m, its tip at z = 0
  T projectile_mass = T(0);      ///< of the whole projectile, kg; 0: by the density of its metal
  T initial_velocity = T(303.5); ///< m/s
  T obliquity = T(0);            ///< angle between the line of flight and the plate's axis, rad; not in a quarter model
  T pitch = T(0);    ///< of the projectile's axis against the line of flight, rad, in the plane of flight and of the
                     ///< plate's axis: positive where the obliquity grows; not in a quarter model
  T yaw = T(0);      ///< likewise out of that plane, towards +y; in a full model alone
  T friction = T(0); ///< Coulomb, plate on projectile
  Parts parts = Parts::tied;            ///< connection of the projectile's parts
  T part_friction = T(0.1);             ///< Coulomb, between parts that touch
  bool erosion = true;                  ///< hexes of the projectile that are too distorted are removed, unless rigid
  bool rigid_projectile = false;        ///< it moves as one, and does not deform
  Extent extent = Extent::quarter;      ///< computed part of the model
  std::vector<PlateBehind<T>> behind{}; ///< more plates, in the order in which the projectile meets them
};

/// The mesh of the projectile's computed part, tip at z = 0, body at z > 0; parts that touch have nodes of their own.
/// Throws SetupError for dimensions or hexes that cannot be.
template <class T> PartMesh<T> projectile_body(const PerforationCase<T> &c, T spacing) {
  const auto as_held = [&](PartMesh<T> body) { return c.parts == Parts::touching ? separated(body) : body; };
  if (c.projectile.nose == Nose::mesh) return as_held(c.own_mesh);
  if (!c.projectile.inner.empty()) return as_held(nested_mesh(c.projectile, spacing, c.extent));
  return {projectile_mesh(c.projectile, spacing, c.extent)};
}

/// Most plates of a target: more are better taken for one with other properties.
inline constexpr std::size_t most_layers = 8;

/// Position and thickness of a plate of a target.
template <class T> struct Layer {
  T front{};     ///< m, depth of its front face below that of the first one
  T thickness{}; ///< m
};

/// All plates of a case from front to rear.
template <class T> std::vector<Layer<T>> layers_of(const PerforationCase<T> &c) {
  std::vector<Layer<T>> layers{{T(0), c.thickness}};
  for (const PlateBehind<T> &plate : c.behind)
    layers.push_back({layers.back().front + layers.back().thickness + plate.gap, plate.thickness});
  return layers;
}

/// Depth of the last plate's rear face below the first one's front face, m.
template <class T> T target_depth(const PerforationCase<T> &c) {
  const Layer<T> last = layers_of(c).back();
  return last.front + last.thickness;
}

/// Unit vector along the line of flight.
template <class T> Vec3<T> direction_of_flight(const PerforationCase<T> &c) {
  return {std::sin(c.obliquity), T(0), -std::cos(c.obliquity)};
}

/// Unit vector along the projectile's axis, from tail to tip, at the start.
template <class T> Vec3<T> direction_of_axis(const PerforationCase<T> &c) {
  const T tilt = c.obliquity + c.pitch;
  return {std::cos(c.yaw) * std::sin(tilt), std::sin(c.yaw), -std::cos(c.yaw) * std::cos(tilt)};
}

/// Smallest radius of the disc of particles, m: the projectile goes through it with two particle distances to spare.
/// One that flies at an angle to its axis sweeps half its length as well.
template <class T> T least_sph_radius(const PerforationCase<T> &c) {
  const T swept = T(0.5) * length(c.projectile) * std::hypot(std::sin(c.pitch), std::sin(c.yaw));
  return T(0.5) * c.projectile.diameter / std::cos(c.obliquity) + target_depth(c) * std::tan(c.obliquity) + swept +
         T(2) * c.spacing;
}

} // namespace ogive
