// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fem/hourglass.hpp"

#include "brick.hpp"
#include "catch.hpp"

using namespace fem_test;

TEST_CASE("hourglass control does not resist linear fields of distorted hexes", "[fem]") {
  const HexOptions<double> both{0.1, 0.1, 0.0, 0.0};
  auto s = solid<OnePoint>(distorted_brick(3, 0.01, 0.25), both);
  M L;
  L << 3, -2, 5, 7, 1, -4, 2, 6, -8;
  for (Index n = 0; n < s.nodes.size(); ++n) s.nodes.velocity[n] = 100 * (L * s.nodes.position[n]) + V(1, 2, 3);
  compute_forces(s, 1e-8);
  // Round-off of velocities of 30 m/s.
  for (const auto &motion : s.body.hourglass_motion)
    for (int k = 0; k < 12; ++k)
      for (Index lane = 0; lane < lanes<double>; ++lane) CHECK(std::abs(motion.rate.data()[k][lane]) < 1e-12);
  CHECK(hourglass_energy(s.body) < 1e-20 * std::abs(internal_energy(s.body)));
}

namespace {

/// Stiffness of the unit hourglass mode u_x = xi eta/sqrt(8) of a brick, N/m, with the energy that control has taken
/// up.
struct BendingMode {
  double stiffness, energy_over_exact, stress_energy_over_energy;
};

BendingMode bending_mode(const V &size) {
  const double dt = 1e-9;
  auto s = solid<OnePoint>(brick<double>(1, 1, 1, size), inviscid<double>());
  for (int a = 0; a < 8; ++a) {
    const V c = hex_corner<double>(a);
    s.nodes.velocity[s.body.hexes[0][a]][0] = c[0] * c[1] / std::sqrt(8.0);
  }
  compute_forces(s, dt);
  double stiffness = 0;
  for (Index n = 0; n < 8; ++n) stiffness -= s.nodes.force[n].dot(s.nodes.velocity[n]) / dt;
  const double energy = hourglass_energy(s.body);
  return {stiffness, energy / (0.5 * stiffness * dt * dt), std::abs(internal_energy(s.body)) / energy};
}

} // namespace

TEST_CASE("the bending mode has the documented stiffness, near the true one for flat hexes too", "[fem]") {
  const auto elastic = steel<double>().elasticity;
  for (const V &size : {V(0.01, 0.01, 0.01), V(0.03, 0.0015, 0.015), V(0.0015, 0.03, 0.015)}) {
    const auto mode = bending_mode(size);
    const double volume = size.prod();
    CHECK(mode.stiffness == Approx(1.5 * 0.1 * p_wave_modulus(elastic) * volume / (size[0] * size[0])).epsilon(1e-10));
    // Beam theory: E V/(6 length^2), E edge/6 for a cube.
    CHECK(mode.stiffness / (elastic.young * volume / (6 * size[0] * size[0])) == Approx(1.33).epsilon(0.01));
    // Half of the force times the way, by the trapezoidal rule; no stress.
    CHECK(mode.energy_over_exact == Approx(1).epsilon(1e-10));
    CHECK(mode.stress_energy_over_energy < 1e-12);
  }
}

TEST_CASE("every hourglass mode of a distorted hex is resisted", "[fem]") {
  const auto mean = mean_gradient<double>(corners(distorted_brick(1, 0.01, 0.2), 0));
  Noise noise;
  for (int trial = 0; trial < 20; ++trial) {
    HourglassModes<double> rate = HourglassModes<double>::Zero();
    rate.col(trial % 4) = noise.vector();
    const auto force = hourglass_force_rate<double>(mean, 1e11, rate);
    // A cube of the same size has 1.5 * 1e11 * 0.01; a hex distorted by a fifth of its edge comes within a factor.
    const double stiffness = force.cwiseProduct(rate).sum() / rate.squaredNorm();
    CHECK(stiffness > 0.3 * 1.5e9);
    CHECK(stiffness < 3 * 1.5e9);
  }
}

TEST_CASE("hourglass forces turn with the hex", "[fem]") {
  auto s = solid<OnePoint>(brick<double>(1, 1, 1, V::Constant(0.01)), inviscid<double>());
  s.body.hourglass_force[0] << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12;
  const auto start = s.nodes.position;
  const HourglassModes<double> Q = s.body.hourglass_force[0];
  const V axis(1, 2, -1);
  const double dt = 1e-6;
  const int steps = 40;
  for (int i = 1; i <= steps; ++i) {
    for (Index n = 0; n < 8; ++n) {
      const V next = rotation(axis, 0.05 * i) * start[n];
      s.nodes.velocity[n] = (next - s.nodes.position[n]) / dt;
      s.nodes.position[n] = next;
    }
    compute_forces(s, dt);
  }
  // The step's rotation is exact for a rigid rotation: round-off of 40 steps.
  CHECK((s.body.hourglass_force[0] - rotation(axis, 0.05 * steps) * Q).cwiseAbs().maxCoeff() < 1e-6);
  CHECK((s.body.hourglass_force[0] - Q).cwiseAbs().maxCoeff() > 1);
}

TEST_CASE("hourglass viscosity only takes energy", "[fem]") {
  const HexOptions<double> viscous{0.0, 0.1, 0.0, 0.0};
  auto s = solid<OnePoint>(distorted_brick(2, 0.01, 0.2), viscous);
  Noise noise;
  for (auto &v : s.nodes.velocity) v = noise.vector();
  compute_forces(s, 1e-9);
  for (double energy : s.body.hourglass_energy) CHECK(energy > 0);
}
