// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"
#include "ogive/fem/erosion.hpp"
#include "ogive/perforation/case.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Contact between the parts of a projectile, which touch instead of sharing nodes.

namespace ogive {

/// Throws SetupError unless the parts of the projectile can be held together as the case asks.
template <class T> void check_parts(const PerforationCase<T> &c) {
  require(std::isfinite(c.part_friction) && c.part_friction >= T(0), "friction between the projectile's parts",
          c.part_friction, "must not be negative");
  if (c.parts == Parts::touching && c.rigid_projectile)
    throw SetupError("parts of a rigid projectile = touching: must be tied, it moves as one");
}

/// Adds a contact for each part of a projectile whose parts touch: the nodes of all other parts may not enter it. Each
/// pair of parts has two contacts, so that neither surface can pass between the nodes of the other. All nodes of a part
/// are slaves, because those within it come to its surface where its hexes are removed. `contacts.front()` is the
/// contact of the plates with the surfaces of all parts: stiffness, time step and mirror planes are its own.
template <class T, class Body>
void add_part_contacts(std::vector<NodeToSurface<T>> &contacts, const Nodes<T> &nodes, const std::vector<Body> &parts,
                       T friction) {
  const NodeToSurface<T> plates = contacts.front();
  const ContactOptions<T> options{.friction = friction, .stiffness = plates.options.stiffness, .reentrant = true};
  for (const Body &part : parts) {
    std::vector<Facet> facets;
    for (const Facet &facet : plates.facets)
      if (facet.nodes[0] >= part.nodes.begin && facet.nodes[0] < part.nodes.end) facets.push_back(facet);
    std::vector<Index> slaves;
    for (const Body &other : parts)
      if (&other != &part)
        for (Index n = other.nodes.begin; n < other.nodes.end; ++n) slaves.push_back(n);
    std::vector<T> offset(slaves.size(), T(0));
    auto contact = make_contact(nodes, std::move(slaves), std::move(offset), std::move(facets), "parts on " + part.name,
                                options, plates.symmetry);
    contact.state.reference_time_step = plates.state.reference_time_step;
    // Hexes at a tip are far smaller than what their contact must bear.
    contact.search_margin = std::max(contact.search_margin, plates.search_margin);
    contacts.push_back(std::move(contact));
  }
}

/// Lets hexes of the projectile be removed. Its `parts` are the last bodies of the model, the first of them has the
/// number `first`; `contacts` are that of the plates and, if parts touch, one for each part.
template <class T, class Body>
void allow_erosion(std::vector<NodeToSurface<T>> &contacts, std::vector<Body> &parts, Index first) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    allow_erosion(parts[k]);
    const Index number = first + static_cast<Index>(k);
    contacts.front().eroding.push_back(number);
    if (contacts.size() > 1) contacts[1 + k].eroding.push_back(number);
  }
}

} // namespace ogive
