// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/force.hpp"
#include "ogive/contact/particle_force.hpp"
#include "ogive/contact/release.hpp"
#include "ogive/contact/tie.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/material/stress_update.hpp"
#include "ogive/sim/convert.hpp"
#include "ogive/sim/integrate.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/force.hpp"
#include "ogive/sph/gradient.hpp"

namespace ogive {

/// One explicit time step of `dt` (s), central differences: the whole method.
template <class M, class T> void step(M &model, T dt) {
  Nodes<T> &nodes = model.nodes;
  const T before = model.last_step, kick = T(0.5) * (before + dt);
  Lap lap(model.times);
  clear_forces(nodes), lap(Phase::motion);
  for_each_body(model, [&](auto &body) {
    prepare(body, nodes), lap(phase_of(body, Phase::neighbours));
    velocity_gradient(body, nodes), lap(phase_of(body, Phase::gradient));
    update_stress(body, before), lap(phase_of(body, Phase::stress));
    add_internal_force(body, nodes, before), lap(phase_of(body, Phase::force));
  });
  for (auto &contact : model.contacts) {
    for_each_body(model, [&](const auto &body) { release_removed(contact, body); });
    add_contact_force(contact, nodes, before, dt), lap(Phase::contact);
  }
  for (auto &contact : model.particle_contacts) {
    for_each_body(model, [&](const auto &body) { release_removed(contact, body); });
    add_contact_force(contact, nodes, before), lap(Phase::contact);
  }
  for (const auto &tie : model.ties) hand_over_forces(tie, nodes);
  for (const auto &part : model.rigid_parts) rigidify(part, nodes);
  model.support_impulse += support_impulse(nodes, kick);
  integrate(nodes, kick, dt);
  for (const auto &tie : model.ties) move_slaves(tie, nodes);
  model.time += dt;
  model.last_step = dt;
  model.last_kick = kick;
  ++model.steps, lap(Phase::motion);
  for (auto &conversion : model.conversions) convert(conversion, model), lap(Phase::hexes);
}

} // namespace ogive
