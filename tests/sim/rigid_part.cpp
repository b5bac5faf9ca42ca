// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/sim/energy.hpp"
#include "ogive/sim/rigid_part.hpp"
#include "ogive/sim/step.hpp"

#include <numbers>

using namespace ogive;

namespace {

using V = Vec3<double>;

/// Points of mass, kg and m.
Nodes<double> points(const std::vector<std::pair<double, V>> &masses) {
  Nodes<double> nodes;
  for (const auto &[mass, position] : masses) {
    add_nodes(nodes, std::vector<V>{position});
    nodes.mass.back() = mass;
  }
  return nodes;
}

/// A top: four points of 1 kg, 1 m from its axis z, and two of 0.5 kg on it, 0.5 m from the middle. By hand: 4 kg m2
/// about z and 2 + 0.25 = 2.25 kg m2 across.
Nodes<double> top() {
  return points({{1, V(1, 0, 0)},
                 {1, V(0, 1, 0)},
                 {1, V(-1, 0, 0)},
                 {1, V(0, -1, 0)},
                 {0.5, V(0, 0, 0.5)},
                 {0.5, V(0, 0, -0.5)}});
}

NodeRange all_of(const Nodes<double> &nodes) { return {0, nodes.size()}; }

/// Nodes that turn with `spin` (1/s) about the origin, which moves with `velocity` (m/s).
void set_motion(Nodes<double> &nodes, const V &velocity, const V &spin) {
  for (Index n = 0; n < nodes.size(); ++n) nodes.velocity[n] = velocity + cross<double>(spin, nodes.position[n]);
}

void advance(RigidPart<double> &part, Nodes<double> &nodes, double dt_mid, double dt) {
  rigidify(part, nodes, dt_mid, dt);
  integrate(nodes, dt_mid, dt);
}

/// Angular momentum about the origin, kg m2/s.
V angular_momentum(const Nodes<double> &nodes) {
  V sum = V::Zero();
  for (Index n = 0; n < nodes.size(); ++n) sum += nodes.mass[n] * cross<double>(nodes.position[n], nodes.velocity[n]);
  return sum;
}

} // namespace

