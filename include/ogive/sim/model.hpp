// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"
#include "ogive/contact/particle_contact.hpp"
#include "ogive/contact/tie.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/sim/phases.hpp"
#include "ogive/sim/rigid_part.hpp"

#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// The bodies of a model: a tuple, in which each is one body of particles or hexes, or those of a perforation.

namespace ogive {

/// The bodies of a perforation. A plate has particles where the projectile destroys it and hexes around them.
template <class Particles, class Hexes, class Projectile> struct PerforationBodies {
  std::vector<Particles> plate_particles; ///< of each plate, from front to rear
  std::vector<Hexes> plate_hexes;         ///< of each plate, from front to rear
  std::vector<Projectile> projectile;     ///< its parts, at least one, a metal each: on the same nodes, or on their own
};

///@{
/// Calls `f(body)` for each body, in a fixed order.
template <class... Bodies, class F> void for_each_body_of(std::tuple<Bodies...> &bodies, F &&f) {
  std::apply([&](auto &...body) { (f(body), ...); }, bodies);
}
template <class... Bodies, class F> void for_each_body_of(const std::tuple<Bodies...> &bodies, F &&f) {
  std::apply([&](const auto &...body) { (f(body), ...); }, bodies);
}
template <class P, class H, class S, class F> void for_each_body_of(PerforationBodies<P, H, S> &bodies, F &&f) {
  for (P &particles : bodies.plate_particles) f(particles);
  for (H &hexes : bodies.plate_hexes) f(hexes);
  for (S &part : bodies.projectile) f(part);
}
template <class P, class H, class S, class F> void for_each_body_of(const PerforationBodies<P, H, S> &bodies, F &&f) {
  for (const P &particles : bodies.plate_particles) f(particles);
  for (const H &hexes : bodies.plate_hexes) f(hexes);
  for (const S &part : bodies.projectile) f(part);
}
///@}

/// Nodes, the bodies that connect them, and what acts between bodies. `Bodies` is a std::tuple of them, or
/// PerforationBodies.
template <class T, class Bodies> struct Model {
  Nodes<T> nodes;                                      ///< of all bodies
  Bodies bodies;                                       ///< of particles or hexes
  SymmetryPlanes symmetry{};                           ///< mirror planes
  std::vector<NodeToSurface<T>> contacts{};            ///< between bodies
  std::vector<Tie<T>> ties{};                          ///< between bodies
  std::vector<RigidPart<T>> rigid_parts{};             ///< bodies that do not deform
  std::vector<ParticleContact<T>> particle_contacts{}; ///< between bodies of particles

  T time = T(0);                             ///< s, of the positions
  std::int64_t steps = 0;                    ///< made so far
  T last_step = T(0);                        ///< s, interval before the present time
  T last_mid_step = T(0);                    ///< s, interval over which the last forces changed the velocities
  PhaseTimes times{};                        ///< s of wall time, of all steps and runs
  Vec3<T> support_impulse = Vec3<T>::Zero(); ///< N s, given by held nodes to the computed part of the model
};

/// Deduced from nodes and bodies.
template <class T, class Bodies> Model(Nodes<T>, Bodies, SymmetryPlanes) -> Model<T, Bodies>;

/// Calls `f(body)` for each body of a model, in a fixed order.
template <class M, class F> void for_each_body(M &&model, F &&f) { for_each_body_of(model.bodies, f); }

} // namespace ogive
