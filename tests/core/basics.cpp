// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/material/stress_update.hpp"

#include <string>

using namespace ogive;

namespace {

const Mat3<double> some_matrix = (Mat3<double>() << 2, -1, 0.5, 3, 4, -2, 1, 0.25, 5).finished();

} // namespace

TEST_CASE("a wrong input is named with its value and what is allowed", "[core]") {
  CHECK_NOTHROW(require(true, "plate thickness (m)", -0.5, "must be positive"));
  CHECK_THROWS_AS(require(false, "plate thickness (m)", -0.5, "must be positive"), SetupError);
  CHECK_THROWS_WITH(require(false, "plate thickness (m)", -0.5, "must be positive"),
                    "plate thickness (m) = -0.5: must be positive");
  CHECK_THROWS_WITH(require(false, "nose", std::string("round"), "must be blunt"), "nose = round: must be blunt");
}

TEST_CASE("inverse, determinant and cross product", "[core]") {
  // Round-off of a few dozen operations.
  CHECK((some_matrix * inverse(some_matrix) - Mat3<double>::Identity()).norm() < 1e-14);
  CHECK(determinant(some_matrix) == Approx(2 * (20 + 0.5) + 1 * (15 + 2) + 0.5 * (0.75 - 4)).epsilon(1e-14));
  CHECK(determinant<double>(inverse(some_matrix)) == Approx(1 / determinant(some_matrix)).epsilon(1e-14));
  CHECK(cross<double>({1, 2, 3}, {-2, 0, 5}) == Vec3<double>(10, -11, 4));
}

TEST_CASE("symmetric tensors agree with full matrices", "[core]") {
  const Sym3<double> a = symmetric_part(some_matrix), b{1, -2, 3, 0.5, -0.25, 4};
  CHECK((full(a) - 0.5 * (some_matrix + some_matrix.transpose())).norm() == 0);
  CHECK(trace(a) == some_matrix.trace());
  CHECK(double_dot(a, b) == Approx((full(a).transpose() * full(b)).trace()).epsilon(1e-14));
  CHECK(std::abs(trace(deviator(a))) < 1e-14);
  CHECK(von_mises(deviator(Sym3<double>{200, 0, 0, 0, 0, 0})) == Approx(200)); // uniaxial tension
  CHECK(von_mises(Sym3<double>{0, 0, 0, 10, 0, 0}) == Approx(std::sqrt(3.0) * 10));
}

TEST_CASE("the rotation of a step turns about the spin's axis by 2 atan(omega dt / 2)", "[core]") {
  const Vec3<double> omega(300, -200, 600); // |omega| = 700/s
  Mat3<double> L;
  L << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  const double dt = 1e-3;
  const Mat3<double> Q = spin_rotation(L, dt);
  CHECK((Q * Q.transpose() - Mat3<double>::Identity()).norm() < 1e-14);
  CHECK(determinant(Q) == Approx(1));
  CHECK((Q * omega - omega).norm() < 1e-11);
  CHECK(std::acos((Q.trace() - 1) / 2) == Approx(2 * std::atan(0.35)).epsilon(1e-12)); // Hughes & Winget 1980
  const Vec3<double> x = Vec3<double>(1, 2, 3) - omega * (omega.dot(Vec3<double>(1, 2, 3)) / omega.squaredNorm());
  CHECK(cross<double>(x, Q * x).dot(omega) > 0); // in the sense of the spin

  const Sym3<double> s{1, -2, 1, 0.5, -0.25, 4};
  CHECK((full(rotated(s, Q)) - Q * full(s) * Q.transpose()).norm() < 1e-14);
  CHECK(von_mises(rotated(s, Q)) == Approx(von_mises(s)).epsilon(1e-14));
}

TEST_CASE("the gradient of a rigid rotation of any size has no rate of deformation at midstep", "[core]") {
  // x1 = R x0, v = (x1 - x0)/dt = L x1 with L = (I - R^T)/dt.
  const double a = 1.1, dt = 1e-6;
  Mat3<double> R;
  R << std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1;
  const Mat3<double> L = (Mat3<double>::Identity() - R.transpose()) / dt;
  CHECK(full(symmetric_part(L)).norm() > 0.1 / dt);
  CHECK(full(symmetric_part(midstep_gradient(L, dt))).norm() < 1e-14 / dt);
}

TEST_CASE("nodes are added as ranges and held on the mirror planes", "[core]") {
  Nodes<double> nodes;
  add_nodes(nodes, {{1, 1, 1}});
  const NodeRange range = add_nodes(nodes, {{0, 0, 2}, {0, 3, 2}, {4, 1e-9, 2}, {5, 6, 0}});
  CHECK(range.begin == 1);
  CHECK(range.end == 5);
  CHECK(nodes.velocity.size() == 5);
  CHECK(nodes.mass == std::vector<double>(5, 0.0));

  CHECK(symmetry_planes(Extent::full).copies() == 1);
  CHECK(symmetry_planes(Extent::half).copies() == 2);
  CHECK(symmetry_planes(Extent::quarter).copies() == 4);
  hold_on_planes(nodes, range, symmetry_planes(Extent::half), 1e-6);
  CHECK(nodes.held == std::vector<std::uint8_t>{0, held_y, 0, held_y, 0});
  hold_on_planes(nodes, range, symmetry_planes(Extent::quarter), 1e-6);
  CHECK(nodes.held == std::vector<std::uint8_t>{0, held_x | held_y, held_x, held_y, 0});
}
