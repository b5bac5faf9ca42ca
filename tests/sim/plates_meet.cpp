// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/sim/guard.hpp"

using namespace sim_test;

namespace {

constexpr double spacing = 1e-3, width = 5e-3, speed = 2;

/// Two plates of particles that only move along z, so that waves in them are plane: one from z = 0 upwards that flies
/// downwards, one below at rest.
auto two_plates(Index upper_layers, Index lower_layers, double gap = 0) {
  Nodes<double> nodes;
  const auto metal = fem_test::steel<double>();
  const Index across = static_cast<Index>(std::lround(width / spacing));
  auto upper = add_sph_body(nodes, lattice(across, across, upper_layers, spacing, V(0, 0, gap)), metal, "upper");
  auto lower = add_sph_body(nodes, lattice(across, across, lower_layers, spacing, V(0, 0, -lower_layers * spacing)),
                            metal, "lower");
  for (auto &held : nodes.held) held = held_x | held_y;
  set_velocity(nodes, upper.nodes, V(0, 0, -speed));
  const auto brought = [&](const Sph &body, double way) {
    return ContactBody<double>{body.nodes, std::vector<double>(body.points.size(), std::pow(spacing, 3)), spacing, way};
  };
  // As in make_perforation: a penalty of 0.1 m/dt^2 at a time step of 0.4 spacings over the sound speed.
  const double modulus = 0.1 / (0.4 * 0.4) * metal.density * std::pow(sound_speed(metal), 2);
  auto contact = make_particle_contact<double>(nodes, {brought(upper, -gap), brought(lower, 0)}, modulus, "plates");
  auto model = model_of(std::move(nodes), std::move(upper), std::move(lower));
  model.particle_contacts.push_back(std::move(contact));
  return model;
}

template <class M> double velocity_of(const M &model, NodeRange range) { return mean_velocity(model.nodes, range)[2]; }

template <class M> void step_until(M &model, double time) {
  const double dt = stable_time_step(model);
  while (model.time < time) step(model, dt);
}

} // namespace

TEST_CASE("equal plates that meet exchange their velocities", "[sim]") {
  const double gap = GENERATE(0.0, 0.7e-3);
  const Index layers = 20;
  auto model = two_plates(layers, layers, gap);
  const auto &[upper, lower] = model.bodies;
  const V momentum_before = momentum(model);
  const double total_before = total(energy(model)), wave = layers * spacing / sound_speed(upper.metal);
  step_until(model, gap / speed + 4 * wave);
  // The wave has come back from the free faces after two transits and taken the plates apart.
  CHECK(velocity_of(model, upper.nodes) == Approx(0).margin(0.03 * speed));
  CHECK(velocity_of(model, lower.nodes) == Approx(-speed).epsilon(0.03));
  // Forces between particles of a plate are of single precision.
  CHECK((momentum(model) - momentum_before).norm() < 1e-7 * momentum_before.norm());
  const auto e = energy(model);
  CHECK(total(e) == Approx(total_before).epsilon(2e-3));
  CHECK(std::abs(e.contact) < 0.003 * total_before); // the springs have given back what they took
  CHECK(e.kinetic > 0.93 * total_before);            // the rest is in vibrations and the viscosity of the wave's front
  for (const V &force : model.particle_contacts[0].forces) CHECK(force.norm() == 0);
  CHECK_FALSE(find_lost(model));
}

TEST_CASE("the wave that a plate sends into another has half its velocity and the pressure rho c v/2", "[sim]") {
  const Index layers = 40;
  auto model = two_plates(layers, layers);
  const auto &[upper, lower] = model.bodies;
  const double c = sound_speed(upper.metal), impedance = upper.metal.density * c;
  step_until(model, 0.7 * layers * spacing / c);
  // From 2 to 16 mm behind the face: between the interface and the wave's front, which is 28 mm away.
  const auto mean_near = [&](const auto &body, auto &&value) {
    double sum = 0;
    int count = 0;
    for (Index i = 0; i < body.points.size(); ++i)
      if (const double z = std::abs(model.nodes.position[body.nodes.begin + i][2]); z > 2e-3 && z < 16e-3)
        sum += value(body, i), ++count;
    return sum / count;
  };
  const auto v = [&](const auto &body, Index i) { return model.nodes.velocity[body.nodes.begin + i][2]; };
  const auto push = [&](const auto &body, Index i) { return body.points.pressure[i] - body.points.deviator[i].zz; };
  // Particles at a free face lack neighbours, and the contact is a spring: the first wave rings a little behind its
  // front. Both plates see the same by symmetry, so that the mean of both is exact.
  CHECK(mean_near(upper, v) == Approx(-speed / 2).epsilon(0.03));
  CHECK(mean_near(upper, v) + mean_near(lower, v) == Approx(-speed).epsilon(1e-6));
  CHECK(mean_near(upper, push) == Approx(impedance * speed / 2).epsilon(0.03));
  CHECK(mean_near(lower, push) == Approx(impedance * speed / 2).epsilon(0.03));
}

TEST_CASE("a thin plate stops on a thick one and a thick one flies on behind a thin one", "[sim]") {
  // Waves of a plane impact: the thin plate has given its momentum away after two transits of its own.
  auto model = two_plates(10, 40);
  const auto &[thin, thick] = model.bodies;
  step_until(model, 40 * spacing / sound_speed(thin.metal));
  CHECK(velocity_of(model, thin.nodes) == Approx(0).margin(0.05 * speed));
  CHECK(velocity_of(model, thick.nodes) == Approx(-speed / 4).epsilon(0.05));
}
