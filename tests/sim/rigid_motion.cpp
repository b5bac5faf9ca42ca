// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/blocks.hpp"

using namespace sim_test;

namespace {

auto block_and_brick() {
  Nodes<double> nodes;
  auto particles =
      add_sph_body(nodes, lattice(5, 4, 4, 1e-3, V(-2.5e-3, -2e-3, 0)), fem_test::steel<double>(), "particles");
  auto hexes = add_hex_body(nodes, brick_at(4, 3, 3, V(4e-3, 3e-3, 3e-3), V(-2e-3, -1.5e-3, 6e-3)),
                            fem_test::steel<double>(), "hexes");
  return model_of(std::move(nodes), std::move(particles), std::move(hexes));
}

} // namespace

TEST_CASE("a body in free flight keeps its velocity and energy to the last bit", "[sim]") {
  auto model = block_and_brick();
  const V velocity(211.3, -87.1, -300.7);
  set_velocity(model.nodes, {0, model.nodes.size()}, velocity);
  const double before = energy(model).kinetic, dt = stable_time_step(model);
  const V start = model.nodes.position[7];
  for (int i = 0; i < 200; ++i) step(model, dt);
  // Nothing but velocity differences enters a stress, and those are zero exactly.
  for (const V &v : model.nodes.velocity) REQUIRE(v == velocity);
  CHECK(energy(model).kinetic == before);
  CHECK(total(energy(model)) == before);
  CHECK((model.nodes.position[7] - start - 200 * dt * velocity).norm() < 1e-13);
}

TEST_CASE("bodies that spin by a quarter turn bear no stress but the centrifugal one", "[sim]") {
  auto model = block_and_brick();
  const double omega = 1e4;
  const V axis = V(0, 0, omega);
  for (Index n = 0; n < model.nodes.size(); ++n) model.nodes.velocity[n] = cross<double>(axis, model.nodes.position[n]);
  const V spin = spin_of(model.nodes);
  const double before = total(energy(model)), dt = stable_time_step(model), quarter = std::acos(0.0) / omega;
  const V corner = model.nodes.position[0];
  while (model.time < quarter) step(model, dt);

  // Set off at rest, the bodies ring: at most twice the steady stress, which is of the order rho omega^2 R^2 = 8 MPa. A
  // stress rate that were not objective would show up with the order of E = 200 GPa.
  const double radius = std::hypot(2.5e-3, 2e-3), centrifugal = 7850 * std::pow(omega * radius, 2);
  for_each_body(model, [&](const auto &body) {
    double largest = 0;
    for (Index i = 0; i < body.points.size(); ++i)
      largest = std::max({largest, von_mises(body.points.deviator[i]), std::abs(body.points.pressure[i])});
    CHECK(largest < 2 * centrifugal);
  });
  const double angle = omega * model.time;
  // The stretch is of the order centrifugal/E = 4e-5 of the radius, and the spin slows down by twice that.
  CHECK((model.nodes.position[0] - fem_test::rotation(axis, angle) * corner).norm() < 3e-4 * radius);
  // Hexes bear no moment to round-off. Particles compute the gradient with the volumes of the last step and the force
  // with the new ones: the moment is of the order of the change of density in a step, 1e-6, times the stress.
  CHECK((spin_of(model.nodes) - spin).norm() < 1e-8 * spin.norm());
  CHECK(total(energy(model)) == Approx(before).epsilon(1e-4));
}
