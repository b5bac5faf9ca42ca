// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/touch.hpp"

#include <algorithm>

/// \file
/// The force on a slave that touches the surface, and its reaction.

namespace ogive {

/// Velocity of the slave relative to the facet's point as the slave sees it, m/s. `touch` is a Touch or ContactForce.
template <class T, class Touching>
Vec3<T> relative_velocity(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index slave, const Touching &touch) {
  Vec3<T> v = Vec3<T>::Zero();
  for (int c = 0; c < 4; ++c) v += touch.weights[c] * nodes.velocity[contact.facets[touch.facet].nodes[c]];
  return nodes.velocity[contact.slaves[slave]] - reflected(v, touch.reflection);
}

/// Penalty force k depth with k = stiffness m/dt^2, and Coulomb friction, at most sticking m |v_t|/dt.
template <class T>
ContactForce<T> contact_force(const Touch<T> &touch, const ContactOptions<T> &options, const Vec3<T> &velocity, T mass,
                              T time_step) {
  ContactForce<T> c{.facet = touch.facet, .reflection = touch.reflection, .weights = touch.weights};
  const T pressing = options.stiffness * mass / (time_step * time_step) * touch.depth;
  c.normal = pressing * touch.direction;
  const Vec3<T> sliding = velocity - velocity.dot(touch.direction) * touch.direction;
  const T speed = sliding.norm();
  if (options.friction > T(0) && speed > T(0))
    c.friction = -std::min(options.friction * pressing / speed, options.sticking * mass / time_step) * sliding;
  return c;
}

/// Mass that the penalty stiffness of slave `s` is made with, kg: the smaller of its own and the facet's at the point
/// of contact, so that light facet nodes stay stable.
/// `touch` is a Touch or ContactForce.
template <class T, class Touching> T penalty_mass(const NodeToSurface<T> &contact, Index s, const Touching &touch) {
  if (contact.master_mass.empty()) return contact.state.slave_mass[s];
  T facet_mass{};
  for (int c = 0; c < 4; ++c) facet_mass += touch.weights[c] * contact.master_mass[touch.facet][c];
  return std::min(contact.state.slave_mass[s], facet_mass);
}

/// Whether near slave `k` can be inside a surface from which hexes may have been removed, `distance` (m) behind it. It
/// seems so beside a fold, where the surface overlaps itself and has no side. A slave does not get far inside in one
/// step: one that was not as deep in the last step is outside. While nothing has been removed only the slaves that
/// would be lost are checked.
template <class T> bool can_be_inside(const NodeToSurface<T> &contact, Index k, T distance) {
  if (contact.eroding.empty() || (!contact.torn && distance <= contact.search_margin)) return true;
  const Index s = contact.state.near.slaves[k];
  const ContactForce<T> &last = contact.state.near.forces[k];
  T depth{};
  if (const T mass = last.facet < 0 ? T(0) : penalty_mass(contact, s, last); mass > T(0)) {
    const T dt = contact.state.reference_time_step;
    depth = last.normal.norm() * dt * dt / (contact.options.stiffness * mass);
  }
  return contact.offset[s] + distance - depth < T(0.25) * contact.search_margin;
}

/// Adds the reaction to a force on a slave, times `sign`, to the forces of the facet's nodes.
template <class T>
void add_reaction(const NodeToSurface<T> &contact, Nodes<T> &nodes, const ContactForce<T> &c, T sign) {
  if (c.facet < 0) return;
  const Vec3<T> reaction = reflected<T>(sign * (c.normal + c.friction), c.reflection);
  for (int k = 0; k < 4; ++k) nodes.force[contact.facets[c.facet].nodes[k]] -= c.weights[k] * reaction;
}

} // namespace ogive
