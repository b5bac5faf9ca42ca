// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/blocks.hpp"

#include "ogive/mesh/facets.hpp"

namespace sim_test {

/// What an elastic impact of two bodies has kept, in shares.
struct Strike {
  double momentum_error; ///< change over the momentum
  double energy_error;   ///< largest change of the total energy
  double stored;         ///< largest energy of the contact's springs
  double left;           ///< energy of the springs in the end
  double restitution;    ///< relative velocity after over before
};

inline constexpr double strike_edge = 1e-3, strike_speed = 20; ///< m, m/s

/// A block that strikes a free hex block below it. `make(nodes, z)` adds the block above the height z and returns it;
/// its nodes are spheres with the radius `offset` (m).
template <class Make> Strike strike(double offset, Make &&make) {
  Nodes<double> nodes;
  const auto mesh = brick_at(5, 5, 4, V(5e-3, 5e-3, 4e-3), V(-2.5e-3, -2.5e-3, -4e-3));
  auto target = add_hex_body(nodes, mesh, fem_test::steel<double>(), "target");
  auto block = make(nodes, offset + 0.05 * strike_edge);
  set_velocity(nodes, block.nodes, V(0, 0, -strike_speed));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact =
      make_contact(nodes, slaves, std::vector<double>(slaves.size(), offset), boundary_facets(mesh), "contact");
  const NodeRange flying = block.nodes, struck = target.nodes;
  auto model = model_of(std::move(nodes), std::move(target), std::move(block));
  model.contacts.push_back(std::move(contact));

  const V p = momentum(model);
  const double e = total(energy(model)), dt = stable_time_step(model), crossing = 4e-3 / 6000;
  Strike result{};
  while (model.time < 8 * crossing) {
    step(model, dt);
    const Energy<double> now = energy(model);
    result.stored = std::max(result.stored, now.contact / e);
    result.energy_error = std::max(result.energy_error, std::abs(total(now) / e - 1));
  }
  result.left = std::abs(energy(model).contact) / e;
  result.momentum_error = (momentum(model) - p).norm() / p.norm();
  result.restitution = (mean_velocity(model.nodes, flying)[2] - mean_velocity(model.nodes, struck)[2]) / strike_speed;
  return result;
}

inline Strike strike_with_hexes() {
  return strike(0, [](Nodes<double> &nodes, double z) {
    return add_hex_body(nodes, brick_at(3, 3, 3, V(3e-3, 3e-3, 3e-3), V(-1.5e-3 + 0.2e-3, -1.5e-3, z)),
                        fem_test::steel<double>(), "block");
  });
}

inline Strike strike_with_particles() {
  return strike(0.5 * strike_edge, [](Nodes<double> &nodes, double z) {
    return add_sph_body(nodes, lattice(3, 3, 3, strike_edge, V(-1.5e-3, -1.5e-3, z - 0.5 * strike_edge)),
                        fem_test::steel<double>(), "block");
  });
}

} // namespace sim_test
