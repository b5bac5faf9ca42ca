// SPDX-License-Identifier: BSD-3-Clause
#include "fem/brick.hpp"
#include "record.hpp"
#include "sph/block.hpp"

#include "ogive/sph/gradient.hpp"
#include "ogive/sph/layout.hpp"

#include <functional>

namespace verification {

namespace {

using namespace ogive;
using V = Vec3<double>;
using M = Mat3<double>;
using Particles = SphBody<double, Bilinear<double>>;

constexpr double edge = 12e-3; ///< m, of the cube in which fields are given

/// A velocity field and its gradient.
struct Field {
  std::function<V(const V &)> velocity;
  std::function<M(const V &)> gradient;
};

Field linear() {
  const M L = sph_test::some_gradient();
  return {[=](const V &x) -> V { return L * x + V(1, 2, 3); }, [=](const V &) { return M(L); }};
}

/// v_x = x^2 + x y + z^2, v_y = y z, v_z = x^2 over the edge.
Field quadratic() {
  return {[](const V &x) -> V { return V(x[0] * x[0] + x[0] * x[1] + x[2] * x[2], x[1] * x[2], x[0] * x[0]) / edge; },
          [](const V &x) {
            M L;
            L << 2 * x[0] + x[1], x[0], 2 * x[2], 0, x[2], x[1], 2 * x[0], 0, 0;
            return M(L / edge);
          }};
}

/// v_x = (edge/2) sin(2 x/edge), v_y = (edge/2) cos(2 z/edge).
Field waves_field() {
  return {[](const V &x) -> V { return 0.5 * edge * V(std::sin(2 * x[0] / edge), std::cos(2 * x[2] / edge), 0); },
          [](const V &x) {
            M L = M::Zero();
            L(0, 0) = std::cos(2 * x[0] / edge), L(1, 2) = -std::sin(2 * x[2] / edge);
            return L;
          }};
}

/// Largest errors of the gradient of a field, inside (farther than the support from a surface) and anywhere, and the
/// share of the particles whose error is not mere round-off.
struct GradientError {
  double inside = 0, anywhere = 0, inexact = 0;
};

GradientError error_of(const ParticleLayout<double> &layout, const Field &field) {
  Nodes<double> nodes;
  auto body = add_sph_body(nodes, layout, fem_test::steel<double>(), "cube");
  for (Index i = 0; i < nodes.size(); ++i) nodes.velocity[i] = field.velocity(nodes.position[i]);
  prepare(body, nodes);
  velocity_gradient(body);
  const double support = kernel_support * reference_smoothing_length(body);
  GradientError error;
  for (Index i = 0; i < nodes.size(); ++i) {
    const V &x = nodes.position[i];
    const double e = (body.points.velocity_gradient[i] - field.gradient(x)).norm();
    error.anywhere = std::max(error.anywhere, e);
    if (e > round_off_of_pairs * field.gradient(x).norm()) error.inexact += 1.0 / nodes.size();
    if (std::min(x.minCoeff(), edge - x.maxCoeff()) > support) error.inside = std::max(error.inside, e);
  }
  return error;
}

/// The errors of cubes of particles, each displaced by up to `jitter` distances, with 10, 20 and 40 on an edge.
std::vector<GradientError> refined(double jitter, const Field &field) {
  std::vector<GradientError> errors;
  for (const int n : {10, 20, 40}) errors.push_back(error_of(sph_test::block(n, n, n, jitter, edge / n), field));
  return errors;
}

std::vector<double> inside(const std::vector<GradientError> &errors) {
  std::vector<double> list;
  for (const auto &e : errors) list.push_back(e.inside);
  return list;
}

std::vector<double> anywhere(const std::vector<GradientError> &errors) {
  std::vector<double> list;
  for (const auto &e : errors) list.push_back(e.anywhere);
  return list;
}

/// Root mean square of the error of the gradient at the points of distorted hexes.
template <class Rule> double hex_error(Index n, double distortion, const Field &field) {
  auto s = fem_test::solid<Rule>(fem_test::distorted_brick(n, edge / n, distortion));
  for (Index i = 0; i < s.nodes.size(); ++i) s.nodes.velocity[i] = field.velocity(s.nodes.position[i]);
  velocity_gradient(s.body, s.nodes);
  double squares = 0;
  for (std::size_t e = 0; e < s.body.hexes.size(); ++e) {
    const Corners<double> x = gather_corners(s.nodes.position, s.body.hexes[e]);
    for (int p = 0; p < Rule::points; ++p) {
      const V xi = Rule::points == 1 ? V(V::Zero()) : gauss_point<double>(p);
      const V at = x.transpose() * shape_functions<double>(xi);
      const M &found = s.body.points.velocity_gradient[e * Rule::points + p];
      squares += (found - field.gradient(at)).squaredNorm();
    }
  }
  return std::sqrt(squares / s.body.points.size());
}

std::vector<double> refined_hexes(double distortion, const Field &field) {
  std::vector<double> errors;
  for (const Index n : {6, 12, 24}) errors.push_back(hex_error<OnePoint>(n, distortion, field));
  return errors;
}

} // namespace

Rung gradients() {
  Rung rung;
  rung.name = "gradients";
  const double scale = sph_test::some_gradient().norm();
  vanishes(rung, "linear field, particles at random, by 0.05 distances, surfaces included",
           error_of(sph_test::block(10, 10, 10, 0.05, edge / 10), linear()).anywhere / scale, round_off_of_pairs);
  const auto wild = error_of(sph_test::block(10, 10, 10, 0.15, edge / 10), linear());
  vanishes(rung, "the same by 0.15 distances, inside", wild.inside / scale, round_off_of_pairs);
  vanishes(rung, "the same by 0.15 distances: share of particles without full correction", wild.inexact, 0.01);
  auto disc = ring_disc(DiscShape<double>{edge / 2, edge / 2, edge / 12}, Extent::full);
  vanishes(rung, "linear field, ring disc, surfaces included", error_of(disc, linear()).anywhere / scale,
           round_off_of_pairs);
  vanishes(rung, "linear field, distorted hexes, one point", hex_error<OnePoint>(6, 0.2, linear()) / scale, 1e-12);
  vanishes(rung, "linear field, distorted hexes, 2×2×2 points", hex_error<SelectiveReduced>(6, 0.2, linear()) / scale,
           1e-12);
  const auto lattice = refined(0, quadratic()), random = refined(0.1, quadratic()), smooth = refined(0, waves_field());
  vanishes(rung, "quadratic field, cubic lattice, inside", lattice.front().inside, round_off_of_pairs);
  converges(rung, "quadratic field, cubic lattice, order at surfaces", 1, anywhere(lattice), 0.9);
  converges(rung, "quadratic field, particles at random, order inside", 1, inside(random), 0.8);
  converges(rung, "quadratic field, particles at random, order at surfaces", 1, anywhere(random), 0.8);
  converges(rung, "sine field, cubic lattice, order inside", 2, inside(smooth), 1.8);
  converges(rung, "sine field, bricks, order", 2, refined_hexes(0, waves_field()), 1.9);
  converges(rung, "sine field, distorted hexes, order", 1, refined_hexes(0.2, waves_field()), 0.9);
  return rung;
}

} // namespace verification
