// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/brick.hpp"

#include "ogive/contact/force.hpp"
#include "ogive/mesh/facets.hpp"

#include <algorithm>
#include <vector>

namespace contact_test {

using namespace ogive;
using fem_test::V;

/// Nodes of a mesh with the mass `mass` each, and its facets.
struct Surface {
  NodeRange nodes;
  std::vector<Facet> facets;
};

inline Surface add_surface(Nodes<double> &nodes, const HexMesh<double> &mesh, double mass = 1.0) {
  Surface s;
  s.nodes = add_nodes(nodes, mesh.positions);
  for (Index n = s.nodes.begin; n < s.nodes.end; ++n) nodes.mass[n] = mass;
  s.facets = shifted(boundary_facets(mesh), s.nodes.begin);
  return s;
}

/// Free nodes of the mass `mass` each.
inline NodeRange add_free(Nodes<double> &nodes, const std::vector<V> &positions, double mass) {
  const NodeRange range = add_nodes(nodes, positions);
  for (Index n = range.begin; n < range.end; ++n) nodes.mass[n] = mass;
  return range;
}

inline std::vector<Index> indices(NodeRange range) {
  std::vector<Index> list;
  for (Index n = range.begin; n < range.end; ++n) list.push_back(n);
  return list;
}

inline NodeToSurface<double> contact_of(const Nodes<double> &nodes, NodeRange slaves, double offset,
                                        const std::vector<Facet> &facets, ContactOptions<double> options = {},
                                        SymmetryPlanes planes = {}) {
  return make_contact(nodes, indices(slaves), std::vector<double>(slaves.size(), offset), facets, "contact", options,
                      planes);
}

inline void clear(Nodes<double> &nodes) {
  for (V &f : nodes.force) f.setZero();
}

/// Central differences for a range of nodes.
inline void move(Nodes<double> &nodes, NodeRange range, double dt) {
  for (Index n = range.begin; n < range.end; ++n) {
    nodes.velocity[n] += dt / nodes.mass[n] * nodes.force[n];
    nodes.position[n] += dt * nodes.velocity[n];
  }
}

} // namespace contact_test
