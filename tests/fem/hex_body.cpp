// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fem/hex_body.hpp"

#include "brick.hpp"
#include "catch.hpp"

#include <numeric>

using namespace fem_test;

TEMPLATE_TEST_CASE("nodal and point masses add up to density times volume", "[fem]", OnePoint, SelectiveReduced) {
  const auto mesh = distorted_brick(4, 0.01, 0.2);
  const auto s = solid<TestType>(mesh);
  const double expected = 7850 * volume(mesh);
  CHECK(std::accumulate(s.nodes.mass.begin(), s.nodes.mass.end(), 0.0) == Approx(expected).epsilon(1e-13));
  CHECK(std::accumulate(s.body.point_mass.begin(), s.body.point_mass.end(), 0.0) == Approx(expected).epsilon(1e-13));
}

TEST_CASE("bodies follow each other in the nodes", "[fem]") {
  Nodes<double> nodes;
  const auto mesh = brick<double>(2, 1, 1, V(2, 1, 1));
  const auto first = add_hex_body(nodes, mesh, steel<double>(), "first");
  const auto second = add_hex_body(nodes, mesh, steel<double>(), "second", {.hourglass_stiffness = 0.05});
  CHECK(second.nodes.begin == first.nodes.end);
  CHECK(second.hexes[1][6] == first.hexes[1][6] + 12);
  CHECK(nodes.mass[0] == Approx(7850.0 / 8));
  // A node between two unit cubes.
  CHECK(nodes.mass[second.hexes[1][0]] == Approx(7850.0 / 4));
}

TEST_CASE("an inverted or broken mesh is refused by name and value", "[fem]") {
  Nodes<double> nodes;
  auto mesh = brick<double>(2, 2, 2, V::Ones());
  std::swap(mesh.hexes[3][0], mesh.hexes[3][1]);
  CHECK(contains(setup_error_of([&] { add_hex_body(nodes, mesh, steel<double>(), "block"); }),
                 "block hex 3 corner Jacobian (m3) = -"));
  CHECK(nodes.size() == 0);
  mesh = brick<double>(1, 1, 1, V::Ones());
  mesh.hexes[0][7] = 8;
  CHECK(
      contains(setup_error_of([&] { add_hex_body(nodes, mesh, steel<double>(), "block"); }), "block hex 0 corner = 8"));
  CHECK_THROWS_AS(add_hex_body(nodes, HexMesh<double>{}, steel<double>(), "empty"), SetupError);
  mesh = brick<double>(1, 1, 1, V::Ones());
  CHECK(contains(
      setup_error_of([&] { add_hex_body(nodes, mesh, steel<double>(), "block", {.hourglass_stiffness = -1.0}); }),
      "hourglass stiffness = -1"));
}

TEST_CASE("the first inverted hex is found", "[fem]") {
  auto s = solid<OnePoint>(brick<double>(3, 3, 3, V::Ones()));
  CHECK(first_inverted(s.body, s.nodes) == -1);
  // Pulls the top corner of the last hex through its own bottom.
  s.nodes.position[s.body.hexes[26][6]] -= V(1.5, 1.5, 1.5);
  s.nodes.position[s.body.hexes[26][4]] -= V(0, 0, 1);
  CHECK(first_inverted(s.body, s.nodes) == 26);
  s.nodes.position[0][0] = std::nan("");
  CHECK(first_inverted(s.body, s.nodes) == 0);
}

TEST_CASE("a hex of which one of several points is inverted is found", "[fem]") {
  auto s = solid<SelectiveReduced>(brick<double>(3, 3, 3, V::Ones()));
  CHECK(first_inverted(s.body, s.nodes) == -1);
  const auto corners = [&] { return gather_corners(s.nodes.position, s.body.hexes[26]); };
  double sum = 0;
  for (int p = 0; p < 8; ++p) sum += point_volume<SelectiveReduced>(corners(), p);
  CHECK(sum == Approx(hex_volume<double>(corners())).epsilon(1e-13));
  // The outer corner through the middle: the point beside it inverts, the hex as a whole has volume left.
  s.nodes.position[s.body.hexes[26][6]] -= 0.7 / 3 * V::Ones();
  CHECK(first_inverted(s.body, s.nodes) == 26);
  CHECK(smallest_point<SelectiveReduced>(corners()).point == 6);
  CHECK(smallest_point<SelectiveReduced>(corners()).volume < 0);
  CHECK(hex_volume<double>(corners()) > 0);
  CHECK(smallest_corner_jacobian<double>(corners()) < 0);
}

TEMPLATE_TEST_CASE("a rigid rotation makes no stress and turns the stress that is there", "[fem]", OnePoint,
                   SelectiveReduced) {
  auto s = solid<TestType>(distorted_brick(2, 0.01, 0.2));
  const auto start = s.nodes.position;
  const Sym3<double> pulled{2e8, -1e8, -1e8, 0.5e8, 0, 0};
  s.body.points.deviator[0] = pulled;
  const V axis(1, -2, 0.5);
  const double dt = 1e-6, angle = 0.02;
  const int steps = 200;
  for (int i = 1; i <= steps; ++i) {
    for (Index n = 0; n < s.nodes.size(); ++n) {
      const V next = rotation(axis, angle * i) * start[n] + V(0.3, 0, 0) * i * dt;
      s.nodes.velocity[n] = (next - s.nodes.position[n]) / dt;
      s.nodes.position[n] = next;
    }
    compute_forces(s, dt);
  }
  // Round-off only: 2e4 1/s of spin leave 1e-12 of rate in each step; 1 Pa is 5e-12 of Young's modulus.
  for (Index i = 1; i < s.body.points.size(); ++i) {
    CHECK(von_mises(s.body.points.deviator[i]) < 1);
    CHECK(std::abs(s.body.points.pressure[i]) < 1);
  }
  const auto expected = rotated<double>(pulled, rotation(axis, angle * steps));
  CHECK(von_mises(s.body.points.deviator[0] - expected) < 1);
  // Only the spin's round-off has been resisted.
  CHECK(hourglass_energy(s.body) < 1e-12);
}

