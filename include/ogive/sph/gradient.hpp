// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/sph/body.hpp"

#include <limits>
#include <span>
#include <vector>

namespace ogive {

/// Calls `f(c)` for each cluster, in parallel. `f` must write only what belongs to the cluster's particles.
template <class T, class F> void for_each_cluster(const Neighbours<T> &n, F &&f) {
  parallel_for_chunks(clusters(n), 16, [&](Index begin, Index end) {
    for (Index c = begin; c < end; ++c) f(c);
  });
}

/// Calls `f(k, image)` for each mirror image, at place k, in parallel.
template <class T, class F> void for_each_image(const Neighbours<T> &n, F &&f) {
  const Index places = static_cast<Index>(n.order.size());
  parallel_for(static_cast<Index>(n.images.size()), [&](Index g) { f(places + g, n.images[g]); });
}

/// Calls `f(i, lane)` for each particle i of cluster c.
template <class Body, class F> void for_each_lane(const Body &body, Index c, F &&f) {
  const Index width = lanes<typename Body::Scalar>, first = c * width;
  for (Index l = 0; l < std::min(width, body.neighbours.listed - first); ++l) f(body.neighbours.order[first + l], l);
}

/// Smoothing length of particle i, m.
template <class T, class Law, class K, class F> T smoothing_length(const SphBody<T, Law, K, F> &body, Index i) {
  const T h0 = reference_smoothing_length(body);
  if (!body.options.variable_smoothing) return h0;
  return h0 * std::min(std::cbrt(body.metal.density / body.points.density[i]), T(1.3));
}

/// Builds the neighbour lists for particles at `x` (m), complete within `support` (m), and makes room for pair data.
template <class T, class Law, class K, class F>
void build_lists(SphBody<T, Law, K, F> &body, std::span<const Vec3<T>> x, T support) {
  const T skin = body.options.skin_ratio * body.spacing;
  if (body.unborn.empty()) {
    build_neighbours(body.neighbours, x, body.symmetry, support, skin);
  } else {
    std::vector<Index> born;
    for (Index i = 0; i < body.points.size(); ++i)
      if (!is_unborn(body, i)) born.push_back(i);
    build_neighbours(body.neighbours, x, std::span<const Index>(born), body.symmetry, support, skin);
  }
  resize(body.pair_data, body.neighbours.order.size() + body.neighbours.images.size());
  if (is_corrected(body))
    for (auto &B : body.pair_data.correction) B.resize(body.neighbours.order.size());
}

/// True if the damage of the particles follows the pressure of their neighbours.
template <class T, class Law, class K, class F> bool sees_neighbours(const SphBody<T, Law, K, F> &body) {
  return !body.points.neighbour_pressure.empty();
}

/// Brings neighbour lists and pair data up to date. Reads positions and velocities of the nodes and density, damage
/// and, where damage follows that of the neighbours, pressure of the points. Writes the lists if they are stale, and
/// the pair data except corrections and fluxes.
template <class T, class Law, class K, class F> void prepare(SphBody<T, Law, K, F> &body, const Nodes<T> &nodes) {
  const Index n = body.points.size();
  const std::span<const Vec3<T>> x(nodes.position.data() + body.nodes.begin, n),
      v(nodes.velocity.data() + body.nodes.begin, n);
  T h = reference_smoothing_length(body);
  if (body.options.variable_smoothing) h = parallel_max(n, h, [&](Index i) { return smoothing_length(body, i); });
  const T support = T(kernel_support) * h;
  if (are_stale(body.neighbours, x, body.symmetry, support)) build_lists(body, x, support);
  PairData<T> &d = body.pair_data;
  const auto &order = body.neighbours.order;
  parallel_for(static_cast<Index>(order.size()), [&](Index k) {
    const Index i = order[k];
    d.x[k] = x[i][0], d.y[k] = x[i][1], d.z[k] = x[i][2];
    d.vx[k] = v[i][0], d.vy[k] = v[i][1], d.vz[k] = v[i][2];
    d.volume[k] = kernel_volume(body, i), d.density[k] = body.points.density[i];
    if (body.options.variable_smoothing) d.smoothing[k] = smoothing_length(body, i);
    if (sees_neighbours(body)) d.pressure[k] = body.points.pressure[i];
  });
  for_each_image(body.neighbours, [&](Index k, const MirrorImage &image) {
    const Index i = image.place;
    const T sx = image.reflection.x ? T(-1) : T(1), sy = image.reflection.y ? T(-1) : T(1);
    d.x[k] = sx * d.x[i], d.y[k] = sy * d.y[i], d.z[k] = d.z[i];
    d.vx[k] = sx * d.vx[i], d.vy[k] = sy * d.vy[i], d.vz[k] = d.vz[i];
    d.volume[k] = d.volume[i], d.density[k] = d.density[i], d.smoothing[k] = d.smoothing[i];
    d.pressure[k] = d.pressure[i];
  });
}

/// Sums over the neighbours of each particle of a cluster.
template <class T> struct GradientSums {
  Mat3<Pack<T>> gradient; ///< sum of V_j (v_j - v_i) (x) grad W_ij, 1/s
  Mat3<Pack<T>> moment;   ///< M = -sum of V_j grad W_ij (x) x_ij
  Pack<T> pressure{};     ///< Pa, mean with the weights V_j |grad W_ij|/r, the particle itself included; optional
};

/// The sums of cluster c over its neighbours; marks those within the support. With `variable`, a pair's smoothing
/// length is the mean of both. Mean pressures with `with_pressure` only.
template <class Kernel, bool variable, bool with_pressure, class T>
GradientSums<T> gradient_sums(const PairData<T> &d, Neighbours<T> &neighbours, Index c, T h) {
  using P = Pack<T>;
  const Index first = c * lanes<T>;
  const P xi = load_pack(&d.x[first]), yi = load_pack(&d.y[first]), zi = load_pack(&d.z[first]);
  const P vxi = load_pack(&d.vx[first]), vyi = load_pack(&d.vy[first]), vzi = load_pack(&d.vz[first]);
  const P hi = variable ? load_pack(&d.smoothing[first]) : P(h);
  const P fixed_inverse = T(1) / hi, fixed_norm = gradient_norm<Kernel>(fixed_inverse);
  P lxx{}, lxy{}, lxz{}, lyx{}, lyy{}, lyz{}, lzx{}, lzy{}, lzz{}, mxx{}, myy{}, mzz{}, mxy{}, myz{}, mzx{};
  P weights{}, pressure{};
  BitWriter within{bits(neighbours, c)};
  for (const Index j : row(neighbours, c)) {
    const P dx = xi - d.x[j], dy = yi - d.y[j], dz = zi - d.z[j];
    const P r2 = dx * dx + dy * dy + dz * dz;
    const P inverse_h = variable ? T(2) / (hi + d.smoothing[j]) : fixed_inverse;
    const P norm = variable ? gradient_norm<Kernel>(inverse_h) : fixed_norm;
    const P w = norm * d.volume[j] * slope_over_u<Kernel>(r2, inverse_h);
    const P gx = w * dx, gy = w * dy, gz = w * dz;
    const P ux = d.vx[j] - vxi, uy = d.vy[j] - vyi, uz = d.vz[j] - vzi;
    lxx += ux * gx, lxy += ux * gy, lxz += ux * gz;
    lyx += uy * gx, lyy += uy * gy, lyz += uy * gz;
    lzx += uz * gx, lzy += uz * gy, lzz += uz * gz;
    mxx -= gx * dx, myy -= gy * dy, mzz -= gz * dz;
    mxy -= gx * dy, myz -= gy * dz, mzx -= gz * dx;
    if constexpr (with_pressure) weights += w, pressure += w * d.pressure[j];
    within.push(any(is_within_support(r2, inverse_h)));
  }
  within.finish();
  GradientSums<T> sums;
  sums.gradient << lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz;
  sums.moment << mxx, mxy, mzx, mxy, myy, myz, mzx, myz, mzz;
  // Weights are negative, or none where all around is removed.
  if constexpr (with_pressure) sums.pressure = pressure / min(weights, P(-std::numeric_limits<T>::min()));
  return sums;
}

/// B = M^-1 where neighbours surround the particle: |M^-2| at most 6.3 squared and the mean eigenvalue of M below 1.5;
/// else the identity (lone particles, strings, sheets). The square root of |M^-2| is at most a third above the largest
/// eigenvalue of M^-1. On a lattice it is 1.3 inside and 5.2 at a corner, at most 6.2 where particles are displaced by
/// 5 %, so that all free surfaces are corrected. The highest frequency of a particle grows with the square root of B's
/// largest eigenvalue, so that the time step needs a bound. Up to a root of 8 the correction fades out: a particle in a
/// torn neck that is corrected in one step and not in the next gains energy.
template <class N> Mat3<N> correction_matrix(const Mat3<N> &moment) {
  using std::min;
  constexpr double whole = 6.3 * 6.3 * 6.3 * 6.3, none = 8 * 8 * 8 * 8;
  const Mat3<N> inverse_moment = inverse(moment), squared = inverse_moment * inverse_moment;
  N size(0);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) size += squared(r, c) * squared(r, c);
  const auto surrounded = (size < N(none)) & (moment(0, 0) + moment(1, 1) + moment(2, 2) < N(4.5));
  const N part = min((N(none) - size) * N(1 / (none - whole)), N(1));
  const N weight = part * part * (N(3) - N(2) * part);
  Mat3<N> B;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const N one(r == c ? 1 : 0);
      B(r, c) = select(surrounded, one + weight * (inverse_moment(r, c) - one), one);
    }
  return B;
}

