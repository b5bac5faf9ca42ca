#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/sph/body.hpp"

#include <span>

namespace ogive {

/// Copies what neighbours see of the particles, and of their mirror images, into the pair data: `fill_one(k, i, image)`
/// writes place k from particle i.
template <class Body, class F> void for_particles_and_images(const Body &body, F &&fill_one) {
  const Index n = body.points.size();
  const auto &images = body.neighbours.images;
  parallel_for(n, [&](Index i) { fill_one(i, i, MirrorImage{i, false, false}); });
  parallel_for(static_cast<Index>(images.size()), [&](Index g) { fill_one(n + g, images[g].parent, images[g]); });
}

/// Smoothing length of particle i, m.
template <class T, class Law, class K, class F> T smoothing_length(const SphBody<T, Law, K, F> &body, Index i) {
  const T h0 = reference_smoothing_length(body);
  if (!body.options.variable_smoothing) return h0;
  return h0 * std::min(std::cbrt(body.metal.density / body.points.density[i]), T(1.3));
}

/// Brings neighbour lists and pair data up to date with the nodes.
template <class T, class Law, class K, class F> void prepare(SphBody<T, Law, K, F> &body, const Nodes<T> &nodes) {
  const Index n = body.points.size();
  const std::span<const Vec3<T>> x(nodes.position.data() + body.nodes.begin, n),
      v(nodes.velocity.data() + body.nodes.begin, n);
  T h = reference_smoothing_length(body);
  if (body.options.variable_smoothing) h = parallel_max(n, h, [&](Index i) { return smoothing_length(body, i); });
  const T support = T(kernel_support) * h;
  if (are_stale(body.neighbours, x, body.symmetry, support)) {
    build_neighbours(body.neighbours, x, body.symmetry, support, body.options.skin_ratio * body.spacing);
    resize(body.pair_data, n + body.neighbours.images.size());
  }
  PairData<T> &d = body.pair_data;
  for_particles_and_images(body, [&](Index k, Index i, const MirrorImage &image) {
    const T sx = image.flip_x ? T(-1) : T(1), sy = image.flip_y ? T(-1) : T(1);
    d.x[k] = sx * x[i][0], d.y[k] = sy * x[i][1], d.z[k] = x[i][2];
    d.vx[k] = sx * v[i][0], d.vy[k] = sy * v[i][1], d.vz[k] = v[i][2];
    d.density[k] = body.points.density[i];
    d.volume[k] = kernel_volume(body, i);
    if (body.options.variable_smoothing) d.smoothing[k] = smoothing_length(body, i);
  });
}

/// Sums over the neighbours of one particle.
template <class T> struct GradientSums {
  Mat3<T> gradient; ///< sum of V_j (v_j - v_i) (x) grad W_ij, 1/s
  Mat3<T> moment;   ///< M = -sum of V_j grad W_ij (x) x_ij
};

/// The sums of particle i over the places `neighbours`. With `variable`, a pair's smoothing length is the mean of both.
template <class Kernel, bool variable, class T>
GradientSums<T> gradient_sums(const PairData<T> &d, Index i, std::span<const Index> neighbours, T h) {
  const T xi = d.x[i], yi = d.y[i], zi = d.z[i], vxi = d.vx[i], vyi = d.vy[i], vzi = d.vz[i];
  const T hi = variable ? d.smoothing[i] : h, inverse_h = T(1) / h;
  const T *const x = d.x.data(), *const y = d.y.data(), *const z = d.z.data();
  const T *const vx = d.vx.data(), *const vy = d.vy.data(), *const vz = d.vz.data();
  const T *const volume = d.volume.data(), *const smoothing = d.smoothing.data();
  const Index *const list = neighbours.data();
  const Index rounds = static_cast<Index>(neighbours.size()) / row_multiple;
  T lxx{}, lxy{}, lxz{}, lyx{}, lyy{}, lyz{}, lzx{}, lzy{}, lzz{}, mxx{}, myy{}, mzz{}, mxy{}, myz{}, mzx{};
#pragma omp simd reduction(+ : lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz, mxx, myy, mzz, mxy, myz, mzx)
  for (Index k = 0; k < rounds * row_multiple; ++k) {
    const Index j = list[k];
    const T dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
    const T inv_h = variable ? T(2) / (hi + smoothing[j]) : inverse_h;
    const T w = volume[j] * gradient_over_r<Kernel>(dx * dx + dy * dy + dz * dz, inv_h);
    const T gx = w * dx, gy = w * dy, gz = w * dz;
    const T ux = vx[j] - vxi, uy = vy[j] - vyi, uz = vz[j] - vzi;
    lxx += ux * gx, lxy += ux * gy, lxz += ux * gz;
    lyx += uy * gx, lyy += uy * gy, lyz += uy * gz;
    lzx += uz * gx, lzy += uz * gy, lzz += uz * gz;
    mxx -= gx * dx, myy -= gy * dy, mzz -= gz * dz;
    mxy -= gx * dy, myz -= gy * dz, mzx -= gz * dx;
  }
  GradientSums<T> sums;
  sums.gradient << lxx, lxy, lxz, lyx, lyy, lyz, lzx, lzy, lzz;
  sums.moment << mxx, mxy, mzx, mxy, myy, myz, mzx, myz, mzz;
  return sums;
}

/// True if all eigenvalues of the symmetric matrix `m` lie above `bound` (Sylvester's criterion for m - bound I).
template <class T> bool eigenvalues_above(const Mat3<T> &m, T bound) {
  const T a = m(0, 0) - bound, b = m(1, 1) - bound, c = m(2, 2) - bound;
  const T minor = a * b - m(0, 1) * m(0, 1);
  const T det = a * (b * c - m(1, 2) * m(1, 2)) - m(0, 1) * (m(0, 1) * c - m(1, 2) * m(0, 2)) +
                m(0, 2) * (m(0, 1) * m(1, 2) - b * m(0, 2));
  return a > T(0) && minor > T(0) && det > T(0);
}

/// B = M^-1 where neighbours surround the particle: all eigenvalues of M above 0.15 and their mean below 1.5; else the
/// identity (lone particles, strings, sheets). The highest frequency of a particle grows with the square root of B's
/// largest eigenvalue, so that the bound keeps the time step stable. On a lattice the smallest eigenvalue is 1 inside
/// and 0.24 at a corner, so that all free surfaces are corrected.
template <class T> Mat3<T> correction_matrix(const Mat3<T> &moment) {
  const bool surrounded = eigenvalues_above(moment, T(0.15)) && moment.trace() < T(4.5);
  return surrounded ? inverse(moment) : Mat3<T>(Mat3<T>::Identity());
}

/// Velocity gradient at every particle: L_i = [sum_j V_j (v_j - v_i) (x) grad W_ij] B_i; B = I in the standard form.
template <class T, class Law, class K, class F> void velocity_gradient(SphBody<T, Law, K, F> &body, const Nodes<T> &) {
  const T h = reference_smoothing_length(body);
  const auto drive = [&](auto variable) {
    parallel_for(body.points.size(), [&](Index i) {
      const auto sums = gradient_sums<K, variable.value>(body.pair_data, i, row(body.neighbours, i), h);
      if constexpr (F::corrected) {
        body.correction[i] = correction_matrix(sums.moment);
        body.points.velocity_gradient[i].noalias() = sums.gradient * body.correction[i];
      } else {
        body.points.velocity_gradient[i] = sums.gradient;
      }
    });
  };
  body.options.variable_smoothing ? drive(std::true_type{}) : drive(std::false_type{});
}

} // namespace ogive
