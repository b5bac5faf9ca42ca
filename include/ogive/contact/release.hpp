// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/material/damage.hpp"

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

} // namespace ogive
