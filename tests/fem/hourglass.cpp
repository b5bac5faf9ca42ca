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

namespace {

/// Steel that yields at `yield` (Pa) and does not harden.
Metal<double, Bilinear<double>> ideal_steel(double yield) {
  auto metal = steel<double>(yield);
  metal.flow.hardening = 0;
  return metal;
}

/// Adds u_x' = rate xi eta to the velocities of a single hex.
template <class S> void bend(S &s, double rate) {
  for (int a = 0; a < 8; ++a) {
    const V c = hex_corner<double>(a);
    s.nodes.velocity[s.body.hexes[0][a]][0] += rate * c[0] * c[1];
  }
}

} // namespace

TEST_CASE("a hex that is bent yields at the plastic moment", "[fem]") {
  const double yield = 400e6;
  for (const V &size : {V(0.01, 0.01, 0.01), V(0.03, 0.0015, 0.015), V(0.0015, 0.03, 0.015)}) {
    auto s = solid<OnePoint>(brick<double>(1, 1, 1, size), inviscid<double>(), ideal_steel(yield));
    bend(s, 1);
    double elastic = 0;
    // The edges strain by 20 times the yield strain in the end; the geometry is kept as it is.
    const double dt = 20 * yield / 200e9 * size[0] / 2 / 100;
    for (int step = 0; step < 100; ++step) {
      compute_forces(s, dt);
      if (step == 0) elastic = std::abs(s.nodes.force[s.body.hexes[0][1]][0]);
    }
    // Forces along x at the four corners of a face, with the arm of half the height.
    double moment = 0;
    for (int a : {1, 2, 5, 6}) moment += std::abs(s.nodes.force[s.body.hexes[0][a]][0]) * size[1] / 2;
    const double plastic = yield * size[2] * size[1] * size[1] / 4;
    CHECK(moment == Approx(plastic).epsilon(1e-9)); // round-off
    CHECK(100 * 4 * elastic * size[1] / 2 > 10 * plastic);
    CHECK(s.body.points.plastic_strain[0] == 0); // the mean does not flow
    // Elastic up to the plastic moment, then at it: moment times angle, less what bending to it takes.
    const double angle = 100 * dt * 4 / size[1];
    CHECK(hourglass_energy(s.body) > 0.95 * plastic * angle);
    CHECK(hourglass_energy(s.body) < plastic * angle);
  }
}

TEST_CASE("hourglass forces of a hex that flows are those of its flow", "[fem]") {
  const double yield = 400e6, edge = 0.01, rate = 1e3;
  auto s = solid<OnePoint>(brick<double>(1, 1, 1, V::Constant(edge)), inviscid<double>(), ideal_steel(yield));
  const V strain_rate(rate / 2, rate / 2, -rate); // equivalent: `rate`
  for (Index n = 0; n < 8; ++n) s.nodes.velocity[n] = strain_rate.cwiseProduct(s.nodes.position[n]);
  bend(s, 2);
  // 60 times the time that the forces relax in, sigma/(3 G rate) = 1.8 us; the geometry is kept as it is.
  for (int step = 0; step < 5000; ++step) compute_forces(s, 20e-9);
  const auto &elastic = s.body.metal.elasticity;
  const double mode_rate = 2 * std::sqrt(8.0), stiffness = 1.5 * 0.1 * p_wave_modulus(elastic) * edge;
  const double expected = stiffness * mode_rate * yield / (3 * shear_modulus(elastic) * rate);
  // The strains of a step, 2e-5, are taken at its middle.
  CHECK(s.body.hourglass_force[0](0, 2) == Approx(expected).epsilon(1e-4));
  CHECK(s.body.hourglass_force[0].norm() == Approx(expected).epsilon(1e-4));
  // Less than the plastic moment's force: the bound of bending does not act.
  CHECK(std::sqrt(hourglass_stress_squared<double>(
            mean_gradient<double>(modes<double>(gather_corners(s.nodes.position, s.body.hexes[0]))),
            s.body.hourglass_force[0])) < 0.5 * hourglass_strength * yield);
}

TEST_CASE("hourglass forces that yield turn with the hex", "[fem]") {
  const M turned = rotation(V(1, 2, -1), 0.7);
  const auto metal = steel<double>(100e6);
  auto a = solid<OnePoint>(distorted_brick(2, 0.01, 0.2), {}, metal), b = a;
  Noise noise;
  for (Index n = 0; n < a.nodes.size(); ++n) {
    a.nodes.velocity[n] = 40 * noise.vector();
    b.nodes.velocity[n] = turned * a.nodes.velocity[n];
    b.nodes.position[n] = turned * a.nodes.position[n];
  }
  const double dt = stable_time_step(a.body, a.nodes);
  for (int i = 0; i < 100; ++i) step(a, dt), step(b, dt);
  double largest = 0;
  for (Index e = 0; e < 8; ++e) {
    const HourglassModes<double> &Q = a.body.hourglass_force[e];
    // Round-off of 100 steps.
    CHECK((b.body.hourglass_force[e] - turned * Q).norm() < 1e-9 * Q.norm());
    CHECK(b.body.hourglass_energy[e] == Approx(a.body.hourglass_energy[e]).epsilon(1e-9));
    CHECK(a.body.points.plastic_strain[e] > 0.004); // ten times the yield strain
    largest = std::max(largest, Q.norm());
  }
  CHECK(largest > 0);
}

TEST_CASE("the work of bending to and fro beyond yield is never negative and is not given back", "[fem]") {
  const double yield = 400e6, edge = 0.01, dt = 20 * yield / 200e9 * edge / 2 / 100;
  auto s = solid<OnePoint>(brick<double>(1, 1, 1, V::Constant(edge)), inviscid<double>(), ideal_steel(yield));
  double first = 0;
  bend(s, 1);
  for (int cycle = 0; cycle < 4; ++cycle) {
    for (int i = 0; i < 100; ++i) {
      compute_forces(s, dt);
      CHECK(hourglass_energy(s.body) > 0);
    }
    if (cycle == 0) first = hourglass_energy(s.body);
    // Each later cycle unloads elastically and bends the other way: a tenth less work than the first, which begins
    // without stress.
    CHECK(hourglass_energy(s.body) >= first * (1 + 0.8 * cycle));
    for (auto &v : s.nodes.velocity) v = -v;
  }
}

TEST_CASE("hourglass forces weaken with a metal that is damaged and end when it fails", "[fem]") {
  const double yield = 400e6, edge = 0.01, dt = 20 * yield / 200e9 * edge / 2 / 100;
  auto metal = ideal_steel(yield);
  metal.damage.softening = 0.5;
  metal.damage.effect = FailureEffect::no_tension;
  const auto force_at = [&](double damage) {
    auto s = solid<OnePoint>(brick<double>(1, 1, 1, V::Constant(edge)), inviscid<double>(), metal);
    s.body.points.damage[0] = damage;
    bend(s, 1);
    for (int i = 0; i < 100; ++i) compute_forces(s, dt);
    return s.body.hourglass_force[0].norm();
  };
  const double sound = force_at(0);
  CHECK(sound > 0);
  CHECK(force_at(0.4) == Approx(0.8 * sound).epsilon(1e-9));
  CHECK(force_at(1) == 0);
}
