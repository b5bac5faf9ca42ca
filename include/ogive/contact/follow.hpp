// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/ledger.hpp"
#include "ogive/contact/node_to_surface.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/material/damage.hpp"

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// \file
/// Contacts of bodies that lose hexes and gain particles while the model runs. Between two steps a force has done half
/// of its work: what ends there is settled first, so that no work is lost.

namespace ogive {

/// Deactivates the slaves whose material has been removed from `body`: without a mass that makes the penalty they feel
/// no force. Facets stay, also those of removed hexes.
template <class T, class Body> void release_removed(NodeToSurface<T> &contact, const Body &body) {
  if (contact.follows || body.metal.damage.effect != FailureEffect::removal) return;
  parallel_for(static_cast<Index>(contact.slaves.size()), [&](Index s) {
    const Index n = contact.slaves[s];
    if (n >= body.nodes.begin && n < body.nodes.end && is_node_removed(body, n - body.nodes.begin))
      contact.state.slave_mass[s] = T(0);
  });
}

/// Books the work that the forces on slave `s` did since the middle of the last step of `dt` (s), and ends them.
template <class T> void settle(NodeToSurface<T> &contact, Nodes<T> &nodes, Index s, T dt) {
  const auto end = [&](ContactForce<T> &force) {
    add_half_work(contact, nodes, s, force, dt);
    take_back(contact, nodes, s, force);
    force = {};
  };
  end(contact.state.forces[s]);
  if (!contact.state.opposite.empty()) end(contact.state.opposite[s]);
}

/// Takes the masses that the slaves have now. A slave without mass is deactivated. One that had none is new: it may
/// overlap the surface, and its offset grows from where it is.
template <class T> void follow_slaves(NodeToSurface<T> &contact, Nodes<T> &nodes, T dt) {
  for (Index s = 0; s < static_cast<Index>(contact.slaves.size()); ++s) {
    const T mass = nodes.mass[contact.slaves[s]];
    if (mass == contact.state.slave_mass[s]) continue;
    if (contact.state.slave_mass[s] == T(0)) contact.state.present_offset[s] = std::numeric_limits<T>::lowest();
    if (mass == T(0)) settle(contact, nodes, s, dt);
    contact.state.slave_mass[s] = mass;
  }
  contact.state.searched_at.clear();
}

/// Number of slaves that overlap the surface: their offset is below zero.
template <class T> Index count_buried(const NodeToSurface<T> &contact) {
  Index buried = 0;
  for (std::size_t s = 0; s < contact.state.present_offset.size(); ++s)
    buried += contact.state.slave_mass[s] > T(0) && contact.state.present_offset[s] < T(0) ? 1 : 0;
  return buried;
}

/// Takes other facets; forces begin anew on them.
template <class T> void follow_surface(NodeToSurface<T> &contact, Nodes<T> &nodes, std::vector<Facet> facets, T dt) {
  for (Index s = 0; s < static_cast<Index>(contact.slaves.size()); ++s) settle(contact, nodes, s, dt);
  set_facets(contact, nodes, std::move(facets));
  contact.state.searched_at.clear();
}

} // namespace ogive
