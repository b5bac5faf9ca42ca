// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "fem/beam.hpp"

#include <numbers>

using namespace fem_test;

TEST_CASE("an elastic wave in a laterally held bar travels at the longitudinal sound speed", "[fem]") {
  const Index count = 120;
  const double edge = 1e-3, push = 0.1;
  auto s = solid<OnePoint>(brick<double>(1, 1, count, V(edge, edge, count * edge)));
  for (auto &held : s.nodes.held) held = held_x | held_y;
  for (Index n = 0; n < 4; ++n) s.nodes.held[n] = held_all;
  const double dt = stable_time_step(s.body, s.nodes);
  // The end moves on at a constant speed; a node is reached when it has half of that speed.
  auto arrival = [&, time = 0.0](Index layer) mutable {
    for (; s.nodes.velocity[4 * layer][2] < 0.5 * push; time += dt) {
      step(s, dt);
      for (Index n = 0; n < 4; ++n) {
        s.nodes.velocity[n] = V(0, 0, push);
        s.nodes.position[n] += dt * s.nodes.velocity[n];
      }
    }
    return time;
  };
  const double near = arrival(30), far = arrival(90);
  // Dispersion of 1 mm hexes spreads the front over a few hexes of 60.
  CHECK(60 * edge / (far - near) == Approx(sound_speed(s.body.metal)).epsilon(0.02));
  // Behind the front: stress = rho c v.
  const double stress_zz = stress(load(s.body.points, 45)).zz;
  CHECK(stress_zz == Approx(-7850 * sound_speed(s.body.metal) * push).epsilon(0.03));
}

namespace {

/// Half a period of a clamped-free bar over that of a thin beam (Euler). The bar has 4 layers of hexes through its
/// height, 2 across and `count` along.
double half_period_ratio(double length, double height, Index count) {
  const Beam beam{length, height, height, count, 4, 2};
  auto s = clamped_beam<OnePoint>(beam);
  const double expected = std::numbers::pi / euler_frequency(beam, s.body.metal);
  const double dt = stable_time_step(s.body, s.nodes);
  return half_period(
             s.nodes, 0, 0.05, 2 * expected, [&](const V &p) { return first_mode(p[2], length); },
             [&] { return step(s, dt), dt; }) /
         expected;
}

} // namespace

TEST_CASE("a cantilever of one-point hexes swings at its beam frequency", "[fem]") {
  // Shear and rotary inertia slow the beam by 0.5 %. Four one-point layers lose 1/16 of the bending stiffness, 3 % of
  // the period, and hourglass control gives 1.33 times that back.
  CHECK(half_period_ratio(60e-3, 4e-3, 30) == Approx(1).epsilon(0.02));
}

TEST_CASE("hourglass control does not lock the bending of flat hexes", "[fem]") {
  // 0.5 mm by 5 mm; with 12 hexes along the beam, the lumped mass and the broken line of its curvature are 1 % off.
  CHECK(half_period_ratio(60e-3, 2e-3, 12) == Approx(1).epsilon(0.03));
}
