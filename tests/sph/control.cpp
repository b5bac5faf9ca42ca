// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/material/library.hpp"

#include <algorithm>

using namespace ogive;
using sim_test::lattice;
using sim_test::V;

namespace {

/// A block of steel particles with bonds, and its nodes.
struct Bonded {
  Nodes<double> nodes;
  sim_test::Sph body;
};

Bonded bonded(double yield = 1e15) {
  Bonded b;
  SphOptions<double> options;
  options.linear_viscosity = options.quadratic_viscosity = 0;
  options.control.stiffness = 0.1;
  b.body = add_sph_body(b.nodes, lattice(6, 6, 6, 1e-3), fem_test::steel<double>(yield), "block", {}, options);
  return b;
}

/// One evaluation of the forces after a step of `dt` with the present velocities.
void compute_forces(Bonded &b, double dt) {
  for (auto &f : b.nodes.force) f.setZero();
  prepare(b.body, b.nodes);
  velocity_gradient(b.body);
  update_stress(b.body, dt);
  add_internal_force(b.body, b.nodes, dt);
}

/// Neighbours in rows along x move against each other.
void set_sawtooth(Bonded &b, double speed) {
  for (Index i = 0; i < b.nodes.size(); ++i)
    b.nodes.velocity[i] = V(std::lround(b.nodes.position[i][0] / 1e-3 - 0.5) % 2 ? speed : -speed, 0, 0);
}

constexpr Index width = lanes<float>;

double largest_moment(const Bonded &b) {
  const auto &bonds = b.body.bonds;
  double largest = 0;
  for (std::size_t k = 0; k < bonds.other.size(); ++k) {
    const float *of_row = &bonds.moment[3 * (k - k % width)];
    largest = std::max(largest, V(of_row[k % width], of_row[width + k % width], of_row[2 * width + k % width]).norm());
  }
  return largest;
}

/// Number of bonds that lead from particle i to others.
int bonds_of(const Bonded &b, Index i) {
  const auto &bonds = b.body.bonds;
  int count = 0;
  for (auto row = bonds.begin[i / width]; row < bonds.begin[i / width + 1]; ++row)
    count += bonds.other[row * width + i % width] != i;
  return count;
}

} // namespace

TEST_CASE("bonds see nothing of a linear field of velocity", "[sph]") {
  Bonded b = bonded();
  Mat3<double> L;
  L << 100, 250, -80, -30, 60, 20, 45, -15, -90;
  for (Index i = 0; i < b.nodes.size(); ++i) b.nodes.velocity[i] = L * b.nodes.position[i];
  compute_forces(b, 1e-8);
  REQUIRE(bonds_of(b, 0) > 0);
  // A bond of 1 mm that opened with this gradient would have 0.1 G 250/s 1e-8 s 1 mm = 19 Pa m; the rest is round-off
  // of single precision, 1e-7 of the velocities, which are those of a block of 6 mm.
  CHECK(largest_moment(b) < 1e-4);
}

TEST_CASE("a particle inside is bonded to the 18 nearest of a cubic lattice", "[sph]") {
  Bonded b = bonded();
  compute_forces(b, 1e-8);
  const Index inside = 2 + 6 * (2 + 6 * 2), corner = 0;
  CHECK(bonds_of(b, inside) == 18); // 6 at 1 mm, 12 at 1.41 mm
  CHECK(bonds_of(b, corner) == 6);
}

TEST_CASE("bonds resist neighbours that move against each other, without momentum", "[sph]") {
  Bonded with = bonded(), without = bonded();
  without.body.options.control.stiffness = 0;
  const double dt = 1e-8, speed = 10;
  for (Bonded *b : {&with, &without}) set_sawtooth(*b, speed), compute_forces(*b, dt);
  // In the middle of the block the sawtooth has no gradient: what is left is the bonds' force alone.
  const Index inside = 2 + 6 * (2 + 6 * 2);
  CHECK(with.body.points.velocity_gradient[inside].norm() < 1e-6 * speed / 1e-3);
  const double G = shear_modulus(with.body.metal.elasticity), h = 1.2e-3;
  // Of the 18 bonds the 2 along x and the 8 diagonal ones with a part along x lead to the other phase.
  const double slope = -(2 * gradient_over_r<CubicSpline>(1e-6, 1 / h) + 8 * gradient_over_r<CubicSpline>(2e-6, 1 / h));
  const double expected = 1e-18 * slope * 0.1 * G * dt * 2 * speed;
  CHECK((with.nodes.force[inside] - without.nodes.force[inside]).norm() ==
        Approx(expected).epsilon(2e-3)); // the surface's gradients reach in
  CHECK((with.nodes.force[inside] - without.nodes.force[inside])[0] * with.nodes.velocity[inside][0] < 0);

  V sum = V::Zero();
  double size = 0;
  for (const V &f : with.nodes.force) sum += f, size += f.norm();
  CHECK(sum.norm() < 1e-6 * size); // single precision, the forces of hundreds of pairs
  CHECK(hourglass_energy(with.body) > 0);
  CHECK(hourglass_energy(without.body) == 0);
}

