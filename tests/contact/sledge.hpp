// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/box.hpp"

namespace contact_test {

/// Four masses that lie on a fixed slab, pressed down by `gravity` and pulled along x.
struct Sledge {
  static constexpr double gravity = 1e7, mass = 1e-4, offset = 0.5e-3; ///< m/s2, kg, m
  double dt;                                                           ///< s
  Nodes<double> nodes;
  NodeToSurface<double> contact;
  NodeRange runners;

  explicit Sledge(double friction, double step = 1e-7) : dt(step) {
    const Surface slab = add_surface(nodes, fem_test::brick<double>(6, 3, 1, V(6e-3, 3e-3, 1e-3)));
    // The penalty spring k = 0.1 m/dt^2 carries the weight at the depth 10 g dt^2.
    const double z = 1e-3 + offset - 10 * gravity * dt * dt;
    runners = add_free(nodes, {V(1e-3, 1e-3, z), V(2e-3, 1e-3, z), V(1e-3, 2e-3, z), V(2e-3, 2e-3, z)}, mass);
    contact = contact_of(nodes, runners, offset, slab.facets, {.friction = friction});
  }

  /// A step; each mass is pulled with `pull` (N).
  void advance(double pull) {
    clear(nodes);
    for (Index n = runners.begin; n < runners.end; ++n) nodes.force[n] = V(pull, 0, -mass * gravity);
    add_contact_force(contact, nodes, dt, dt);
    move(nodes, runners, dt);
  }
};

} // namespace contact_test
