// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "contact/sledge.hpp"

using namespace contact_test;
using fem_test::Noise;

namespace {

constexpr double dt = 1e-7, mu = 0.2, gravity = Sledge::gravity, block_mass = Sledge::mass, offset = Sledge::offset;

} // namespace

TEST_CASE("a sliding block stops after v^2/(2 mu g)", "[contact]") {
  const double speed = 20, distance = speed * speed / (2 * mu * gravity);
  Sledge sledge(mu);
  set_velocity(sledge.nodes, sledge.runners, V(speed, 0, 0));
  const double start = sledge.nodes.position[sledge.runners.begin][0];
  const int half = 50; // of the 100 steps until it stops
  for (int i = 0; i < half; ++i) sledge.advance(0);
  // The force of the first step acts already: half a step of doubt.
  CHECK(sledge.nodes.velocity[sledge.runners.begin][0] == Approx(speed - mu * gravity * half * dt).epsilon(1e-6));
  for (int i = 0; i < 150; ++i) sledge.advance(0);
  for (Index n = sledge.runners.begin; n < sledge.runners.end; ++n)
    CHECK(std::abs(sledge.nodes.velocity[n][0]) < 1e-9 * speed);
  // Half a step at full speed, 0.5 %, and the last centimetre per second, which the cap on sticking lets creep: 0.2 %.
  CHECK(sledge.nodes.position[sledge.runners.begin][0] - start == Approx(distance).epsilon(0.01));
  // The ledger takes what the block has lost.
  CHECK(friction_energy(sledge.contact) == Approx(4 * 0.5 * block_mass * speed * speed).epsilon(0.01));
  CHECK(std::abs(normal_energy(sledge.contact)) < 1e-6 * block_mass * speed * speed);
}

TEST_CASE("without friction the block goes on at its speed", "[contact]") {
  Sledge sledge(0);
  set_velocity(sledge.nodes, sledge.runners, V(20, 0, 0));
  for (int i = 0; i < 100; ++i) sledge.advance(0);
  CHECK(sledge.nodes.velocity[sledge.runners.begin][0] == 20);
}

TEST_CASE("below the limit a pulled block sticks, above it slides", "[contact]") {
  const double limit = mu * block_mass * gravity;
  Sledge stuck(mu);
  for (int i = 0; i < 400; ++i) stuck.advance(0.5 * limit);
  // Sticking is a viscous law, 0.3 m v/dt: the block creeps at F dt/(0.3 m), the speed of 1.7 steps of free pull.
  const double creep = 0.5 * limit * dt / (0.3 * block_mass);
  CHECK(stuck.nodes.velocity[stuck.runners.begin][0] == Approx(creep).epsilon(1e-6));

  Sledge sliding(mu);
  const int steps = 400;
  for (int i = 0; i < steps; ++i) sliding.advance(1.5 * limit);
  // (F - mu N)/m, but for the first steps in which friction still builds up: at most the speed of creep at the limit.
  CHECK(sliding.nodes.velocity[sliding.runners.begin][0] ==
        Approx(0.5 * limit / block_mass * steps * dt).margin(limit * dt / (0.3 * block_mass)));
}

TEST_CASE("friction opposes sliding, is at most mu N and never turns a slave back", "[contact]") {
  Noise noise;
  for (int trial = 0; trial < 500; ++trial) {
    Touch<double> touch;
    touch.facet = 0;
    touch.direction = noise.vector().normalized();
    touch.depth = 1e-6 * std::pow(10.0, 2 * noise());
    const V v = std::pow(10.0, 3 * noise()) * noise.vector();
    const auto c = contact_force(touch, ContactOptions<double>{.friction = mu}, v, block_mass, dt);
    const V sliding = v - v.dot(touch.direction) * touch.direction;
    REQUIRE(c.normal.dot(touch.direction) == Approx(0.1 * block_mass / (dt * dt) * touch.depth));
    REQUIRE(c.friction.norm() <= mu * c.normal.norm() * (1 + 1e-12));
    REQUIRE(std::abs(c.friction.dot(touch.direction)) <= 1e-12 * c.normal.norm());
    REQUIRE(c.friction.dot(sliding) < 0);
    const V after = sliding + dt / block_mass * c.friction;
    REQUIRE(after.dot(sliding) > 0); // slower, not backwards
    REQUIRE(after.norm() < sliding.norm());
  }
}

TEST_CASE("reactions oppose the forces on the slaves", "[contact]") {
  // Slaves around a warped block, moving at random: the forces add up to zero. A normal force acts along the line from
  // the surface to the slave and has no moment in sum. Friction acts at the slave and its reaction at the surface: it
  // leaves the moment gap x friction, at most the offset times the friction.
  for (const double friction : {0.0, 0.4}) {
    Nodes<double> nodes;
    const Surface block = add_surface(nodes, fem_test::distorted_brick(3, 1e-3, 0.2));
    Noise noise{99};
    std::vector<V> around;
    for (int i = 0; i < 300; ++i) around.emplace_back(V::Constant(1.5e-3) + 2.2e-3 * noise.vector());
    const NodeRange slaves = add_free(nodes, around, block_mass);
    for (V &v : nodes.velocity) v = 50 * noise.vector();
    auto contact = contact_of(nodes, slaves, offset, block.facets, {.friction = friction});
    add_contact_force(contact, nodes, 0.0, dt);
    V force = V::Zero(), moment = V::Zero(), expected = V::Zero();
    double scale = 0, friction_scale = 0;
    int touching = 0;
    for (Index n = 0; n < nodes.size(); ++n) {
      force += nodes.force[n];
      moment += cross<double>(nodes.position[n], nodes.force[n]);
      scale += nodes.force[n].norm();
    }
    for (Index s = 0; s < slaves.size(); ++s) {
      const auto c = force_on(contact, s);
      if (c.facet < 0) continue;
      ++touching;
      V x = V::Zero();
      for (int k = 0; k < 4; ++k) x += c.weights[k] * nodes.position[contact.facets[c.facet].nodes[k]];
      expected += cross<double>(nodes.position[slaves.begin + s] - x, c.friction);
      friction_scale += c.friction.norm();
    }
    CHECK(touching > 50);
    CHECK((friction_scale > 0) == (friction > 0));
    CHECK(force.norm() < 1e-13 * scale);
    // Round-off of sums of forces with arms of 4 mm; the direction is that of the gap to 1e-13 m.
    CHECK((moment - expected).norm() < 1e-9 * scale * 4e-3);
  }
}
