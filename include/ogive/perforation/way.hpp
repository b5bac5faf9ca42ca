// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/parts.hpp"
#include "ogive/perforation/plug.hpp"

#include <limits>

namespace ogive {

/// The plates as the projectile meets them: the basis of the verdict whether it has perforated them.
template <class T> struct Way {
  bool clear = true;   ///< nothing that hangs on a plate's rim lies before the projectile
  bool inside = false; ///< something that hangs on a rim lies beside the projectile
  T plate_velocity{};  ///< m/s along the line of flight, mean of what lies beside it; 0: nothing does
  T later_loss{};      ///< m/s, that loose metal before the projectile takes once they move as one; 0 if that is faster
};

/// The projectile's axis of motion: that of the nodes that are followed, see followed_nodes().
template <class T> struct Axis {
  Vec3<T> middle;    ///< m, centre of mass
  Vec3<T> direction; ///< unit vector of the mean velocity
  T velocity{};      ///< m/s, of the mean velocity along the line of flight
  T mass{};          ///< kg, of the computed part of the projectile
  T front{};         ///< m, distance of the foremost node from the middle along it
  T rear{};          ///< m, likewise of the last node; negative
};

/// The axis of motion of the projectile now, whole in symmetric models; along `direction` while it moves that way more
/// slowly than `least_speed` (m/s), where the direction of its velocity has no meaning.
template <class M, class T> Axis<T> axis_of_motion(const M &model, const Vec3<T> &direction, T least_speed) {
  const auto &nodes = model.nodes;
  const std::vector<Index> followed = followed_nodes(model);
  Vec3<T> middle = Vec3<T>::Zero(), velocity = Vec3<T>::Zero();
  T mass{};
  for (const Index n : followed)
    mass += nodes.mass[n], middle += nodes.mass[n] * nodes.position[n], velocity += nodes.mass[n] * nodes.velocity[n];
  if (model.symmetry.x) middle[0] = velocity[0] = T(0);
  if (model.symmetry.y) middle[1] = velocity[1] = T(0);
  velocity /= mass;
  const bool moves = velocity.dot(direction) > least_speed;
  constexpr T infinite = std::numeric_limits<T>::infinity();
  Axis<T> axis{middle / mass, moves ? velocity.normalized() : direction, velocity.dot(direction), mass, -infinite,
               infinite};
  for (const Index n : followed) {
    const T along = (nodes.position[n] - axis.middle).dot(axis.direction);
    axis.front = std::max(axis.front, along), axis.rear = std::min(axis.rear, along);
  }
  return axis;
}

/// The way of a projectile of this radius (m) that was fired along `direction`, see axis_of_motion(). What hangs within
/// three quarters of its radius from the axis of motion, farther ahead than its foremost node, is in the way: nearer to
/// its edge the hole's rim may bend to the rear. Loose metal there that is slower will be hit.
template <class M, class T> Way<T> find_way(const M &model, const Vec3<T> &direction, T radius, T least_speed) {
  const Axis<T> axis = axis_of_motion(model, direction, least_speed);
  Way<T> way;
  T mass{}, momentum{}, loose_mass{}, loose_momentum{};
  const auto is_ahead = [&](const Vec3<T> &gap) {
    const T along = gap.dot(axis.direction);
    return along > axis.front && (gap - along * axis.direction).norm() < T(0.75) * radius;
  };
  const auto take = [&](const Vec3<T> &position, const Vec3<T> &velocity, T own_mass, T spacing) {
    const Vec3<T> gap = position - axis.middle;
    const T along = gap.dot(axis.direction), aside = (gap - along * axis.direction).norm();
    if (is_ahead(gap)) way.clear = false;
    if (along > axis.front || along < axis.rear || aside > radius + T(3) * spacing) return;
    mass += own_mass;
    momentum += own_mass * velocity.dot(direction);
  };
  for (std::size_t layer = 0; layer < model.bodies.plate_particles.size(); ++layer) {
    const auto &body = plate_particles(model, layer);
    const Pieces pieces = find_pieces(model, 1.5, layer);
    for (Index i = 0; i < static_cast<Index>(pieces.of.size()); ++i) {
      const Index n = body.nodes.begin + i;
      if (pieces.hangs(i))
        take(model.nodes.position[n], model.nodes.velocity[n], body.point_mass[i], body.spacing);
      else if (const Vec3<T> gap = model.nodes.position[n] - axis.middle; is_ahead(gap)) {
        loose_mass += body.point_mass[i];
        loose_momentum += body.point_mass[i] * model.nodes.velocity[n].dot(direction);
      }
    }
    const auto &rim = plate_hexes(model, layer);
    for (Index e = 0; e < static_cast<Index>(rim.hexes.size()); ++e) {
      if (is_removed(rim, e)) continue;
      Vec3<T> position = Vec3<T>::Zero(), velocity = Vec3<T>::Zero();
      T hex_mass{};
      for (const Index n : rim.hexes[e])
        position += T(0.125) * model.nodes.position[n], velocity += T(0.125) * model.nodes.velocity[n],
            hex_mass += T(0.125) * model.nodes.mass[n];
      take(position, velocity, hex_mass, body.spacing);
    }
  }
  way.inside = mass > T(0);
  if (way.inside) way.plate_velocity = momentum / mass;
  way.later_loss = std::max(T(0), (loose_mass * axis.velocity - loose_momentum) / (axis.mass + loose_mass));
  return way;
}

} // namespace ogive
