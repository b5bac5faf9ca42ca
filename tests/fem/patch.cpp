// SPDX-License-Identifier: BSD-3-Clause
#include "brick.hpp"
#include "catch.hpp"

#include <omp.h>

using namespace fem_test;

TEMPLATE_TEST_CASE("a linear velocity field gives its gradient in every hex", "[fem]", OnePoint, SelectiveReduced) {
  auto s = solid<TestType>(distorted_brick(3, 0.01, 0.2));
  M L;
  L << 3, -2, 5, 7, 1, -4, 2, 6, -8;
  for (Index n = 0; n < s.nodes.size(); ++n) s.nodes.velocity[n] = L * s.nodes.position[n] + V(1, 2, 3);
  velocity_gradient(s.body, s.nodes);
  for (const M &found : s.body.points.velocity_gradient) CHECK((found - L).cwiseAbs().maxCoeff() < 1e-11);
}

TEMPLATE_TEST_CASE("a uniform stress leaves interior nodes without force", "[fem]", OnePoint, SelectiveReduced) {
  auto s = solid<TestType>(distorted_brick(3, 0.01, 0.2));
  velocity_gradient(s.body, s.nodes);
  const Sym3<double> sigma{300e6, -200e6, 100e6, 150e6, -50e6, 80e6};
  for (Index i = 0; i < s.body.points.size(); ++i) {
    s.body.points.deviator[i] = deviator(sigma);
    s.body.points.pressure[i] = -trace(sigma) / 3;
  }
  add_internal_force(s.body, s.nodes, 1e-8);
  const double scale = 300e6 * 0.01 * 0.01;
  Index interior = 0;
  for (Index k = 1; k <= 2; ++k)
    for (Index j = 1; j <= 2; ++j)
      for (Index i = 1; i <= 2; ++i, ++interior) CHECK(s.nodes.force[(k * 4 + j) * 4 + i].norm() < 1e-12 * scale);
  CHECK(interior == 8);
}

TEMPLATE_TEST_CASE("internal forces carry neither momentum nor spin", "[fem]", OnePoint, SelectiveReduced) {
  auto s = solid<TestType>(distorted_brick(3, 0.01, 0.2));
  Noise noise;
  for (auto &v : s.nodes.velocity) v = 100 * noise.vector();
  compute_forces(s, 1e-8);
  V force = V::Zero(), moment = V::Zero();
  double scale = 0;
  for (Index n = 0; n < s.nodes.size(); ++n) {
    force += s.nodes.force[n];
    moment += cross<double>(s.nodes.position[n], s.nodes.force[n]);
    scale += s.nodes.force[n].norm();
  }
  CHECK(scale > 1);
  CHECK(force.norm() < 1e-13 * scale);
  // Round-off of sums of forces with arms of up to 0.05 m.
  CHECK(moment.norm() < 1e-13 * scale * 0.05);
}

TEMPLATE_TEST_CASE("the power of the forces is the work of the stress", "[fem]", OnePoint, SelectiveReduced) {
  auto s = solid<TestType>(distorted_brick(2, 0.01, 0.2), {0.0, 0.0, 0.0, 0.0});
  Noise noise;
  for (auto &v : s.nodes.velocity) v = 100 * noise.vector();
  compute_forces(s, 1e-9);
  double power = 0, stress_power = 0;
  for (Index n = 0; n < s.nodes.size(); ++n) power += s.nodes.force[n].dot(s.nodes.velocity[n]);
  for (Index i = 0; i < s.body.points.size(); ++i)
    stress_power += s.body.point_mass[i] / s.body.metal.density *
                    double_dot(stress(load(s.body.points, i)), symmetric_part(s.body.points.velocity_gradient[i]));
  // Density and positions differ by the strain of the step, up to 1e-9 s 1e4/s.
  CHECK(-power == Approx(stress_power).epsilon(1e-4));
}

TEST_CASE("the forces do not depend on the number of threads", "[fem]") {
  const auto forces_with = [](int threads) {
    omp_set_num_threads(threads);
    auto s = solid<OnePoint>(distorted_brick(9, 0.01, 0.2));
    Noise noise;
    for (auto &v : s.nodes.velocity) v = 100 * noise.vector();
    const double dt = stable_time_step(s.body, s.nodes);
    for (int i = 0; i < 3; ++i) step(s, dt);
    s.nodes.force.emplace_back(
        V::Constant(hourglass_energy(s.body) + internal_energy(s.body) + viscous_energy(s.body)));
    return s.nodes.force;
  };
  const int before = omp_get_max_threads();
  const auto one = forces_with(1), three = forces_with(3);
  omp_set_num_threads(before);
  CHECK(one == three);
}
