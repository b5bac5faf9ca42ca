// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/pulse.hpp"

using namespace sim_test;

namespace {

constexpr double path = 120e-3; ///< m

const double c = sound_speed(fem_test::steel<double>());

} // namespace

// Default viscosities throughout. Strains of 2e-4: the bars are linear to that accuracy.

TEST_CASE("a wave in a laterally held bar of particles has the longitudinal sound speed", "[sim]") {
  CHECK(speed_of_pulse(particle_bar_with_pulse(1e-3, 240e-3, {}), path) == Approx(c).epsilon(0.02));
}

TEST_CASE("a wave in a laterally held bar of hexes has the longitudinal sound speed", "[sim]") {
  CHECK(speed_of_pulse(hex_bar_with_pulse(1e-3, 240e-3, {}), path) == Approx(c).epsilon(0.02));
}

TEST_CASE("a wave passes a tie of particles to hexes, either way", "[sim]") {
  const bool particles_first = GENERATE(true, false);
  const double joint = 120e-3, spacing = 1e-3;
  const PulseShape shape;
  auto model = tied_bar_with_pulse(spacing, particles_first, shape);
  REQUIRE(model.ties.front().nodes.size() == particles_across * particles_across);
  const double start = pulse_between(model.nodes, 0, 1).centre, before = total(energy(model));
  travel(model, path / c);
  const Pulse passed = pulse_between(model.nodes, joint, 1), back = pulse_between(model.nodes, 0, joint - 20 * spacing);
  CHECK((passed.centre - start) / model.time == Approx(c).epsilon(0.02));
  CHECK(std::max(back.highest, -back.lowest) < 0.05 * shape.push);
  CHECK(std::max(passed.highest, -passed.lowest) > 0.9 * shape.push);
  CHECK(total(energy(model)) == Approx(before).epsilon(0.005));
}
