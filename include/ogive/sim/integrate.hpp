// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/sim/model.hpp"

namespace ogive {

/// Sets all forces to zero.
template <class T> void clear_forces(Nodes<T> &nodes) {
  parallel_for(nodes.size(), [&](Index n) { nodes.force[n] = Vec3<T>::Zero(); });
}

/// Gives the nodes of a rigid part the forces that accelerate them as one.
template <class T> void rigidify(const RigidPart &part, Nodes<T> &nodes) {
  const Index begin = part.nodes.begin, n = part.nodes.size();
  const T mass = ordered_sum(n, T(0), [&](Index i) { return nodes.mass[begin + i]; });
  const Vec3<T> force = ordered_sum(n, Vec3<T>(Vec3<T>::Zero()), [&](Index i) { return nodes.force[begin + i]; });
  std::uint8_t held = held_none;
  for (Index i = 0; i < n; ++i) held |= nodes.held[begin + i];
  Vec3<T> acceleration = force / mass;
  for (int d = 0; d < 3; ++d)
    if (held & (1 << d)) acceleration[d] = T(0);
  parallel_for(n, [&](Index i) { nodes.force[begin + i] = nodes.mass[begin + i] * acceleration; });
}

/// Impulse that the supports give over `dt_mid` (s): minus the force on held nodes, in the held directions, N s.
template <class T> Vec3<T> support_impulse(const Nodes<T> &nodes, T dt_mid) {
  return ordered_sum(nodes.size(), Vec3<T>(Vec3<T>::Zero()), [&](Index n) -> Vec3<T> {
    Vec3<T> reaction = Vec3<T>::Zero();
    for (int d = 0; d < 3; ++d)
      if (nodes.held[n] & (1 << d)) reaction[d] = -dt_mid * nodes.force[n][d];
    return reaction;
  });
}

/// Central differences: v += dt_mid f/m with held directions kept at rest, x += dt v. Tied slaves have no mass and
/// stay.
template <class T> void integrate(Nodes<T> &nodes, T dt_mid, T dt) {
  parallel_for(nodes.size(), [&](Index n) {
    if (nodes.mass[n] == T(0)) return;
    Vec3<T> &f = nodes.force[n], &v = nodes.velocity[n];
    for (int d = 0; d < 3; ++d)
      if (nodes.held[n] & (1 << d)) f[d] = v[d] = T(0);
    v += dt_mid / nodes.mass[n] * f;
    nodes.position[n] += dt * v;
  });
}

} // namespace ogive
