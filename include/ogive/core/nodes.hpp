// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/types.hpp"

#include <cstdint>
#include <vector>

namespace ogive {

/// Directions in which a node is held; combine with |.
enum Held : std::uint8_t { held_none = 0, held_x = 1, held_y = 2, held_z = 4, held_all = 7 };

/// Consecutive nodes [begin, end) of one body.
struct NodeRange {
  Index begin = 0; ///< first node
  Index end = 0;   ///< one past the last node
  /// Number of nodes.
  Index size() const { return end - begin; }
};

/// Nodes of finite elements and SPH particles, in one list. Velocities belong to the half step before the time of the
/// positions (central differences).
template <class T> struct Nodes {
  std::vector<Vec3<T>> position;  ///< m
  std::vector<Vec3<T>> velocity;  ///< m/s
  std::vector<Vec3<T>> force;     ///< N
  std::vector<T> mass;            ///< kg
  std::vector<std::uint8_t> held; ///< bits of Held: symmetry planes and supports

  /// Number of nodes.
  Index size() const { return static_cast<Index>(position.size()); }
};

/// Appends `positions` (m) as nodes at rest, without mass, and returns their range.
template <class T> NodeRange add_nodes(Nodes<T> &nodes, const std::vector<Vec3<T>> &positions) {
  const Index begin = nodes.size();
  nodes.position.insert(nodes.position.end(), positions.begin(), positions.end());
  const auto total = nodes.position.size();
  nodes.velocity.resize(total, Vec3<T>::Zero());
  nodes.force.resize(total, Vec3<T>::Zero());
  nodes.mass.resize(total, T(0));
  nodes.held.resize(total, held_none);
  return {begin, nodes.size()};
}

/// Calls `f(name, unit, values)` for each field of the nodes that belongs to the state.
template <class N, class F> void for_each_node_field(N &&nodes, F &&f) {
  f("position", "m", nodes.position);
  f("velocity", "m/s", nodes.velocity);
  f("mass", "kg", nodes.mass);
}

/// Gives all nodes of a range the velocity `v`, m/s.
template <class T> void set_velocity(Nodes<T> &nodes, NodeRange range, const Vec3<T> &v) {
  for (Index n = range.begin; n < range.end; ++n) nodes.velocity[n] = v;
}

} // namespace ogive
