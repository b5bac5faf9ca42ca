// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "sph/block.hpp"

#include "ogive/material/library.hpp"
#include "ogive/sph/force.hpp"
#include "ogive/sph/layout.hpp"

#include <Eigen/Eigenvalues>

#include <array>

namespace verification {

namespace {

using namespace ogive;
using V = Vec3<double>;

/// Sums over the neighbours of a particle, or the integrals that they stand for.
struct Sums {
  double value = 0;                           ///< of V W
  V gradient = V::Zero();                     ///< of h V grad W
  Mat3<double> moment = Mat3<double>::Zero(); ///< M = -sum of V grad W (x) x_ij
};

double smallest_eigenvalue(const Mat3<double> &m) {
  return Eigen::SelfAdjointEigenSolver<Mat3<double>>(m, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// The sums of all particles of a layout, by the code that runs use: in the standard form velocities v = x give M, and
/// a uniform pressure of 1 Pa gives the force -2 V_i sum of V grad W.
template <class Kernel> std::vector<Sums> sums_of(const ParticleLayout<double> &layout, double ratio) {
  SphOptions<double> options;
  options.smoothing_ratio = ratio;
  options.linear_viscosity = options.quadratic_viscosity = 0;
  Nodes<double> nodes;
  auto body =
      add_sph_body<Kernel, StandardForm>(nodes, layout, library::weldox_460e_mjc<double>(), "lattice", {}, options);
  nodes.velocity = nodes.position;
  prepare(body, nodes);
  velocity_gradient(body);
  for (double &p : body.points.pressure) p = 1;
  add_internal_force(body, nodes, 0.0);
  const double h = reference_smoothing_length(body);
  std::vector<Sums> sums(layout.positions.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i].value = layout.volumes[i] * kernel_value<Kernel>(0.0, h);
  for_each_neighbour_pair(body.neighbours, [&](Index i, Index j) {
    const double w = kernel_value<Kernel>((nodes.position[i] - nodes.position[j]).norm(), h);
    sums[i].value += layout.volumes[j] * w, sums[j].value += layout.volumes[i] * w;
  });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i].gradient = -h / (2 * layout.volumes[i]) * nodes.force[i];
    sums[i].moment = body.points.velocity_gradient[i];
  }
  return sums;
}

/// Where a particle lies: half a distance behind so many faces of a cube.
constexpr std::array<const char *, 4> sites{"inside", "at a face", "at an edge", "at a corner"};

/// The sums of a cube of particles in a simple cubic lattice at the four sites; only there.
template <class Kernel> std::array<Sums, 4> lattice_sums(double ratio) {
  const int reach = static_cast<int>(kernel_support * ratio) + 1, n = 2 * reach + 1;
  const auto all = sums_of<Kernel>(sph_test::block(n, n, n, 0.0, 1.0), ratio);
  std::array<Sums, 4> at;
  for (int site = 0; site < 4; ++site) {
    const auto index = [&](int axis) { return axis < site ? 0 : reach; };
    at[site] = all[(index(2) * n + index(1)) * n + index(0)];
  }
  return at;
}

/// The integrals over the part of space that begins `depth` smoothing lengths behind the first `faces` coordinate
/// planes; midpoint rule, h = 1.
template <class Kernel> Sums integrals(int faces, double depth) {
  constexpr int intervals = 80;
  std::array<double, 3> from, size;
  for (int d = 0; d < 3; ++d) {
    from[d] = d < faces ? -std::min(depth, kernel_support) : -kernel_support;
    size[d] = (kernel_support - from[d]) / intervals;
  }
  Sums sums;
  for (int k = 0; k < intervals; ++k)
    for (int j = 0; j < intervals; ++j)
      for (int i = 0; i < intervals; ++i) {
        const V x(from[0] + (i + 0.5) * size[0], from[1] + (j + 0.5) * size[1], from[2] + (k + 0.5) * size[2]);
        const double volume = size[0] * size[1] * size[2];
        const V gradient = -volume * gradient_over_r<Kernel>(x.squaredNorm(), 1.0) * x;
        sums.value += volume * kernel_value<Kernel>(x.norm(), 1.0);
        sums.gradient += gradient;
        sums.moment += gradient * x.transpose();
      }
  return sums;
}

/// Errors of the sum of V W at a site for lattices of so many distances in a smoothing length.
template <class Kernel> std::vector<double> errors(int site) {
  std::vector<double> found;
  for (const double ratio : {1.2, 2.4, 4.8}) {
    const double exact = site == 0 ? 1.0 : integrals<Kernel>(site, 0.5 / ratio).value;
    found.push_back(lattice_sums<Kernel>(ratio)[site].value - exact);
  }
  return found;
}

void add_disc(Rung &rung, const std::string &lattice, const ParticleLayout<double> &disc, double radius,
              double thickness) {
  const double h = SphOptions<double>{}.smoothing_ratio * disc.spacing;
  const auto sums = sums_of<CubicSpline>(disc, SphOptions<double>{}.smoothing_ratio);
  double least = 10, greatest = 0, root = 0, worst = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Mat3<double> inverse_moment = inverse(sums[i].moment);
    root = std::max(root, std::sqrt((inverse_moment * inverse_moment).norm()));
    const V &x = disc.positions[i];
    if (std::min({radius - std::hypot(x[0], x[1]), -x[2], x[2] + thickness}) < kernel_support * h) continue;
    least = std::min(least, sums[i].value), greatest = std::max(greatest, sums[i].value);
    worst = std::max(worst, (sums[i].moment - Mat3<double>::Identity()).norm());
  }
  lies_between(rung, lattice + ", inside: least Σ V W", least, 0.9, 1.1);
  lies_between(rung, lattice + ", inside: greatest Σ V W", greatest, 0.9, 1.1);
  vanishes(rung, lattice + ", inside: greatest \\|M − I\\|", worst, 0.1);
  lies_between(rung, lattice + ", anywhere: greatest root of \\|M⁻²\\|", root, 1, 6.3);
}

} // namespace

