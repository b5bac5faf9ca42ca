#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/fem/facets.hpp"

using namespace sim_test;

namespace {

constexpr double edge = 1e-3, speed = 20;

/// A block that strikes a free hex block below it. `make` adds the block above the height z and returns it.
template <class Make> void strike(double offset, Make &&make) {
  Nodes<double> nodes;
  const auto mesh = brick_at(5, 5, 4, V(5e-3, 5e-3, 4e-3), V(-2.5e-3, -2.5e-3, -4e-3));
  auto target = add_hex_body(nodes, mesh, fem_test::steel<double>(), "target");
  auto block = make(nodes, offset + 0.05 * edge);
  set_velocity(nodes, block.nodes, V(0, 0, -speed));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact =
      make_contact(nodes, slaves, std::vector<double>(slaves.size(), offset), boundary_facets(mesh), "contact");
  const NodeRange flying = block.nodes, struck = target.nodes;
  auto model = model_of(std::move(nodes), std::move(target), std::move(block));
  model.contacts.push_back(std::move(contact));

  const V p = momentum(model);
  const double e = total(energy(model)), dt = stable_time_step(model), crossing = 4e-3 / 6000;
  double stored = 0, error = 0;
  while (model.time < 8 * crossing) {
    step(model, dt);
    stored = std::max(stored, energy(model).contact);
    error = std::max(error, std::abs(total(energy(model)) / e - 1));
  }
  CHECK((momentum(model) - p).norm() < 1e-13 * p.norm());
  CHECK(error < 0.01);
  CHECK(stored > 0.01 * e); // there was an impact
  // Springs give back what they took, but for the fraction of a step in which a slave meets or leaves the surface: up
  // to half of 0.1 m v^2 for each slave and touch, and a quarter of the block's mass touches.
  CHECK(std::abs(energy(model).contact) < 0.01 * e);
  // They have parted, the struck body first, and no faster than if nothing had been lost to vibration.
  const double before = speed, after = mean_velocity(model.nodes, flying)[2] - mean_velocity(model.nodes, struck)[2];
  CHECK(after > 0.3 * before);
  CHECK(after < before);
}

} // namespace

TEST_CASE("an elastic impact of two hex blocks keeps momentum and energy", "[sim]") {
  strike(0, [](Nodes<double> &nodes, double z) {
    return add_hex_body(nodes, brick_at(3, 3, 3, V(3e-3, 3e-3, 3e-3), V(-1.5e-3 + 0.2e-3, -1.5e-3, z)),
                        fem_test::steel<double>(), "block");
  });
}

TEST_CASE("an elastic impact of particles on hexes keeps momentum and energy", "[sim]") {
  strike(0.5 * edge, [](Nodes<double> &nodes, double z) {
    return add_sph_body(nodes, lattice(3, 3, 3, edge, V(-1.5e-3, -1.5e-3, z - 0.5 * edge)), fem_test::steel<double>(),
                        "block");
  });
}
