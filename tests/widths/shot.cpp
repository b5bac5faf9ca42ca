// SPDX-License-Identifier: BSD-3-Clause
#include "widths/shot.hpp"
#include "sim/blocks.hpp"

#include "ogive/contact/force.hpp"
#include "ogive/mesh/facets.hpp"

using namespace sim_test;

// OGIVE_SHOT is one of the functions of shot.hpp.
Outcome OGIVE_SHOT() {
  const auto metal = fem_test::steel(400e6);
  SphOptions<double> options;
  options.control.stiffness = 0.3;
  Nodes<double> nodes;
  auto block = add_sph_body(nodes, lattice(5, 5, 5, 1e-3), metal, "block", {}, options);
  const auto mesh = brick_at(3, 3, 3, V(9e-3, 9e-3, 9e-3), V(-2e-3, -2e-3, -9e-3));
  auto brick = add_hex_body(nodes, mesh, metal, "brick");
  set_velocity(nodes, block.nodes, V(0, 0, -200));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), 0.5e-3),
                              shifted(boundary_facets(mesh), brick.nodes.begin), "contact");
  auto model = model_of(std::move(nodes), std::move(block), std::move(brick));
  model.contacts.push_back(std::move(contact));
  for (int k = 0; k < 200; ++k) step(model, stable_time_step(model));
  const Energy<double> e = energy(model);
  return {lanes<double>, static_cast<int>(std::get<0>(model.bodies).neighbours.order.size()), e.kinetic, e.plastic,
          total(e)};
}
