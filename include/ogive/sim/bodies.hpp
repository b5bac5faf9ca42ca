// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>
#include <vector>

/// \file
/// The bodies of a model: a tuple, in which each is one body of particles or hexes, or those of a perforation.

namespace ogive {

/// The bodies of a perforation. A plate has particles where the projectile destroys it and hexes around them, or is all
/// hexes, of which hex i turns into particle i.
template <class Particles, class Hexes, class Projectile> struct PerforationBodies {
  std::vector<Particles> plate_particles; ///< of each plate, from front to rear
  std::vector<Hexes> plate_hexes;         ///< of each plate, from front to rear
  Projectile projectile;                  ///< of hexes
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
  f(bodies.projectile);
}
template <class P, class H, class S, class F> void for_each_body_of(const PerforationBodies<P, H, S> &bodies, F &&f) {
  for (const P &particles : bodies.plate_particles) f(particles);
  for (const H &hexes : bodies.plate_hexes) f(hexes);
  f(bodies.projectile);
}
///@}

} // namespace ogive