namespace {

/// Deforms a unit cube by x -> F(t) x in `steps` steps from F = I and returns its state.
template <class Rule, class F> Solid<Rule> deform(F &&deformation, int steps, double yield) {
  auto s = solid<Rule>(brick<double>(1, 1, 1, V::Ones()), inviscid<double>(), steel<double>(yield));
  const auto start = s.nodes.position;
  for (int i = 1; i <= steps; ++i) {
    for (Index n = 0; n < 8; ++n) {
      const V next = deformation(double(i) / steps) * start[n];
      s.nodes.velocity[n] = (next - s.nodes.position[n]) / 1e-3;
      s.nodes.position[n] = next;
    }
    compute_forces(s, 1e-3);
  }
  return s;
}

} // namespace

TEMPLATE_TEST_CASE("uniaxial strain of one hex follows elastic-plastic theory", "[fem]", OnePoint, SelectiveReduced) {
  const double stretch = 1.05, yield = 400e6;
  const auto s = deform<TestType>(
      [&](double t) {
        M F = M::Identity();
        F(0, 0) = 1 + (stretch - 1) * t;
        return F;
      },
      500, yield);
  const auto &metal = s.body.metal;
  const double G = shear_modulus(metal.elasticity), K = bulk_modulus(metal.elasticity), H = metal.flow.hardening;
  const double strain = std::log(stretch);
  // q = 3 G (2/3 strain - plastic) = yield + H plastic.
  const double plastic = (2 * G * strain - yield) / (3 * G + H), q = yield + H * plastic;
  const double pressure = K * (1 / stretch - 1);
  const double axial = 2.0 / 3.0 * q - pressure, lateral = -q / 3 - pressure;
  V face = V::Zero();
  for (int a : {1, 2, 5, 6}) face += s.nodes.force[s.body.hexes[0][a]];
  // The midpoint rule's error in the logarithmic strain is (1e-4)^2/12; the return map's tolerance is 1e-9.
  for (double eps : s.body.points.plastic_strain) CHECK(eps == Approx(plastic).epsilon(1e-6));
  CHECK(face[0] == Approx(-axial).epsilon(1e-6));
  V top = V::Zero();
  for (int a : {4, 5, 6, 7}) top += s.nodes.force[s.body.hexes[0][a]];
  CHECK(top[2] == Approx(-lateral * stretch).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("elastic simple shear of one hex follows Jaumann's rate", "[fem]", OnePoint, SelectiveReduced) {
  const double shear = 1.0;
  const auto s = deform<TestType>(
      [&](double t) {
        M F = M::Identity();
        F(0, 1) = shear * t;
        return F;
      },
      1000, 1e15);
  const double G = shear_modulus(s.body.metal.elasticity);
  for (const auto &deviator : s.body.points.deviator) {
    // Closed form for a constant rate. The increment of 1e-3 is not turned by the half of its step's spin, 2.5e-4: an
    // error of first order, some 1e-3 of the normal stress, which is second order in the shear.
    CHECK(deviator.xy == Approx(G * std::sin(shear)).epsilon(5e-4));
    CHECK(deviator.xx == Approx(G * (1 - std::cos(shear))).epsilon(1.5e-3));
    CHECK(deviator.yy == Approx(-deviator.xx).epsilon(1e-10));
  }
}

TEST_CASE("bulk viscosity acts in compression only and takes energy", "[fem]") {
  for (double rate : {-50.0, 50.0}) {
    auto s = solid<OnePoint>(brick<double>(1, 1, 1, V::Constant(0.01)));
    for (Index n = 0; n < 8; ++n) s.nodes.velocity[n][0] = rate * s.nodes.position[n][0];
    compute_forces(s, 1e-9);
    const double c = sound_speed(s.body.metal), l = 0.01;
    // rho l (c1 c |D| + c2 l D^2) of a cube's edge l; the density has changed by 5e-8.
    const double expected = rate < 0 ? 7850 * l * (0.06 * c * 50 + 1.5 * l * 2500) : 0.0;
    CHECK(s.body.viscous_pressure[0] == Approx(expected).epsilon(1e-6));
    CHECK((viscous_energy(s.body) > 0) == (rate < 0));
  }
}

TEST_CASE("the kernels work in single precision", "[fem]") {
  Nodes<float> nodes;
  auto body = add_hex_body(nodes, brick<float>(4, 4, 4, Vec3<float>::Constant(0.01f)), steel<float>(), "block");
  for (Index n = 0; n < nodes.size(); ++n) nodes.velocity[n][2] = -100.0f * nodes.position[n][2];
  velocity_gradient(body, nodes);
  update_stress(body, 1e-7f);
  add_internal_force(body, nodes, 1e-7f);
  const float modulus = p_wave_modulus(body.metal.elasticity);
  // Strain 1e-5 in uniaxial strain; the density carries it with float's round-off of 6e-8.
  const auto sigma = stress(load(body.points, 0));
  CHECK(sigma.zz == Approx(-modulus * 1e-5f).epsilon(0.03));
  CHECK(stable_time_step(body, nodes) > 1e-7f);
}