Rung kernel_sums() {
  Rung rung;
  rung.name = "kernel_sums";
  const double ratio = SphOptions<double>{}.smoothing_ratio;
  const auto lattice = lattice_sums<CubicSpline>(ratio);
  for (int site = 0; site < 4; ++site) {
    const Sums &found = lattice[site];
    const Sums exact = integrals<CubicSpline>(site, 0.5 / ratio);
    const std::string where = sites[site];
    compare(rung, "Σ V W " + where, exact.value, found.value, site == 0 ? 0.005 : 0.15);
    if (site == 0)
      vanishes(rung, "h \\|Σ V ∇W\\| " + where, found.gradient.norm(), round_off_of_pairs);
    else
      compare(rung, "h \\|Σ V ∇W\\| " + where, exact.gradient.norm(), found.gradient.norm(), 0.15);
    compare(rung, "least eigenvalue of M " + where, smallest_eigenvalue(exact.moment),
            smallest_eigenvalue(found.moment), 0.15);
  }
  converges(rung, "cubic spline inside, order in Δ/h", 5, errors<CubicSpline>(0), 4);
  converges(rung, "Wendland C2 inside, order in Δ/h", 6, errors<WendlandC2>(0), 5);
  converges(rung, "cubic spline at a face, order in Δ/h", 2, errors<CubicSpline>(1), 1.7);
  converges(rung, "cubic spline at a corner, order in Δ/h", 2, errors<CubicSpline>(3), 1.7);
  const DiscShape<double> disc{12.0, 9.0, 1.0};
  add_disc(rung, "cubic disc", cubic_disc(disc, Extent::full), disc.radius, disc.thickness);
  add_disc(rung, "ring disc", ring_disc(disc, Extent::full), disc.radius, disc.thickness);
  return rung;
}

} // namespace verification
