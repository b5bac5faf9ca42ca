// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/brick.hpp"

#include "ogive/contact/particle_force.hpp"

#include <numeric>
#include <vector>

namespace contact_test {

using namespace ogive;
using fem_test::V;

/// Two lattices of particles, one above the other: from z = 0 upwards and downwards.
struct Stack {
  static constexpr double spacing = 1e-3, modulus = 1e11; ///< m, Pa
  Nodes<double> nodes;
  NodeRange upper, lower;
  ParticleContact<double> contact;

  /// n x n x layers particles each, from x = y = 0; the upper ones shifted by `shift` (m) and raised by `gap` (m).
  explicit Stack(Index n = 8, Index layers = 4, const V &shift = V::Zero(), double gap = 0, SymmetryPlanes planes = {},
                 double first = 0) {
    upper = add(n, layers, shift + V(first, first, gap));
    lower = add(n, layers, V(first, first, -layers * spacing));
    const std::vector<double> volumes(upper.size(), spacing * spacing * spacing);
    contact = make_particle_contact<double>(nodes, {{upper, volumes, spacing, -gap}, {lower, volumes, spacing, 0}},
                                            modulus, "stack", planes);
  }

  NodeRange add(Index n, Index layers, const V &corner) {
    std::vector<V> positions;
    for (Index k = 0; k < layers; ++k)
      for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) positions.emplace_back(corner + spacing * V(i + 0.5, j + 0.5, k + 0.5));
    const NodeRange range = add_nodes(nodes, positions);
    for (Index i = range.begin; i < range.end; ++i) nodes.mass[i] = 7850 * spacing * spacing * spacing;
    return range;
  }

  void move_upper(const V &by) {
    for (Index i = upper.begin; i < upper.end; ++i) nodes.position[i] += by;
  }

  /// Forces of the contact alone.
  void press(double dt = 0) {
    for (V &f : nodes.force) f.setZero();
    add_contact_force(contact, nodes, dt);
  }

  V force_on(NodeRange range) const {
    return std::accumulate(nodes.force.begin() + range.begin, nodes.force.begin() + range.end, V(V::Zero()));
  }

  /// Energy sum V_i K/2 (c_i - t_i)^2 as it is now, J.
  double potential() const {
    double sum = 0;
    for (Index i = 0; i < contact.nodes.size(); ++i)
      sum += 0.5 * contact.volume[i] * pressing(contact, i) * pressing(contact, i) / contact.stiffness;
    return sum;
  }
};

} // namespace contact_test
