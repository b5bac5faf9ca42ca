// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/parts.hpp"
#include "ogive/sim/rigid_part.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ogive {

/// The motion of a projectile, rigid or deformable: of all its parts, or of main_part() if parts touch.
template <class T> struct ProjectileMotion {
  T speed{};                           ///< of the centre of mass, m/s
  Vec3<T> direction = Vec3<T>::Zero(); ///< of that motion; zero at rest
  T deflection{};                      ///< angle between that and the initial line of flight, rad
  Vec3<T> axis = Vec3<T>::Zero();      ///< from tail to tip
  T turn{};                            ///< angle between that and the axis at the start, rad
  Vec3<T> spin = Vec3<T>::Zero();      ///< angular momentum over inertia, rad/s
};

/// Angle between two unit vectors, rad.
template <class T> T angle_between(const Vec3<T> &a, const Vec3<T> &b) {
  return std::atan2(cross<T>(a, b).norm(), a.dot(b));
}

/// The undeformed projectile: coordinates of its nodes along its axis towards the tip, m, from the centre of mass of
/// what is followed.
template <class M, class T> std::vector<T> axial_places(const M &model, const PerforationCase<T> &c) {
  const NodeRange range = projectile_nodes(model);
  const Vec3<T> centre = inertia_of(model.nodes, followed_nodes(model), model.symmetry).centre,
                axis = direction_of_axis(c);
  std::vector<T> places;
  for (Index n = range.begin; n < range.end; ++n) places.push_back((model.nodes.position[n] - centre).dot(axis));
  return places;
}

/// The projectile's motion now; `places` are its axial_places() at the start. Its axis is where the nodes that were
/// towards the tip lie now, weighted by mass and distance.
template <class M, class T>
ProjectileMotion<T> motion_of(const M &model, const PerforationCase<T> &c, const std::vector<T> &places) {
  const Index first = projectile_nodes(model).begin;
  const std::vector<Index> followed = followed_nodes(model);
  const Inertia<T> now = inertia_of(model.nodes, followed, model.symmetry);
  ProjectileMotion<T> motion;
  motion.speed = now.velocity.norm();
  if (motion.speed > T(0)) motion.direction = now.velocity / motion.speed;
  motion.deflection = motion.speed > T(0) ? angle_between(motion.direction, direction_of_flight(c)) : T(0);
  for (const Index n : followed)
    motion.axis += model.nodes.mass[n] * places[n - first] * (model.nodes.position[n] - now.centre);
  if (model.symmetry.x) motion.axis[0] = T(0);
  if (model.symmetry.y) motion.axis[1] = T(0);
  motion.axis.normalize();
  motion.turn = angle_between(motion.axis, direction_of_axis(c));
  const SymmetryPlanes planes = model.symmetry;
  const auto held = static_cast<std::uint8_t>((planes.x ? held_x : held_none) | (planes.y ? held_y : held_none));
  motion.spin = free_compliance<T>(now.tensor, held) * now.angular_momentum;
  return motion;
}

} // namespace ogive
