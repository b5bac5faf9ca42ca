// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/response.hpp"
#include "ogive/core/parallel.hpp"

#include <utility>
#include <vector>

/// \file
/// The work of contact forces.

namespace ogive {

/// Adds half of the work of a force on near slave `k` over `dt` (s), done at the velocities now, to the ledger.
template <class T>
void add_half_work(NodeToSurface<T> &contact, const Nodes<T> &nodes, Index k, const ContactForce<T> &c, T dt) {
  if (c.facet < 0) return;
  NearSlaves<T> &near = contact.state.near;
  const Vec3<T> v = relative_velocity(contact, nodes, near.slaves[k], c);
  near.normal_energy[k] -= T(0.5) * dt * v.dot(c.normal);
  near.friction_energy[k] -= T(0.5) * dt * v.dot(c.friction);
}

/// Sum of a value of each near slave over all slaves, as ordered_sum() adds them: the other slaves have zeros.
template <class T> T sum_over_slaves(const NearSlaves<T> &near, const std::vector<T> &values) {
  T sum{}, of_block{};
  Index block = 0;
  for (Index k = 0; k < size(near); ++k) {
    if (const Index own = near.slaves[k] / fold_block; own != block) sum += std::exchange(of_block, T(0)), block = own;
    of_block += values[k];
  }
  return sum + of_block;
}

/// Work taken by the penalty springs, J.
template <class T> T normal_energy(const NodeToSurface<T> &c) {
  return sum_over_slaves(c.state.near, c.state.near.normal_energy);
}

/// Work taken by friction, J.
template <class T> T friction_energy(const NodeToSurface<T> &c) {
  return sum_over_slaves(c.state.near, c.state.near.friction_energy);
}

} // namespace ogive
