// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/particle_search.hpp"
#include "ogive/contact/search.hpp"
#include "ogive/fem/hex_body.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/sph/body.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ogive {

/// An array that has `full` entries, or none before the first step.
template <class Values> struct FullOrEmpty {
  Values &values;   ///< the array
  std::size_t full; ///< its length unless it is empty
};

/// Deduced from the array.
template <class Values> FullOrEmpty(Values &, std::size_t) -> FullOrEmpty<Values>;

/// An array that has up to `most` entries.
template <class Values> struct UpTo {
  Values &values;   ///< the array
  std::size_t most; ///< its greatest length
};

/// Deduced from the array.
template <class Values> UpTo(Values &, std::size_t) -> UpTo<Values>;

/// Calls `f(name, value)` for all of the state of a body of hexes that is not a material point's.
template <BodyOfHexes Body, class F> void for_each_own_field(Body &body, F &&f) {
  for_each_hex_field(body, [&](const char *name, const char *, auto &values) { f(name, values); });
}

/// Calls `f(name, value)` for all of the state of a body of particles that is not a material point's.
template <BodyOfParticles Body, class F> void for_each_own_field(Body &body, F &&f) {
  f("viscous_energy", body.viscous_energy);
  f("moments of bonds", body.bonds.moment);
  f("energy of bonds", body.bonds.energy);
  f("support of the lists", body.neighbours.support);
  FullOrEmpty built_at{body.neighbours.built_at, body.point_mass.size()};
  f("positions of the lists", built_at);
}

/// Calls `f(name, value)` for all that a run changes and needs to resume with the same bits: the one list that
/// checkpoints write and read. A value is a number, a vector of fixed length, an array whose length the model gives,
/// FullOrEmpty or UpTo. What a step makes anew is left out, and so are lists that `renew_lists` makes from what is
/// here.
template <class M, class R, class F> void for_each_state_field(M &model, R &run, F &&f) {
  f("time", model.time);
  f("steps", model.steps);
  f("last step", model.last_step);
  f("last middle step", model.last_mid_step);
  f("support impulse", model.support_impulse);
  f("wall times", model.times.seconds);
  for_each_run_field(run, f);

  const std::size_t nodes = model.nodes.position.size();
  for_each_node_field(model.nodes, [&](const char *name, const char *, auto &values) { f(name, values); });
  f("force", model.nodes.force);
  for_each_body(model, [&](auto &body) {
    const auto field = [&](const char *name, auto &values) { f(body.name + " " + name, values); };
    const auto named = [&](const char *name, const char *, auto &values) { field(name, values); };
    field("velocity_gradient", body.points.velocity_gradient);
    for_each_point_field(body.points, named);
    for_each_yield_field(body.points, named);
    for_each_own_field(body, field);
  });
  for (auto &contact : model.contacts) {
    const auto field = [&](const char *name, auto &&values) { f(contact.name + " " + name, values); };
    field("slave_mass", contact.state.slave_mass);
    field("reference_time_step", contact.state.reference_time_step);
    field("lost", contact.state.lost);
    FullOrEmpty searched_at{contact.state.searched_at, nodes};
    field("positions of the search", searched_at);
    const auto near = [&](const char *name, auto &values) { field(name, UpTo{values, contact.slaves.size()}); };
    near("near slaves", contact.state.near.slaves);
    near("forces", contact.state.near.forces);
    near("normal_energy", contact.state.near.normal_energy);
    near("friction_energy", contact.state.near.friction_energy);
    near("room", contact.state.near.room);
    near("positions of the last check", contact.state.near.checked_at);
    field("positions of the masters", UpTo{contact.state.masters_checked_at, nodes});
  }
  for (auto &contact : model.particle_contacts) {
    const auto field = [&](const char *name, auto &values) { f(contact.name + " " + name, values); };
    field("volume", contact.volume);
    field("forces", contact.forces);
    field("normal_energy", contact.normal_energy);
    field("lost", contact.lost);
    FullOrEmpty searched_at{contact.searched_at, contact.volume.size()};
    field("positions of the search", searched_at);
  }
  for (auto &part : model.rigid_parts) {
    if (!turns(part)) continue;
    f("centre of a rigid part", part.centre);
    f("scalar of its orientation", part.orientation.scalar);
    f("vector of its orientation", part.orientation.vector);
    f("velocity of a rigid part", part.velocity);
    f("angular momentum of a rigid part", part.angular_momentum);
  }
}

/// Makes the neighbour lists of a body anew, from the positions that they were made from.
template <class T, class Law, class K, class F> void renew_lists(SphBody<T, Law, K, F> &body) {
  if (const std::vector<Vec3<T>> built_at = body.neighbours.built_at; !built_at.empty())
    build_lists(body, std::span<const Vec3<T>>(built_at), body.neighbours.support);
}

/// Nothing: hexes have no lists.
template <class T, class Law, class Rule> void renew_lists(HexBody<T, Law, Rule> &) {}

/// Makes the neighbour lists and the candidates of contacts anew, from the positions that they were made from: the same
/// lists to the last entry, so that all sums have the same order.
template <class T, class Bodies> void renew_lists(Model<T, Bodies> &model) {
  for_each_body(model, [](auto &body) { renew_lists(body); });
  for (auto &contact : model.contacts) {
    if (contact.state.searched_at.empty()) continue;
    Nodes<T> then;
    then.position = contact.state.searched_at;
    search(contact, then);
  }
  for (auto &contact : model.particle_contacts)
    if (const std::vector<Vec3<T>> then = contact.searched_at; !then.empty())
      search(contact, std::span<const Vec3<T>>(then));
}

} // namespace ogive
