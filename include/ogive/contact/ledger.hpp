// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/response.hpp"
#include "ogive/core/parallel.hpp"

/// \file
/// The work of contact forces.

namespace ogive {

/// Adds half of the work of a force on slave `s` over `dt` (s), done at the velocities now, to the ledger.
template <class T>
void add_half_work(NodeToSurface<T> &contact, const Nodes<T> &nodes, Index s, const ContactForce<T> &c, T dt) {
  if (c.facet < 0) return;
  const Vec3<T> v = relative_velocity(contact, nodes, s, c);
  contact.state.normal_energy[s] -= T(0.5) * dt * v.dot(c.normal);
  contact.state.friction_energy[s] -= T(0.5) * dt * v.dot(c.friction);
}

/// Work taken by the penalty springs, J.
template <class T> T normal_energy(const NodeToSurface<T> &c) {
  return ordered_sum(static_cast<Index>(c.slaves.size()), T(0), [&](Index s) { return c.state.normal_energy[s]; });
}

/// Work taken by friction, J.
template <class T> T friction_energy(const NodeToSurface<T> &c) {
  return ordered_sum(static_cast<Index>(c.slaves.size()), T(0), [&](Index s) { return c.state.friction_energy[s]; });
}

} // namespace ogive
