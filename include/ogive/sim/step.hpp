// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/force.hpp"
#include "ogive/contact/particle_force.hpp"
#include "ogive/contact/tie.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/material/stress_update.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sim/rigid_part.hpp"
#include "ogive/sph/force.hpp"
#include "ogive/sph/gradient.hpp"

namespace ogive {

/// Sets all forces to zero.
template <class T> void clear_forces(Nodes<T> &nodes) {
  parallel_for(nodes.size(), [&](Index n) { nodes.force[n] = Vec3<T>::Zero(); });
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

/// Moves the stress of a body of particles through the interval `dt_old` (s) that ended at the present positions, and
/// adds its internal forces to the nodes.
template <class T, class Law, class K, class F>
void update_body(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt_old, Lap &lap) {
  prepare(body, nodes);
  lap(Phase::neighbours);
  velocity_gradient(body);
  lap(Phase::gradient);
  update_stress(body, dt_old);
  lap(Phase::stress);
  add_internal_force(body, nodes, dt_old);
  lap(Phase::force);
}

/// update_body() for a body of hexes.
template <class T, class Law, class Rule>
void update_body(HexBody<T, Law, Rule> &body, Nodes<T> &nodes, T dt_old, Lap &lap) {
  velocity_gradient(body, nodes);
  update_stress(body, dt_old);
  add_internal_force(body, nodes, dt_old);
  lap(Phase::hexes);
}

/// Adds the forces of all contacts, which no longer push removed material.
template <class M, class T> void add_contact_forces(M &model, T dt_old, T dt) {
  for (auto &contact : model.contacts) {
    for_each_body(model, [&](const auto &body) { release_removed(contact, body); });
    add_contact_force(contact, model.nodes, dt_old, dt);
  }
  for (auto &contact : model.particle_contacts) {
    for_each_body(model, [&](const auto &body) { release_removed(contact, body); });
    add_contact_force(contact, model.nodes, dt_old);
  }
}

/// One explicit time step of `dt` (s), central differences: the whole method. With t(n) the time on entry,
///
///     on entry   positions x(n),   velocities v(n-1/2), stresses s(n-1)   dt_old = t(n) - t(n-1)
///     on exit    positions x(n+1), velocities v(n+1/2), stresses s(n)     dt     = t(n+1) - t(n)
///
/// and forces f(n), which change the velocities over dt_mid = t(n+1/2) - t(n-1/2).
template <class M, class T> void step(M &model, T dt) {
  Nodes<T> &nodes = model.nodes;
  const T dt_old = model.last_step, dt_mid = T(0.5) * (dt_old + dt);
  Lap lap(model.times);
  clear_forces(nodes);
  lap(Phase::motion);
  for_each_body(model, [&](auto &body) { update_body(body, nodes, dt_old, lap); });
  add_contact_forces(model, dt_old, dt);
  lap(Phase::contact);
  for (const auto &tie : model.ties) hand_over_forces(tie, nodes);
  for (auto &part : model.rigid_parts) rigidify(part, nodes, dt_mid, dt);
  model.support_impulse += support_impulse(nodes, dt_mid);
  integrate(nodes, dt_mid, dt);
  for (const auto &tie : model.ties) move_slaves(tie, nodes);
  model.time += dt;
  model.last_step = dt;
  model.last_mid_step = dt_mid;
  ++model.steps;
  lap(Phase::motion);
}

} // namespace ogive