TEST_CASE("a free top precesses as the analytic one and keeps its shape", "[sim]") {
  auto nodes = top();
  // The angular momentum points along z, the top's axis 0.3 rad from it.
  const double tilt = 0.3, momentum = 8;
  for (V &p : nodes.position)
    p = V(std::cos(tilt) * p[0] + std::sin(tilt) * p[2], p[1], -std::sin(tilt) * p[0] + std::cos(tilt) * p[2]);
  const V axis(std::sin(tilt), 0, std::cos(tilt)), aside(std::cos(tilt), 0, -std::sin(tilt));
  const V spin = momentum * std::cos(tilt) / 4 * axis - momentum * std::sin(tilt) / 2.25 * aside;
  set_motion(nodes, V(3, -2, 1), spin);
  auto part = make_rigid_part(nodes, all_of(nodes));
  REQUIRE(turns(part));
  CHECK(part.inertia(1, 1) == Approx(2.25));
  CHECK((part.angular_momentum - V(0, 0, momentum)).norm() < 1e-14);
  const auto start = nodes.position;
  const V linear = 5 * V(3, -2, 1), angular = angular_momentum(nodes);

  const double dt = 1e-3;
  const int steps = 10000;
  double least = 1e9, most = 0;
  for (int k = 0; k < steps; ++k) {
    for (V &f : nodes.force) f.setZero();
    advance(part, nodes, k == 0 ? dt / 2 : dt, dt);
    if (k == 0) continue; // the velocities that were set are those of the start, not of half a step before
    const double kinetic = kinetic_energy(nodes, all_of(nodes), dt);
    least = std::min(least, kinetic), most = std::max(most, kinetic);
  }
  // The axis turns about z by momentum/2.25 a second. Of second order in the 3.6e-3 rad of a step: 1e-5 of the 35.6
  // rad.
  const double turned = momentum / 2.25 * dt * steps;
  const V middle = double(dt * steps) * V(3, -2, 1);
  const V tip = nodes.position[4] - nodes.position[5];
  CHECK((tip - V(std::sin(tilt) * std::cos(turned), std::sin(tilt) * std::sin(turned), std::cos(tilt))).norm() < 1e-4);
  // Round-off of one step, not of ten thousand: coordinates of 40 m.
  for (std::size_t a = 0; a < start.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      CHECK(std::abs((nodes.position[a] - nodes.position[b]).norm() - (start[a] - start[b]).norm()) < 3e-14);
  CHECK((inertia_of(nodes, all_of(nodes)).centre - middle).norm() < 1e-11);
  V now = V::Zero();
  for (Index n = 0; n < nodes.size(); ++n) now += nodes.mass[n] * nodes.velocity[n];
  CHECK((now - linear).norm() < 1e-10); // chords of 1e-3 m between coordinates of 40 m
  CHECK((angular_momentum(nodes) - angular).norm() < 1e-9);
  CHECK(most / least - 1 < 1e-10);
}

TEST_CASE("a free body without symmetry keeps its energy while it tumbles", "[sim]") {
  // Unequal moments of inertia: a turn about the middle axis is unstable, and the body turns over.
  auto nodes = points({{1, V(1, 0, 0)},
                       {1, V(-1, 0, 0)},
                       {1, V(0, 0.7, 0)},
                       {1, V(0, -0.7, 0)},
                       {1, V(0, 0, 0.3)},
                       {1, V(0, 0, -0.3)}});
  set_motion(nodes, V::Zero(), V(0.01, 5, 0.01));
  auto part = make_rigid_part(nodes, all_of(nodes));
  const V angular = angular_momentum(nodes);
  const double dt = 1e-3, kinetic = 0.5 * angular.dot(part.compliance * angular);
  double lowest = 1, error = 0;
  for (int k = 0; k < 5000; ++k) {
    for (V &f : nodes.force) f.setZero();
    advance(part, nodes, k == 0 ? dt / 2 : dt, dt);
    if (k > 0) error = std::max(error, std::abs(kinetic_energy(nodes, all_of(nodes), dt) / kinetic - 1));
    lowest = std::min(lowest, nodes.position[2][1] / 0.7);
  }
  CHECK(lowest < -0.9); // it has turned over
  CHECK(error < 1e-4);  // bounded, of second order in the 5e-3 rad of a step
  CHECK((angular_momentum(nodes) - angular).norm() < 1e-11);
}

TEST_CASE("a blow beside the centre of mass moves and turns a rod, and leaves its centre of percussion", "[sim]") {
  // Five points of 0.2 kg on 1 m: a blow of 2 N s at the end gives 2 m/s and 2 * 0.5/0.125 = 8 1/s about y, so that the
  // point 0.25 m on the other side is at rest.
  Nodes<double> nodes;
  for (int k = 0; k < 5; ++k) {
    add_nodes(nodes, std::vector<V>{V(-0.5 + 0.25 * k, 0, 0)});
    nodes.mass.back() = 0.2;
  }
  const double dt = 1e-6;
  SECTION("in a half model") {
    for (auto &held : nodes.held) held = held_y;
    auto part = make_rigid_part(nodes, all_of(nodes));
    nodes.force[4] = V(0, 7, -2 / dt); // held in y
    advance(part, nodes, dt, dt);
    CHECK(nodes.velocity[1].norm() < 1e-4); // along the chord of a turn by 8e-6 rad
    CHECK(nodes.velocity[4][2] == Approx(-6));
    CHECK(nodes.velocity[2][2] == Approx(-2));
    for (const V &v : nodes.velocity) CHECK(v[1] == 0);
    CHECK((angular_momentum(nodes) - V(0, 1, 0)).norm() < 1e-12);
  }
  SECTION("in a quarter model, which cannot turn") {
    for (auto &held : nodes.held) held = held_x | held_y;
    auto part = make_rigid_part(nodes, all_of(nodes));
    CHECK_FALSE(turns(part));
    nodes.force[4] = V(3, 7, -2 / dt);
    advance(part, nodes, dt, dt);
    for (const V &v : nodes.velocity) CHECK((v - V(0, 0, -2)).norm() < 1e-12);
  }
  SECTION("without a plane, a rod is refused: nothing resists a turn about its axis") {
    CHECK_THROWS_AS(make_rigid_part(nodes, all_of(nodes)), SetupError);
  }
}

TEST_CASE("a turn by a moment has the work of the moment", "[sim]") {
  // Two forces of a couple about z, from rest: the kinetic energy is moment times angle.
  auto nodes = top();
  auto part = make_rigid_part(nodes, all_of(nodes));
  const double dt = 1e-3;
  double angle = 0, before = 0;
  for (int k = 0; k < 1000; ++k) {
    for (V &f : nodes.force) f.setZero();
    const V arm = nodes.position[0] - nodes.position[2];
    before = angle;
    angle = std::atan2(arm[1], arm[0]);
    nodes.force[0] = 3 * V(-arm[1], arm[0], 0).normalized(), nodes.force[2] = -nodes.force[0];
    advance(part, nodes, k == 0 ? dt / 2 : dt, dt);
  }
  REQUIRE(angle > 0.7); // 6 N m over 4 kg m2 for 1 s: 0.75 rad
  // At the time of the latest forces, whose angle this is. Of second order in the step.
  CHECK(kinetic_energy(nodes, all_of(nodes), dt) == Approx(6 * angle).epsilon(1e-5));
  CHECK(angle - before == Approx(1.5 * dt).epsilon(0.01));
}
