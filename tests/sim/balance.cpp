// SPDX-License-Identifier: BSD-3-Clause
#include "sim/balance.hpp"
#include "catch.hpp"
#include "sim/small_shot.hpp"

using namespace sim_test;

TEST_CASE("a shot keeps energy and gives its momentum to the supports", "[sim]") {
  const bool rigid = GENERATE(false, true);
  const Nose nose = GENERATE(Nose::blunt, Nose::conical);
  auto c = small_case(nose, Extent::quarter);
  c.rigid_projectile = rigid;
  auto model = small_shot(c);
  const double e = total(energy(model)), p = momentum(model)[2];
  const double expected = 0.5 * whole_mass(projectile(model).point_mass, model.symmetry) * 300 * 300;
  CHECK(e == Approx(expected).epsilon(0.011)); // mass scaling adds at most 1 %
  const Balance balance = follow(model, 25e-6);
  const Energy<double> now = energy(model);
  CHECK(now.plastic > 0.02 * e); // the plate has yielded, near the tip at least
  CHECK(now.friction > 0);
  // Leapfrog and trapezoidal work sums: what is left is of second order in the step. 0.02 % was measured.
  CHECK(balance.energy_error < 0.005);
  // Forces add up to zero: round-off of about a thousand steps; forces between particles are of single precision.
  CHECK(std::abs(model.symmetry.copies() * model.support_impulse[2]) > 1e-6 * std::abs(p));
  CHECK(balance.momentum_error < 1e-8);
}
