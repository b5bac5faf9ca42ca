// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "contact/joint.hpp"
#include "node_sums.hpp"

using namespace contact_test;
using fem_test::Noise;

namespace {

const auto gradient = (Mat3<double>() << 300, -200, 500, 70, 110, -400, 250, 60, -80).finished();

} // namespace

TEST_CASE("the weights of a tie reproduce linear fields", "[contact]") {
  Joint j;
  REQUIRE(j.face.size() == 9);
  const Tie<double> tie = j.tie();
  CHECK(tie.nodes.size() == 49); // the first layer, which lies within a particle distance of the face
  for (const auto &t : tie.nodes) {
    double sum = 0;
    V x = V::Zero();
    for (int c = 0; c < 8; ++c) sum += t.weights[c], x += t.weights[c] * j.nodes.position[t.masters[c]];
    CHECK(sum == Approx(1).epsilon(1e-13));
    // Newton's iteration ends at 16 epsilon of the coordinates, 4 mm.
    CHECK((x - j.nodes.position[t.slave]).norm() < 1e-16);
  }
  // After an affine motion of the masters the slaves are where it takes them.
  const std::vector<V> start = j.nodes.position;
  const Mat3<double> F = Mat3<double>::Identity() + 1e-3 * gradient;
  for (Index n = j.hexes.nodes.begin; n < j.hexes.nodes.end; ++n) {
    j.nodes.position[n] = F * start[n] + V(1, 2, 3);
    j.nodes.velocity[n] = gradient * start[n] + V(10, 20, 30);
  }
  move_slaves(tie, j.nodes);
  for (const auto &t : tie.nodes) {
    CHECK((j.nodes.position[t.slave] - F * start[t.slave] - V(1, 2, 3)).norm() < 1e-14); // round-off of 3 m
    CHECK((j.nodes.velocity[t.slave] - gradient * start[t.slave] - V(10, 20, 30)).norm() < 1e-12);
  }
}

TEST_CASE("a tie keeps mass, centre of mass, force and moment", "[contact]") {
  Joint j;
  const double mass = total_mass(j.nodes);
  const V centre = first_moment(j.nodes) / mass;
  const Tie<double> tie = j.tie();
  CHECK(total_mass(j.nodes) == Approx(mass).epsilon(1e-14));
  CHECK((first_moment(j.nodes) / total_mass(j.nodes) - centre).norm() < 1e-16);
  for (const auto &t : tie.nodes) CHECK(j.nodes.mass[t.slave] == 0);
  for (Index n = j.hexes.nodes.begin; n < j.hexes.nodes.end; ++n) CHECK(j.nodes.mass[n] > 0);

  Noise noise;
  const auto force_and_moment = [&] {
    std::pair<V, V> sums(V::Zero(), V::Zero());
    for (Index n = 0; n < j.nodes.size(); ++n) {
      sums.first += j.nodes.force[n];
      sums.second += cross<double>(j.nodes.position[n], j.nodes.force[n]);
    }
    return sums;
  };
  for (V &f : j.nodes.force) f = noise.vector();
  const auto before = force_and_moment();
  hand_over_forces(tie, j.nodes);
  const auto after = force_and_moment();
  for (const auto &t : tie.nodes) CHECK(j.nodes.force[t.slave] == V(0, 0, 0));
  // Round-off of about 400 forces of 1 N with arms of 6 mm.
  CHECK((after.first - before.first).norm() < 1e-13);
  CHECK((after.second - before.second).norm() < 1e-15);
}

TEST_CASE("a linear velocity field passes the tie", "[contact]") {
  Joint j;
  const Tie<double> tie = j.tie();
  for (Index n = 0; n < j.nodes.size(); ++n)
    if (j.nodes.mass[n] > 0) j.nodes.velocity[n] = gradient * j.nodes.position[n] + V(1, -2, 3);
  move_slaves(tie, j.nodes);
  prepare(j.particles, j.nodes);
  velocity_gradient(j.particles);
  velocity_gradient(j.hexes, j.nodes);
  // Round-off: velocities of 4 m/s to 1e-7 over distances of 0.4 mm, in single precision; of hexes to 1e-15.
  for (const auto &L : j.particles.points.velocity_gradient) CHECK((L - gradient).norm() < 1e-5 * gradient.norm());
  for (const auto &L : j.hexes.points.velocity_gradient) CHECK((L - gradient).norm() < 1e-10 * gradient.norm());
}

TEST_CASE("ties that cannot hold are refused", "[contact]") {
  Joint j;
  CHECK_THROWS_WITH(make_tie(j.nodes, j.particles.nodes, j.face, j.hexes.hexes, 0.01 * Joint::spacing),
                    Catch::Contains("no slave node lies that near"));
  // Extrapolated six particles far, the nodes behind the face would get a negative mass.
  CHECK_THROWS_WITH(make_tie(j.nodes, j.particles.nodes, j.face, j.hexes.hexes, 20 * Joint::spacing),
                    Catch::Contains("more than half of its mass"));
}
