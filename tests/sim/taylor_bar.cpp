// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/taylor_rod.hpp"

#include "ogive/material/johnson_cook.hpp"

using namespace sim_test;

// The copper rod of the code comparisons. Published codes end, at 80 us, between 21.2 and 21.6 mm long with a foot
// radius of 6.9 to 7.3 mm.

namespace {

void check_rod(const Rod &rod, double margin) {
  const TaylorCase<Steel> c = copper_rod();
  REQUIRE(rod.finished);
  CHECK(rod.length == Approx(21.4e-3).epsilon(margin));
  CHECK(rod.foot == Approx(7.1e-3).epsilon(2 * margin));
  // Work of a uniform compression by ln(L0/L) = 0.53 takes all of the energy, 400 MPa e + 50 MPa e^2 = rho v^2/2. A rod
  // that spreads at the foot needs more work for the same length.
  CHECK(rod.length > c.length * std::exp(-0.54));
  for (std::size_t k = 1; k < rod.radii.size(); ++k) CHECK(rod.radii[k] < rod.radii[k - 1] * 1.005);
  CHECK(rod.radii.back() < 1.05 * c.radius); // the tail has hardly yielded
  CHECK(rod.error < 0.01);
  CHECK(rod.least_hourglass >= 0);
  CHECK_FALSE(rod.turned);
  // It has come to rest: what is left is elastic vibration and a slow rebound.
  CHECK(rod.kinetic < 0.02);
}

} // namespace

TEMPLATE_TEST_CASE("a Taylor bar of hexes mushrooms as published", "[sim]", OnePoint, SelectiveReduced) {
  check_rod(rod_of_hexes<TestType>(copper_rod(), 0.8e-3), 0.015);
}

TEST_CASE("a Taylor bar that meets the wall by contact mushrooms alike", "[sim]") {
  check_rod(rod_of_hexes<OnePoint>(copper_rod(), 0.8e-3, Foot::touches), 0.02);
}

TEST_CASE("a Taylor bar that mushrooms heavily keeps its surface and its energy", "[sim]") {
  auto c = copper_rod();
  c.speed = 350;
  const Rod rod = rod_of_hexes<OnePoint>(c, 0.8e-3, Foot::touches);
  REQUIRE(rod.finished);
  CHECK_FALSE(rod.turned);
  CHECK(rod.error < 0.01);
  CHECK(rod.least_hourglass >= 0);
  // A uniform compression by ln(L0/L) would take the energy at 400 MPa e + 50 MPa e^2 = rho v^2/2, e = 1.18: 10 mm. The
  // rod spreads at the foot and stays longer; that its foot is more than twice as wide as the rod is what mushrooms.
  CHECK(rod.length > 10e-3);
  CHECK(rod.length < 16e-3);
  CHECK(rod.widest > 2.5 * c.radius);
}

TEST_CASE("a Taylor bar of particles mushrooms as published", "[sim]") {
  check_rod(rod_of_particles(copper_rod(), 0.8e-3), 0.05);
}

namespace {

/// The copper rod with a law of the Johnson-Cook family that is, at room temperature, the bilinear one. As a user
/// builds it: the temperatures are given to the metal, and to nothing else.
template <class Law> TaylorCase<Law> user_built_rod(const Law &law) {
  const TaylorCase<Steel> c = copper_rod();
  Metal<double, Law> m;
  m.name = "my copper";
  m.density = c.metal.density;
  m.elasticity = c.metal.elasticity;
  m.flow = law;
  m.room_temperature = 293;
  m.melting_temperature = 1356;
  return {m, c.length, c.radius, c.speed, c.end_time};
}

template <class Law> void check_user_built(const Law &law) {
  auto c = user_built_rod(law);
  const Rod isothermal = rod_of_hexes<OnePoint>(c, 0.8e-3);
  check_rod(isothermal, 0.015);
  c.metal.specific_heat = 385;
  const Rod heated = rod_of_hexes<OnePoint>(c, 0.8e-3);
  REQUIRE(heated.finished);
  CHECK(heated.length < isothermal.length);
  CHECK(heated.length > 0.95 * isothermal.length); // 227 m/s heat the rod by 60 K on average, 6 % of Tm - Tr
}

} // namespace

TEST_CASE("a Taylor bar of a user's Johnson-Cook metal has its strength", "[sim]") {
  check_user_built(ModifiedJohnsonCook<double>{.A = 400e6, .B = 100e6, .a = 1, .C = 0, .b = 1});
  check_user_built(JohnsonCook<double>{.A = 400e6, .B = 100e6, .n = 1, .C = 0, .m = 1, .reference_rate = 1});
}
