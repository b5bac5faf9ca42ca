// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/ledger.hpp"
#include "ogive/contact/node_to_surface.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace ogive {

/// Gives a contact other master facets between two steps, the last of which was `dt` (s). Slaves that touch a facet
/// that stays keep their force until the next step; where the facet goes, so does the force, and the ledger takes the
/// work that it still did.
template <class T>
void replace_facets(NodeToSurface<T> &contact, const Nodes<T> &nodes, std::vector<Facet> facets, T dt) {
  using Place = std::pair<std::array<Index, 4>, Index>;
  std::vector<Place> places;
  for (Index f = 0; f < static_cast<Index>(facets.size()); ++f) places.emplace_back(facets[f].nodes, f);
  std::sort(places.begin(), places.end());
  for (Index k = 0; k < size(contact.state.near); ++k) {
    ContactForce<T> &force = contact.state.near.forces[k];
    if (force.facet < 0) continue;
    const auto &corners = contact.facets[force.facet].nodes;
    const auto same = std::lower_bound(places.begin(), places.end(), Place{corners, -1});
    if (same != places.end() && same->first == corners) {
      force.facet = same->second;
    } else {
      add_half_work(contact, nodes, k, force, dt);
      force = {};
    }
  }
  set_facets(contact, nodes, std::move(facets));
  contact.torn = true;
  contact.state.searched_at.clear(); // so that the next step searches anew
}

} // namespace ogive
