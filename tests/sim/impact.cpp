// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/strike.hpp"

using namespace sim_test;

namespace {

void check(const Strike &strike, double round_off) {
  CHECK(strike.momentum_error < round_off);
  CHECK(strike.energy_error < 0.01);
  CHECK(strike.stored > 0.01); // there was an impact
  // Springs give back what they took, but for the fraction of a step in which a slave meets or leaves the surface: up
  // to half of 0.1 m v^2 for each slave and touch, and a quarter of the block's mass touches.
  CHECK(strike.left < 0.01);
  // They have parted, the struck body first, and no faster than if nothing had been lost to vibration.
  CHECK(strike.restitution > 0.3);
  CHECK(strike.restitution < 1);
}

} // namespace

TEST_CASE("an elastic impact of two hex blocks keeps momentum and energy", "[sim]") {
  check(strike_with_hexes(), 1e-13);
}

TEST_CASE("an elastic impact of particles on hexes keeps momentum and energy", "[sim]") {
  check(strike_with_particles(), 3e-8); // forces between particles are of single precision: 1.4e-8 was measured
}
