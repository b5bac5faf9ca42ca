// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/ledger.hpp"
#include "ogive/contact/response.hpp"
#include "ogive/contact/search.hpp"
#include "ogive/contact/touch.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/material/damage.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// Finds middle and radius of each facet at the present positions.
template <class T> void measure_facets(NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  parallel_for(static_cast<Index>(contact.facets.size()), [&](Index f) {
    Vec3<T> middle = Vec3<T>::Zero();
    for (Index n : contact.facets[f].nodes) middle += T(0.25) * nodes.position[n];
    T r2{};
    for (Index n : contact.facets[f].nodes) r2 = std::max(r2, (nodes.position[n] - middle).squaredNorm());
    contact.candidates.middle[f] = middle;
    contact.candidates.radius[f] = std::sqrt(r2);
  });
}

/// Adds the forces on slave `a` of the active list and their work over the interval `dt_old` (s) to the ledger.
template <class T> void add_force_on_slave(NodeToSurface<T> &contact, Nodes<T> &nodes, Index a, T dt_old) {
  const ContactState<T> &state = contact.state;
  NearSlaves<T> &near = contact.state.near;
  const Index s = contact.candidates.active[a], k = contact.candidates.entry[a], node = contact.slaves[s];
  if (near.room[k] > T(0)) return;
  ContactForce<T> now;
  const Vec3<T> p = on_model_side(contact, nodes.position, s);
  NearestFacet<T> nearest = find_nearest(contact, nodes, a, p, contact.offset[s] + contact.search_margin);
  if (!nearest.outside && !can_be_inside(contact, k, std::sqrt(nearest.point.distance_squared))) nearest.outside = true;
  const Touch<T> touch = touch_at(contact, nodes, a, nearest);
  near.room[k] = T(0.99) * touch.room; // the closest point is known to 1e-6 of its distance
  if (touch.lost) {
    now.lost = state.slave_mass[s] > T(0); // a deactivated slave may be anywhere
  } else if (touch.facet >= 0) {
    const Vec3<T> velocity = relative_velocity(contact, nodes, s, touch);
    now = contact_force(touch, contact.options, velocity, penalty_mass(contact, s, touch), state.reference_time_step);
  }
  add_half_work(contact, nodes, k, near.forces[k], dt_old);
  add_half_work(contact, nodes, k, now, dt_old);
  near.forces[k] = now;
  nodes.force[node] += now.normal + now.friction;
}

/// Deactivates the slaves whose material has been removed from `body`: without a mass that makes the penalty they feel
/// no force.
template <class T, class Body> void deactivate_removed(NodeToSurface<T> &contact, const Body &body) {
  parallel_for(static_cast<Index>(contact.slaves.size()), [&](Index s) {
    const Index n = contact.slaves[s];
    if (n >= body.nodes.begin && n < body.nodes.end && is_node_removed(body, n - body.nodes.begin))
      contact.state.slave_mass[s] = T(0);
  });
}

/// deactivate_removed() for a body whose material may be removed by damage in any step. Facets stay, also those of
/// removed hexes.
template <class T, class Body> void release_removed(NodeToSurface<T> &contact, const Body &body) {
  const auto &damage = body.metal.damage;
  if (damage.effect == FailureEffect::removal && damage.law != DamageLaw::none) deactivate_removed(contact, body);
}

/// Keeps where near slaves and masters are at this check.
template <class T> void keep_checked_positions(NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  NearSlaves<T> &near = contact.state.near;
  std::vector<Vec3<T>> &masters_at = contact.state.masters_checked_at;
  masters_at.resize(contact.masters.size());
  parallel_for(size(near), [&](Index k) { near.checked_at[k] = nodes.position[contact.slaves[near.slaves[k]]]; });
  parallel_for(static_cast<Index>(masters_at.size()),
               [&](Index m) { masters_at[m] = nodes.position[contact.masters[m]]; });
}

/// Adds the forces of a contact to slaves and masters, and their work over the last interval `dt_old` (s; the step to
/// come is `dt`) to the ledger (trapezoidal rule between the forces before and now).
template <class T> void add_contact_force(NodeToSurface<T> &contact, Nodes<T> &nodes, T dt_old, T dt) {
  ContactState<T> &state = contact.state;
  if (is_search_due(contact, nodes)) {
    search(contact, nodes);
    std::fill(state.near.room.begin(), state.near.room.end(), T(0));
  } else {
    use_up_room(contact, nodes);
  }
  if (state.reference_time_step == T(0)) state.reference_time_step = dt;
  measure_facets(contact, nodes);
  parallel_for(static_cast<Index>(contact.candidates.active.size()),
               [&](Index a) { add_force_on_slave(contact, nodes, a, dt_old); });
  keep_checked_positions(contact, nodes);

  // Masters share nodes; the slaves in contact are few, so one thread hands over their reactions in a fixed order.
  for (const Index k : contact.candidates.entry) {
    const ContactForce<T> &force = state.near.forces[k];
    if (force.lost && state.lost < 0) state.lost = state.near.slaves[k];
    add_reaction(contact, nodes, force, T(1));
  }
}

} // namespace ogive