/// Velocity gradient at every particle: L_i = [sum_j V_j (v_j - v_i) (x) grad W_ij] B_i; B = I in the standard form.
/// Reads the neighbour lists and pair data that prepare() has brought up to date. Writes the points' velocity gradients
/// and, where damage follows it, mean pressure of the neighbours; for add_internal_force() the corrections B and the
/// bits of the entries within the support.
template <class T, class Law, class K, class F> void velocity_gradient(SphBody<T, Law, K, F> &body) {
  const T h = reference_smoothing_length(body);
  const bool corrected = is_corrected(body);
  const auto drive = [&]<class Kernel>(Kernel, auto variable, auto with_pressure) {
    for_each_cluster(body.neighbours, [&](Index c) {
      const auto sums =
          gradient_sums<Kernel, variable.value, with_pressure.value>(body.pair_data, body.neighbours, c, h);
      if constexpr (with_pressure)
        for_each_lane(body, c, [&](Index i, Index lane) { body.points.neighbour_pressure[i] = sums.pressure[lane]; });
      Mat3<Pack<T>> L = sums.gradient;
      if (corrected) {
        const Mat3<Pack<T>> B = correction_matrix(sums.moment);
        L = sums.gradient * B;
        for (int k = 0; k < 9; ++k) store_pack(&body.pair_data.correction[k][c * lanes<T>], B(k / 3, k % 3));
      }
      for_each_lane(body, c, [&](Index i, Index lane) { body.points.velocity_gradient[i] = lane_of(L, lane); });
    });
  };
  with_choice(body.kernel, [&](auto kernel) {
    const auto choose = [&](auto variable) {
      sees_neighbours(body) ? drive(kernel, variable, std::true_type{}) : drive(kernel, variable, std::false_type{});
    };
    body.options.variable_smoothing ? choose(std::true_type{}) : choose(std::false_type{});
  });
}

} // namespace ogive
