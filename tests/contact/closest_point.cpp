// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "fem/brick.hpp"

#include "ogive/contact/closest_point.hpp"

using namespace ogive;
using fem_test::Noise, fem_test::V;

namespace {

constexpr int samples = 40;

/// Smallest distance of p to a grid of points of the triangle.
double sampled_distance(const V &p, const V &a, const V &b, const V &c) {
  double best = 1e30;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; i + j <= samples; ++j) {
      const double u = double(i) / samples, v = double(j) / samples;
      best = std::min(best, (p - ((1 - u - v) * a + u * b + v * c)).norm());
    }
  return best;
}

} // namespace

TEST_CASE("no sampled point of a triangle is nearer than the closest one", "[contact]") {
  Noise noise;
  std::array<int, 8> regions{}; // which of the three weights vanish: faces, edges and corners all occur
  for (int trial = 0; trial < 400; ++trial) {
    const V a = noise.vector(), b = noise.vector(), c = noise.vector(), p = 1.5 * noise.vector();
    const V w = closest_on_triangle(p, a, b, c);
    REQUIRE(w.minCoeff() >= 0);
    REQUIRE(w.sum() == Approx(1).epsilon(1e-12));
    const double exact = (p - (w[0] * a + w[1] * b + w[2] * c)).norm(), sampled = sampled_distance(p, a, b, c);
    REQUIRE(exact <= sampled + 1e-12);
    // Every point of the triangle lies within an edge / samples of a sample.
    const double edge = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
    REQUIRE(sampled <= exact + edge / samples);
    ++regions[(w[0] == 0) + 2 * (w[1] == 0) + 4 * (w[2] == 0)];
  }
  for (int r = 0; r < 7; ++r) CHECK(regions[r] > 5);
}

TEST_CASE("the closest point of a warped facet is that of four triangles around its middle", "[contact]") {
  Noise noise;
  const std::array<V, 4> square = {V(0, 0, 0), V(1, 0, 0), V(1, 1, 0), V(0, 1, 0)};
  for (int trial = 0; trial < 300; ++trial) {
    std::array<V, 4> corner = square;
    for (V &c : corner) c += 0.2 * noise.vector();
    const V p = V(0.5, 0.5, 0) + 1.2 * noise.vector(), middle = (corner[0] + corner[1] + corner[2] + corner[3]) / 4;
    const auto point = closest_on_facet(p, corner);
    V x = V::Zero();
    double sum = 0;
    for (int k = 0; k < 4; ++k) x += point.weights[k] * corner[k], sum += point.weights[k];
    REQUIRE(sum == Approx(1).epsilon(1e-12));
    REQUIRE((x - point.position).norm() < 1e-12);
    REQUIRE(point.normal.norm() == Approx(1).epsilon(1e-12));
    REQUIRE(point.normal[2] > 0.5); // outward: the corners run counter-clockwise; slopes of up to 0.8
    double sampled = 1e30;
    for (int k = 0; k < 4; ++k)
      sampled = std::min(sampled, sampled_distance(p, corner[k], corner[(k + 1) % 4], middle));
    const double exact = std::sqrt(point.distance_squared);
    REQUIRE(exact == Approx((p - x).norm()).epsilon(1e-9));
    // A tie within 1e-6 of the squares may go to the triangle that faces p.
    REQUIRE(exact <= sampled * (1 + 1e-6));
    REQUIRE(sampled <= exact + 1.5 / samples);
  }
}

TEST_CASE("beside a folded edge the facet that faces the point gives the normal", "[contact]") {
  // The middle is lifted: the closest point lies on the common edge of two triangles seen from above the ridge.
  const std::array<V, 4> roof = {V(0, 0, 0), V(1, 0, 0), V(1, 1, 0.4), V(0, 1, 0.4)};
  const auto point = closest_on_facet<double>(V(0.5, -0.3, 0), roof);
  CHECK((point.position - V(0.5, 0, 0)).norm() < 1e-12);
  CHECK(point.weights[0] == Approx(0.5));
  CHECK(point.weights[1] == Approx(0.5));
}
