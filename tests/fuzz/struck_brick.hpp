// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/blocks.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/mesh/facets.hpp"

namespace fuzz {

using ogive::Index;
using sim_test::V;

/// The smallest model that has all that a checkpoint holds: particles with lists that strike two hexes with friction.
inline auto struck_brick() {
  constexpr double spacing = 1e-3;
  ogive::Nodes<double> nodes;
  const auto mesh = sim_test::brick_at(2, 1, 1, V(2e-3, 1e-3, 1e-3), V(-1e-3, 0, -1e-3));
  auto brick = add_hex_body(nodes, mesh, fem_test::steel<double>(), "brick");
  auto block = add_sph_body(nodes, sim_test::lattice(2, 1, 1, spacing, V(-1e-3, 0, 0.05e-3)), fem_test::steel<double>(),
                            "block");
  set_velocity(nodes, block.nodes, V(20, 0, -100));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), 0.5 * spacing), boundary_facets(mesh),
                              "contact", ogive::ContactOptions<double>{.friction = 0.1});
  auto model = sim_test::model_of(std::move(nodes), std::move(brick), std::move(block));
  model.contacts.push_back(std::move(contact));
  return model;
}

/// Steps until the model has made `steps` steps or its run has ended.
template <class M> void run_to(M &model, ogive::RunState<double> &state, std::int64_t steps) {
  run(
      model, ogive::RunOptions<double>{.end_time = 1}, state, [](const auto &, const auto &) { return true; },
      [&](const auto &m, const auto &) { return m.steps >= steps; });
}

} // namespace fuzz
