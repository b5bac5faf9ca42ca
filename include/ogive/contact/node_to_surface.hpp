// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/mesh/hex_mesh.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ogive {

/// Penalty and friction of a contact.
template <class T> struct ContactOptions {
  T friction = T(0);          ///< Coulomb's coefficient
  T stiffness = T(0.1);       ///< penalty stiffness over m/dt^2
  T sticking = T(0.3);        ///< largest friction force over m |v_t|/dt
  bool rigid_masters = false; ///< the masses of the facets' nodes do not limit the stiffness
  bool reentrant = false;     ///< the surface has inner edges, so that the nearest facet alone does not give the side
};

/// The contact force on one slave node and its place on the surface.
template <class T> struct ContactForce {
  Index facet = -1;                   ///< the facet touched; -1: no contact
  std::int16_t lost = 0;              ///< 1: so deep behind the surface that nothing pushes the slave back
  Reflection reflection{};            ///< in which the slave sees the facet, if it was pushed across a mirror plane
  std::array<T, 4> weights{};         ///< of the facet's nodes
  Vec3<T> normal = Vec3<T>::Zero();   ///< normal force on the slave, N
  Vec3<T> friction = Vec3<T>::Zero(); ///< friction force on the slave, N
};

/// Slaves that are near the surface or have been pushed by it, and what only they have. They are few: of a plate's
/// particles those around the projectile.
template <class T> struct NearSlaves {
  std::vector<Index> slaves;           ///< their numbers in the contact, ascending
  std::vector<ContactForce<T>> forces; ///< one for each of them, as all that follows
  std::vector<T> normal_energy;        ///< J, work taken by the penalty springs
  std::vector<T> friction_energy;      ///< J
  std::vector<T> room;                 ///< m, how far slave and surface may still approach before they can touch
  std::vector<Vec3<T>> checked_at;     ///< positions at the last check, m
};

/// The state of a contact in a run.
template <class T> struct ContactState {
  std::vector<T> slave_mass;               ///< kg; 0: deactivated
  T reference_time_step{};                 ///< s, of the stiffness; 0: that of the first step
  Index lost = -1;                         ///< the first slave that got lost behind the surface; -1: none
  std::vector<Vec3<T>> searched_at;        ///< positions of all nodes at the last search, m
  NearSlaves<T> near;                      ///< all other slaves have no force, work or room
  std::vector<Vec3<T>> masters_checked_at; ///< positions of the masters at the last check of the slaves, m
};

/// Slaves that may touch the surface, and facets that they may touch: made anew by each search.
template <class T> struct FacetCandidates {
  std::vector<Index> active;   ///< slaves that have candidates
  std::vector<Index> entry;    ///< of each active slave among the near ones
  std::vector<Index> begin;    ///< of each active slave in `facets`, and the end
  std::vector<Index> facets;   ///< grouped by active slave
  std::vector<Vec3<T>> middle; ///< m, of each facet of the surface, of this step
  std::vector<T> radius;       ///< m, of each facet around its middle, of this step
};

/// Nodes against facets: slave nodes (particles as spheres of radius `offset`) may not enter the surface that the
/// master facets make up. Penalty with Coulomb friction; the reaction goes to the facet's nodes.
template <class T> struct NodeToSurface {
  std::string name;                          ///< for messages
  ContactOptions<T> options{};               ///< penalty and friction
  SymmetryPlanes symmetry{};                 ///< mirror planes of the model
  std::vector<Index> slaves;                 ///< node numbers
  std::vector<T> offset;                     ///< m, one for each slave
  std::vector<Facet> facets;                 ///< masters, outward
  std::vector<Index> eroding;                ///< bodies whose exposed faces the facets are, see sim/erosion.hpp
  bool torn = false;                         ///< hexes behind the facets have been removed: it may have any form
  std::vector<Index> masters;                ///< the nodes of the facets, each once
  std::vector<std::array<T, 4>> master_mass; ///< kg, of each facet's nodes with their mirror images; empty: rigid
  T search_margin{};                         ///< m, how far slave and facet may approach before the next search
  ContactState<T> state;                     ///< changes in each step
  FacetCandidates<T> candidates;             ///< for the present step
};

/// Gives the contact these master facets, with the masses of their nodes.
template <class T> void set_facets(NodeToSurface<T> &c, const Nodes<T> &nodes, std::vector<Facet> facets) {
  c.facets = std::move(facets);
  c.candidates.middle.resize(c.facets.size());
  c.candidates.radius.resize(c.facets.size());
  std::vector<bool> is_master(nodes.position.size(), false);
  c.masters.clear();
  for (const Facet &f : c.facets)
    for (Index n : f.nodes)
      if (!is_master[n]) is_master[n] = true, c.masters.push_back(n);
  c.master_mass.clear();
  if (c.options.rigid_masters) return;
  for (const Facet &f : c.facets) {
    auto &mass = c.master_mass.emplace_back();
    for (int k = 0; k < 4; ++k)
      mass[k] = nodes.mass[f.nodes[k]] * T(nodes.held[f.nodes[k]] & held_x && c.symmetry.x ? 2 : 1) *
                T(nodes.held[f.nodes[k]] & held_y && c.symmetry.y ? 2 : 1);
  }
}

/// Makes a contact of `slaves` (with an offset each, m) against `facets`. Throws SetupError for a slave without mass
/// (make contacts before ties), for a negative friction, and if a slave is a node of a facet.
template <class T>
NodeToSurface<T> make_contact(const Nodes<T> &nodes, std::vector<Index> slaves, std::vector<T> offset,
                              std::vector<Facet> facets, std::string name, ContactOptions<T> options = {},
                              SymmetryPlanes symmetry = {}) {
  require(options.friction >= T(0) && std::isfinite(options.friction), name + " friction", options.friction,
          "must not be negative");
  require(offset.size() == slaves.size(), name + " offsets", offset.size(), "there must be one for each slave");
  require(!facets.empty(), name + " facets", 0, "there must be at least one");
  NodeToSurface<T> c;
  c.name = std::move(name);
  c.options = options;
  c.symmetry = symmetry;
  std::vector<bool> is_master(nodes.position.size(), false);
  T edge{};
  for (const Facet &f : facets) {
    for (Index n : f.nodes) is_master[n] = true;
    edge = std::max(edge, (nodes.position[f.nodes[0]] - nodes.position[f.nodes[1]]).norm());
  }
  T smallest = edge;
  for (const Facet &f : facets)
    for (int k = 0; k < 4; ++k)
      smallest = std::min(smallest, (nodes.position[f.nodes[k]] - nodes.position[f.nodes[(k + 1) % 4]]).norm());
  for (T o : offset) c.search_margin = std::max(c.search_margin, T(1.5) * o);
  c.search_margin = std::max(c.search_margin, smallest);
  c.state.slave_mass.reserve(slaves.size());
  for (Index s : slaves) {
    require(nodes.mass[s] > T(0), c.name + " mass of slave node " + std::to_string(s), nodes.mass[s],
            "must be positive (make contacts before ties)");
    require(!is_master[s], c.name + " slave node", s, "must not belong to a facet");
    c.state.slave_mass.push_back(nodes.mass[s]);
  }
  c.slaves = std::move(slaves);
  c.offset = std::move(offset);
  set_facets(c, nodes, std::move(facets));
  return c;
}

} // namespace ogive
