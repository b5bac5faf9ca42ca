// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fem/hex8.hpp"

#include "brick.hpp"
#include "catch.hpp"
#include "ogive/mesh/hex_geometry.hpp"

using namespace fem_test;

namespace {

Corners<double> distorted_hex(std::uint32_t seed) { return corners(distorted_brick(1, 1.0, 0.2, seed), 0); }

} // namespace

TEST_CASE("mean gradients are the volume's derivatives and the Gauss points' average", "[fem]") {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto x = distorted_hex(seed);
    const auto mean = mean_gradient<double>(x);
    const auto b = corner_integrals<double>(mean);
    Corners<double> average = Corners<double>::Zero();
    double volume = 0;
    for (int p = 0; p < 8; ++p) {
      const auto point = point_gradient<double>(x, p);
      average += point.volume * point.gradient;
      volume += point.volume;
    }
    // 2x2x2 points integrate both exactly: only round-off is left.
    CHECK(mean.volume == Approx(volume).epsilon(1e-13));
    CHECK((b - average).cwiseAbs().maxCoeff() < 1e-14);
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) {
        // The volume is linear in each coordinate, so a central difference has no truncation error.
        auto high = x, low = x;
        high(a, i) += 0.1, low(a, i) -= 0.1;
        CHECK(b(a, i) == Approx((hex_volume<double>(high) - hex_volume<double>(low)) / 0.2).margin(1e-13));
      }
  }
}

TEST_CASE("a sheared brick has the volume of its triple product", "[fem]") {
  M F;
  F << 1.1, 0.3, -0.2, 0.1, 0.9, 0.25, 0.05, -0.15, 1.3;
  const Corners<double> x = corners(brick<double>(1, 1, 1, V::Ones()), 0) * F.transpose();
  CHECK(hex_volume<double>(x) == Approx(determinant<double>(F)).epsilon(1e-14));
  CHECK(8 * smallest_corner_jacobian<double>(x) == Approx(determinant<double>(F)).epsilon(1e-14));
}

TEST_CASE("trilinear coefficients invert", "[fem]") {
  const auto x = distorted_hex(3);
  const Eigen::Matrix<double, 1, 3> centre = x.colwise().mean();
  const Corners<double> back = corner_values<double>(modes<double>(x)).rowwise() + centre;
  CHECK((back - x).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("lumped volumes add up, are positive and keep the centre of volume", "[fem]") {
  const auto x = distorted_hex(4);
  const auto share = lumped_volumes<double>(x);
  CHECK(share.sum() == Approx(hex_volume<double>(x)).epsilon(1e-14));
  CHECK(share.minCoeff() > 0);
  V centre = V::Zero();
  for (int p = 0; p < 8; ++p) {
    const V at = x.transpose() * shape_functions<double>(gauss_point<double>(p));
    centre += determinant<double>(jacobian(x, gauss_point<double>(p))) * at;
  }
  CHECK((x.transpose() * share - centre).norm() < 1e-14);
}

TEST_CASE("natural coordinates invert the trilinear map, outside too", "[fem]") {
  const auto x = distorted_hex(5);
  Noise noise;
  for (int trial = 0; trial < 50; ++trial) {
    const V xi = 1.3 * noise.vector();
    const V point = x.transpose() * shape_functions<double>(xi);
    const V found = natural_coordinates<double>(x, point);
    // The map's derivative is about 1/2: an error of round-off in space is one of round-off in xi.
    CHECK((found - xi).norm() < 1e-12);
    const auto weights = shape_functions<double>(found);
    CHECK(weights.sum() == Approx(1.0).epsilon(1e-14));
    CHECK((x.transpose() * weights - point).norm() < 1e-13);
  }
}

TEST_CASE("a hex tells which points lie in it", "[fem]") {
  const auto cube = corners(brick<double>(1, 1, 1, V::Ones()), 0);
  CHECK(lies_in_hex<double>(cube, V(0.5, 0.5, 0.5)));
  CHECK(lies_in_hex<double>(cube, V(1, 1, 1)));
  CHECK(lies_in_hex<double>(cube, V(0.5, 0.25, 0)));
  CHECK_FALSE(lies_in_hex<double>(cube, V(1 + 1e-12, 0.5, 0.5)));
  CHECK_FALSE(lies_in_hex<double>(cube, V(0.5, 0.5, -3)));
  // Faces of a distorted hex are triangles here and bilinear in the natural coordinates: points near a face may differ.
  Noise noise;
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto x = distorted_hex(seed);
    for (int trial = 0; trial < 50; ++trial) {
      const V xi = 2 * noise.vector();
      const double most = xi.cwiseAbs().maxCoeff();
      if (most > 0.9 && most < 1.1) continue;
      CHECK(lies_in_hex<double>(x, x.transpose() * shape_functions<double>(xi)) == (most < 1));
    }
  }
}

TEST_CASE("natural coordinates refuse a point that has none", "[fem]") {
  // The upper face has half the size of the lower one: seen in the natural coordinates, the edges meet at z = 2, and
  // there is no image beyond it off the axis that all edges share.
  auto x = corners(brick<double>(1, 1, 1, V::Ones()), 0);
  x.bottomRows<4>().leftCols<2>() *= 0.5;
  CHECK(natural_coordinates<double>(x, V(0.1, 0.1, 1.2)).allFinite());
  CHECK_THROWS_AS(natural_coordinates<double>(x, V(0.3, 0.2, 2.0)), SetupError);
  CHECK_THROWS_AS(natural_coordinates<double>(x, V(0.3, std::nan(""), 0.2)), SetupError);
}
