// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/sph/body.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

namespace ogive {

/// Calls `f(c)` for each cluster, in parallel. `f` must write only what belongs to the cluster's particles.
template <class T, class F> void for_each_cluster(const Neighbours<T> &n, F &&f) {
  // All in one piece: a pack that is handed to a function goes through memory.
  parallel_for_chunks(
      clusters(n), 32, [&](Index begin, Index end) __attribute__((flatten)) {
        for (Index c = begin; c < end; ++c) f(c);
      });
}

/// Calls `f(b)` for each block of places, in parallel. `f` must write only what belongs to the block's particles.
template <class T, class F> void for_each_block(const Neighbours<T> &n, F &&f) {
  parallel_for_chunks(
      blocks(n), 8, [&](Index begin, Index end) __attribute__((flatten)) {
        for (Index b = begin; b < end; ++b) f(b);
      });
}

/// Calls `f(from, to, reflection)` for each cluster `to` that is the mirror image of the cluster `from`, in parallel.
template <class T, class F> void for_each_image(const Neighbours<T> &n, F &&f) {
  parallel_for(static_cast<Index>(n.images.size()),
               [&](Index g) { f(n.images[g].cluster, clusters(n) + g, n.images[g].reflection); });
}

/// Calls `f(i, lane)` for the particle i at each place first + lane of a pack, except for fillers.
template <class Body, class F> void for_each_lane(const Body &body, Index first, F &&f) {
  for (Index l = 0; l < lanes<typename Body::Scalar>; ++l)
    if (!is_filler(body.neighbours, first + l)) f(body.neighbours.order[first + l], l);
}

/// Smoothing length of particle i, m.
template <class T, class Law, class K, class F> T smoothing_length(const SphBody<T, Law, K, F> &body, Index i) {
  const T h0 = reference_smoothing_length(body);
  if (!body.options.variable_smoothing) return h0;
  return h0 * std::min(std::cbrt(body.metal.density / body.points.density[i]), T(1.3));
}

/// True if the damage of the particles follows the pressure of their neighbours.
template <class T, class Law, class K, class F> bool sees_neighbours(const SphBody<T, Law, K, F> &body) {
  return !body.points.neighbour_pressure.empty();
}

/// Builds the neighbour lists for particles at `x` (m), complete within `support` (m), and makes room for pair data.
template <class T, class Law, class K, class F>
void build_lists(SphBody<T, Law, K, F> &body, std::span<const Vec3<T>> x, T support) {
  const T skin = body.options.skin_ratio * body.spacing;
  release(body.pair_data.flux); // makes way for what the search needs; each step writes it anew
  build_neighbours(body.neighbours, x, body.symmetry, support, skin);
  PairData &d = body.pair_data;
  const std::size_t seen = places(body.neighbours);
  resize_tightly(d.motion, seen / cluster_size);
  resize_tightly(d.flux, seen / cluster_size);
  if (body.options.variable_smoothing) resize_tightly(d.smoothing, seen);
  if (sees_neighbours(body)) resize_tightly(d.pressure, seen);
}

/// Brings neighbour lists and pair data up to date. Reads positions and velocities of the nodes and density, damage
/// and, where damage follows that of the neighbours, pressure of the points. Writes the lists if they are stale, and
/// the pair data except corrections and fluxes.
template <class T, class Law, class K, class F> void prepare(SphBody<T, Law, K, F> &body, const Nodes<T> &nodes) {
  const Index count = body.points.size();
  const std::span<const Vec3<T>> x(nodes.position.data() + body.nodes.begin, count),
      v(nodes.velocity.data() + body.nodes.begin, count);
  T h = reference_smoothing_length(body);
  if (body.options.variable_smoothing) h = parallel_max(count, h, [&](Index i) { return smoothing_length(body, i); });
  const T support = T(kernel_support) * h;
  if (are_stale(body.neighbours, x, body.symmetry, support)) build_lists(body, x, support);
  PairData &d = body.pair_data;
  const Neighbours<T> &n = body.neighbours;
  parallel_for(clusters(n), [&](Index c) {
    ClusterMotion &motion = d.motion[c];
    for (Index l = 0; l < cluster_size; ++l) {
      const Index k = c * cluster_size + l, i = n.order[k];
      for (int axis = 0; axis < 3; ++axis) {
        motion.x[axis][l] = in_quanta(x[i][axis], n.quantum);
        motion.v[axis][l] = static_cast<float>(v[i][axis]);
      }
      motion.volume[l] = is_filler(n, k) ? 0.0F : static_cast<float>(kernel_volume(body, i));
      motion.density[l] = static_cast<float>(body.points.density[i]);
      if (body.options.variable_smoothing) d.smoothing[k] = static_cast<float>(smoothing_length(body, i) / n.quantum);
      if (sees_neighbours(body)) d.pressure[k] = static_cast<float>(body.points.pressure[i]);
    }
  });
  for_each_image(n, [&](Index from, Index to, Reflection in) {
    d.motion[to] = d.motion[from];
    for (Index l = 0; l < cluster_size; ++l) {
      if (in.x) d.motion[to].x[0][l] *= -1, d.motion[to].v[0][l] *= -1;
      if (in.y) d.motion[to].x[1][l] *= -1, d.motion[to].v[1][l] *= -1;
      const Index seen = from * cluster_size + l, shown = to * cluster_size + l;
      if (body.options.variable_smoothing) d.smoothing[shown] = d.smoothing[seen];
      if (sees_neighbours(body)) d.pressure[shown] = d.pressure[seen];
    }
  });
}

/// Sums over the neighbours of each particle of a block, in single precision; x_ij in quanta, W without its norm.
template <class Width = SimdWidth> struct GradientSums {
  /// One number for each place.
  using Places = std::array<float, block_size<>>;
  std::array<Places, 9> gradient; ///< sum of V_j (v_j - v_i) (x) grad W_ij, row first
  std::array<Places, 6> moment;   ///< M = -sum of V_j grad W_ij (x) x_ij: xx, yy, zz, xy, yz, zx
  Places pressure; ///< sum of V_j p_j |grad W_ij|/r with its sign, the particle itself included; optional
  Places weight;   ///< that sum without p_j
};

/// Adds the sums of cluster c over its neighbours at its places `at` of the block; marks the groups within the support.
/// `h` in quanta. With `variable`, a pair's smoothing length is the mean of both. Pressures with `with_pressure` only.
template <class Kernel, bool variable, bool with_pressure, class T>
void sum_gradient(const PairData &d, Neighbours<T> &neighbours, Index c, float h, GradientSums<> &sums, Index at) {
  using P = Pack<float>;
  const ClusterMotion &i = d.motion[c];
  const auto xi = spread(&i.x[0][0]), yi = spread(&i.x[1][0]), zi = spread(&i.x[2][0]);
  const P vxi = spread(&i.v[0][0]), vyi = spread(&i.v[1][0]), vzi = spread(&i.v[2][0]);
  const P hi = variable ? spread(&d.smoothing[c * cluster_size]) : P(h), fixed_inverse = 1 / h;
  P lxx{}, lxy{}, lxz{}, lyx{}, lyy{}, lyz{}, lzx{}, lzy{}, lzz{}, mxx{}, myy{}, mzz{}, mxy{}, myz{}, mzx{};
  P weight{}, pressure{};
  BitWriter within{bits(neighbours, c)};
  for (const Index place : row(neighbours, c)) {
    const ClusterMotion &j = d.motion[place / cluster_size];
    const Index at_j = place % cluster_size;
    const P dx = xi - repeat(&j.x[0][at_j]), dy = yi - repeat(&j.x[1][at_j]), dz = zi - repeat(&j.x[2][at_j]);
    const P inverse_h = variable ? 2.0F / (hi + repeat(&d.smoothing[place])) : fixed_inverse;
    // One quantum squared more, so that 1/u is finite.
    const P u2 = (dx * dx + 1.0F + dy * dy + dz * dz) * (inverse_h * inverse_h);
    P w = rough_slope_over_u<Kernel>(u2) * repeat(&j.volume[at_j]);
    if constexpr (variable) w *= relative_norm(inverse_h * h);
    const P gx = w * dx, gy = w * dy, gz = w * dz;
    const P ux = repeat(&j.v[0][at_j]) - vxi, uy = repeat(&j.v[1][at_j]) - vyi, uz = repeat(&j.v[2][at_j]) - vzi;
    lxx += ux * gx, lxy += ux * gy, lxz += ux * gz;
    lyx += uy * gx, lyy += uy * gy, lyz += uy * gz;
    lzx += uz * gx, lzy += uz * gy, lzz += uz * gz;
    mxx -= gx * dx, myy -= gy * dy, mzz -= gz * dz;
    mxy -= gx * dy, myz -= gy * dz, mzx -= gz * dx;
    if constexpr (with_pressure) weight += w, pressure += w * repeat(&d.pressure[place]);
    within.push(any_below(u2, P(float(support_squared))));
  }
  within.finish();
  const auto store = [&](auto &to, std::initializer_list<P> values) {
    auto next = to.begin();
    for (const P &value : values) store_row_sums(&(*next++)[at], value);
  };
  store(sums.gradient, {lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz});
  store(sums.moment, {mxx, myy, mzz, mxy, myz, mzx});
  if constexpr (with_pressure) store_row_sums(&sums.pressure[at], pressure), store_row_sums(&sums.weight[at], weight);
}

/// The moments of a pack of particles from the place `at` of a block on, times `scale`.
template <class T> Mat3<Pack<T>> moment_of(const GradientSums<> &sums, Index at, T scale) {
  const auto m = [&](int k) { return scale * load_wide<T>(&sums.moment[k][at]); };
  Mat3<Pack<T>> moment;
  moment << m(0), m(3), m(5), m(3), m(1), m(4), m(5), m(4), m(2);
  return moment;
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
  const Mat3<N> inverse_moment = inverse(moment), squared = product(inverse_moment, inverse_moment);
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

/// Writes component `k` at the places from `first` on, a pack of them, in single precision.
template <class T> void store_by_clusters(std::vector<ClusterFlux> &flux, int k, Index first, const Pack<T> &values) {
  constexpr Index length = std::min(lanes<T>, cluster_size);
  std::array<float, lanes<T>> narrow;
  store_narrow(narrow.data(), values);
  for (Index at = 0; at < lanes<T>; at += length)
    std::copy_n(&narrow[at], length, &flux[(first + at) / cluster_size][k][(first + at) % cluster_size]);
}

/// Velocity gradient at every particle: L_i = [sum_j V_j (v_j - v_i) (x) grad W_ij] B_i; B = I in the standard form.
/// Reads the neighbour lists and pair data that prepare() has brought up to date. Writes the points' velocity gradients
/// and, where damage follows it, mean pressure of the neighbours; for add_internal_force() the corrections B and the
/// bits of the entries within the support.
template <class T, class Law, class K, class F> void velocity_gradient(SphBody<T, Law, K, F> &body) {
  Neighbours<T> &neighbours = body.neighbours;
  PairData &d = body.pair_data;
  const T h = reference_smoothing_length(body), quantum = neighbours.quantum;
  const float h_in_quanta = static_cast<float>(h / quantum);
  const bool corrected = is_corrected(body);
  const auto drive = [&]<class Kernel>(Kernel, auto variable, auto with_pressure) {
    const T norm = gradient_norm<Kernel>(T(1) / h);
    for_each_block(neighbours, [&](Index b) {
      GradientSums<> sums;
      for (Index at = 0; at < block_size<>; at += cluster_size)
        sum_gradient<Kernel, variable.value, with_pressure.value>(d, neighbours, (b * block_size<> + at) / cluster_size,
                                                                  h_in_quanta, sums, at);
      for (Index at = 0; at < block_size<>; at += lanes<T>) {
        const Index first = b * block_size<> + at;
        Mat3<Pack<T>> L;
        for (int k = 0; k < 9; ++k) L(k / 3, k % 3) = norm * quantum * load_wide<T>(&sums.gradient[k][at]);
        if (corrected) {
          const Mat3<Pack<T>> B = correction_matrix(moment_of<T>(sums, at, norm * quantum * quantum));
          L = product(L, B);
          for (int k = 0; k < 9; ++k) store_by_clusters(d.flux, k, first, B(k / 3, k % 3));
        }
        for_each_lane(body, first, [&](Index i, Index lane) {
          body.points.velocity_gradient[i] = lane_of(L, lane);
          // Weights are negative, or none where all around is removed.
          if constexpr (with_pressure)
            body.points.neighbour_pressure[i] =
                T(sums.pressure[at + lane] / std::min(sums.weight[at + lane], -std::numeric_limits<float>::min()));
        });
      }
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
