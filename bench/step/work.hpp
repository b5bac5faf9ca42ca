// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/sph/gradient.hpp"

#include <bit>
#include <cstdint>
#include <span>
#include <string>

/// \file
/// How much work the loops over pairs do, counted at one state and by hand from the code.

namespace bench {

/// Arithmetic of one particle of a cluster with one place of its list.
struct PairArithmetic {
  double flops;        ///< a fused multiply-add counts two; maximum, minimum, estimates of root and reciprocal one each
  double instructions; ///< arithmetic ones on vectors, multiplication and addition fused wherever they can be
};

// Counted for the cubic spline, a fixed smoothing length and machines with estimates of roots; what does not depend on
// the neighbour is left out. flops / instructions:
//
//   x_ij 3/3, r^2 5/3                                                                                  8/6
//   u^2 = max(r^2/h^2, 1e-12) 2/2, 1/u: estimate and Newton's step 7/5, u 1/1,
//   (dw/du)/u: far 3/2, near 3/2, difference of squares 3/2, times 1/u 1/1                            20/15
//
// gradient_sums: those and weight 2/2, V_j grad W 3/3, v_ij 3/3, nine sums 18/9, six moments 12/6, comparison with the
// support 1/1.
inline constexpr PairArithmetic gradient_arithmetic{67, 45};

// pair_forces: those and weight 1/1, v_ij . x_ij 8/6, mu: minimum, r^2 + 0.01 h^2, reciprocal 5/3, two products 9/7,
// q 5/4, weights 2/2, three sums of both terms 27/15 (the product of stress and x_ij, times w, less q V w x_ij), three
// sums of gradients 6/3, power 2/1.
inline constexpr PairArithmetic force_arithmetic{88, 60};

/// Sizes of the disc at one state and what its loops over pairs do in one step.
struct Work {
  std::int64_t particles = 0;
  std::int64_t images = 0; ///< mirror images of particles
  std::int64_t clusters = 0;
  std::int64_t listed = 0;   ///< entries of all lists
  std::int64_t within = 0;   ///< of them with a particle of the cluster within the support: those of the force loop
  std::int64_t pairs = 0;    ///< neighbours within the support, of all particles; a pair counts at both
  std::int64_t flowing = 0;  ///< particles that flowed plastically in the last step
  double gradient_bytes = 0; ///< touched by velocity_gradient()
  double force_bytes = 0;    ///< touched by add_internal_force()
  double stress_bytes = 0;   ///< touched by update_stress()
};

/// Particles of clusters with the places of their lists that a loop computes.
inline double lane_pairs(std::int64_t entries) { return static_cast<double>(entries * ogive::lanes<double>); }

/// Directed pairs of different particles within the support, images included, with the nodes where they are.
template <class Body, class T> std::int64_t count_pairs(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  const ogive::Index width = ogive::lanes<T>, places = static_cast<ogive::Index>(n.order.size());
  const auto particle = [&](ogive::Index place) {
    return place < places ? n.order[place] : n.images[place - places].parent;
  };
  const auto position = [&](ogive::Index place) -> ogive::Vec3<T> {
    const auto &x = nodes.position[body.nodes.begin + particle(place)];
    return place < places ? x : ogive::reflected(x, n.images[place - places].reflection);
  };
  const T support = n.support;
  return ogive::ordered_sum(ogive::clusters(n), std::int64_t(0), [&](ogive::Index c) {
    std::int64_t found = 0;
    for (ogive::Index k = c * width; k < std::min(body.points.size(), (c + 1) * width); ++k)
      for (const ogive::Index place : ogive::row(n, c))
        found += place != k && (position(k) - position(place)).squaredNorm() < support * support;
    return found;
  });
}

/// Counts the work at a state. Bytes: each number that a function reads or writes counts once for each of its loops, as
/// if what is read again lay in the cache; a number that is changed in place counts twice.
template <class Body, class T> Work count_work(const Body &body, const ogive::Nodes<T> &nodes) {
  const auto &n = body.neighbours;
  Work w;
  w.particles = body.points.size();
  w.images = static_cast<std::int64_t>(n.images.size());
  w.clusters = ogive::clusters(n);
  w.listed = static_cast<std::int64_t>(n.list.size());
  for (const std::uint64_t word : n.within) w.within += std::popcount(word);
  w.pairs = count_pairs(body, nodes);
  for (const T rate : body.points.plastic_strain_rate) w.flowing += rate > T(0);

  constexpr double number = sizeof(T), index = sizeof(ogive::Index), image = sizeof(ogive::MirrorImage);
  const double particles = static_cast<double>(w.particles), places = particles + static_cast<double>(w.images);
  const double lists = index * static_cast<double>(w.listed);
  // Position, velocity, volume of all places; correction and velocity gradient are written.
  w.gradient_bytes = lists + 7 * number * places + (index + (9 + 9) * number) * particles;
  // First loop: density, mass, pressure, deviator, correction are read; flux and density written. Images: flux and
  // density written. Last loop: position, velocity, volume, density, flux of all places; force and viscous energy are
  // changed.
  w.force_bytes = (index + (3 + 6 + 9 + 9 + 1) * number) * particles +
                  (image + 10 * number) * static_cast<double>(w.images) + lists + (6 + 2 + 9) * number * places +
                  (index + (3 + 1) * 2 * number) * particles;
  // Velocity gradient, the last elastic limit with its strain and temperature are read; the 13 numbers of a point are
  // changed.
  w.stress_bytes = (9 + 3 + 2 * 13) * number * particles;
  return w;
}

} // namespace bench