TEST_CASE("bonds across mirror planes are those of the whole block", "[sph]") {
  // The block and its quarter; velocities are random, with the symmetry of the planes.
  const auto block = [](int nx, int ny, SymmetryPlanes planes, const V &origin) {
    Bonded b;
    SphOptions<double> options;
    options.control.stiffness = 0.1;
    auto layout = lattice(nx, ny, 5, 1e-3);
    for (V &p : layout.positions) p -= origin;
    b.body = add_sph_body(b.nodes, layout, fem_test::steel<double>(1e15), "block", planes, options);
    for (Index i = 0; i < b.nodes.size(); ++i) {
      const V &x = b.nodes.position[i];
      const double phase = 1e4 * (std::abs(x[0]) + 1.7 * std::abs(x[1])) + 2.3e4 * x[2];
      b.nodes.velocity[i] =
          V(std::copysign(std::sin(phase), x[0]), std::copysign(std::cos(3 * phase), x[1]), std::sin(2 * phase));
    }
    compute_forces(b, 1e-8);
    return b;
  };
  const Bonded whole = block(8, 8, {}, V(4e-3, 4e-3, 0)), quarter = block(4, 4, {true, true}, V::Zero());
  double size = 0;
  for (const V &f : whole.nodes.force) size = std::max(size, f.norm());
  REQUIRE(size > 0);
  int compared = 0;
  for (Index i = 0; i < whole.nodes.size(); ++i)
    for (Index k = 0; k < quarter.nodes.size(); ++k)
      if ((whole.nodes.position[i] - quarter.nodes.position[k]).norm() < 1e-9) {
        REQUIRE((whole.nodes.force[i] - quarter.nodes.force[k]).norm() < 1e-6 * size);
        REQUIRE(whole.body.bonds.energy[i] == Approx(quarter.body.bonds.energy[k]).epsilon(1e-5));
        ++compared;
      }
  CHECK(compared == 4 * 4 * 5);
}

TEST_CASE("the energy of a vibration goes into the bonds and back", "[sph]") {
  Bonded b = bonded();
  set_sawtooth(b, 1);
  auto model = sim_test::model_of(std::move(b.nodes), std::move(b.body));
  double dt = 0.2 * stable_time_step(model), kinetic = 0, stored = 0, left = 1e30;
  for (int i = 0; i < 400; ++i) {
    step(model, dt);
    const Energy<double> e = energy(model);
    if (i == 0) kinetic = total(e);
    if (e.hourglass > stored) stored = e.hourglass, left = stored;
    left = std::min(left, e.hourglass);
    // The work of a bond is summed with the weight of the end of the step, an error of second order in the step.
    REQUIRE(total(e) == Approx(kinetic).epsilon(1e-4));
  }
  CHECK(stored > 0.02 * kinetic); // the surfaces, which feel the sawtooth, turn most of it into waves
  CHECK(left < 0.6 * stored);
}

TEST_CASE("a bond bears a fraction of the flow stress, less while the metal flows, and nothing once it has failed",
          "[sph]") {
  Bonded strong = bonded(), weak = bonded(1e6);
  for (Bonded *b : {&strong, &weak}) {
    compute_forces(*b, 1e-8); // the flow stress is known from now on
    set_sawtooth(*b, 20);
    compute_forces(*b, 1e-8);
  }
  CHECK(largest_moment(strong) > 1);
  // 0.2 of the flow stress over the longest bond.
  CHECK(largest_moment(weak) <= 0.2 * 1e6 * std::sqrt(2.0) * 1e-3 * (1 + 1e-6));

  Bonded flowing = bonded();
  compute_forces(flowing, 1e-8);
  set_sawtooth(flowing, 20);
  prepare(flowing.body, flowing.nodes), velocity_gradient(flowing.body);
  std::fill(flowing.body.points.plastic_strain_rate.begin(), flowing.body.points.plastic_strain_rate.end(), 1.0);
  add_internal_force(flowing.body, flowing.nodes, 1e-8);
  CHECK(largest_moment(flowing) == Approx(0.1 * largest_moment(strong)).epsilon(1e-6));

  strong.body.metal.damage.effect = FailureEffect::no_tension;
  std::fill(strong.body.points.damage.begin(), strong.body.points.damage.end(), 1.0);
  compute_forces(strong, 1e-8);
  CHECK(largest_moment(strong) == 0);
}
