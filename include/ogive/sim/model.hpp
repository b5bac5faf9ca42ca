// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"
#include "ogive/contact/particle_contact.hpp"
#include "ogive/contact/tie.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/sim/conversion.hpp"
#include "ogive/sim/phases.hpp"

#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ogive {

/// Nodes that move as one, in the directions they are free in: a rigid body without rotation.
struct RigidPart {
  NodeRange nodes{}; ///< that move as one
};

/// Nodes, the bodies that connect them, and what acts between bodies. `Bodies` are kinds of bodies: an entry of the
/// tuple is one body, or a vector of several.
template <class T, class... Bodies> struct Model {
  Nodes<T> nodes;                                      ///< of all bodies
  std::tuple<Bodies...> bodies;                        ///< of particles or hexes
  SymmetryPlanes symmetry{};                           ///< mirror planes
  std::vector<NodeToSurface<T>> contacts{};            ///< between bodies
  std::vector<Tie<T>> ties{};                          ///< between bodies
  std::vector<RigidPart> rigid_parts{};                ///< bodies that do not deform
  std::vector<ParticleContact<T>> particle_contacts{}; ///< between bodies of particles
  std::vector<Conversion<T>> conversions{};            ///< bodies of hexes that turn into particles

  T time = T(0);                             ///< s, of the positions
  std::int64_t steps = 0;                    ///< made so far
  T last_step = T(0);                        ///< s, interval before the present time
  T last_mid_step = T(0);                    ///< s, interval over which the last forces changed the velocities
  PhaseTimes times{};                        ///< s of wall time, of all steps and runs
  Vec3<T> support_impulse = Vec3<T>::Zero(); ///< N s, given by held nodes to the computed part of the model
};

/// Nodes and bodies tell the type of the model.
template <class T, class... Bodies> Model(Nodes<T>, std::tuple<Bodies...>, SymmetryPlanes) -> Model<T, Bodies...>;

/// Calls `f(body)` for each body of an entry of a model: for the one that it is, or for all in a vector.
template <class Entry, class F> void for_each_body_of(Entry &entry, F &&f) {
  if constexpr (requires { entry.begin(); })
    for (auto &body : entry) f(body);
  else
    f(entry);
}

/// Calls `f(body)` for each body.
template <class M, class F> void for_each_body(M &&model, F &&f) {
  std::apply([&](auto &...entry) { (for_each_body_of(entry, f), ...); }, model.bodies);
}

/// Name of the body that a node belongs to, or "nodes".
template <class M> std::string body_of_node(const M &model, Index node) {
  std::string name = "nodes";
  for_each_body(model, [&](const auto &body) {
    if (node >= body.nodes.begin && node < body.nodes.end) name = body.name;
  });
  return name;
}

} // namespace ogive
