#pragma once

#include "ogive/sph/gradient.hpp"

namespace ogive {

/// Artificial viscosity of a body, with what does not depend on the pair.
template <class T> struct ArtificialViscosity {
  T linear{};      ///< Monaghan's alpha
  T quadratic{};   ///< Monaghan's beta
  T sound_speed{}; ///< longitudinal, m/s
};

/// Force on a particle and the power that artificial viscosity takes from it.
template <class T> struct PairForces {
  Vec3<T> force;     ///< N
  T viscous_power{}; ///< W, half of each pair's
};

/// rho_i rho_j Pi_ij of Monaghan & Gingold 1983, Pa: positive for approaching pairs, else zero. `approach` = v_ij .
/// x_ij.
template <class T>
T viscous_pressure(const ArtificialViscosity<T> &a, T approach, T r_squared, T h, T density_i, T density_j) {
  const T mu = h * std::min(approach, T(0)) / (r_squared + T(0.01) * h * h);
  return T(2) * density_i * density_j / (density_i + density_j) * mu * (a.quadratic * mu - a.linear * a.sound_speed);
}

/// f_i = V_i sum_j V_j (G_i + G_j - rho_i rho_j Pi_ij I) grad W_ij, the transpose of the velocity gradient; G = sigma
/// B.
template <class Kernel, bool variable, class T>
PairForces<T> pair_forces(const PairData<T> &d, Index i, std::span<const Index> neighbours, T h,
                          const ArtificialViscosity<T> &viscosity) {
  const T xi = d.x[i], yi = d.y[i], zi = d.z[i], vxi = d.vx[i], vyi = d.vy[i], vzi = d.vz[i];
  const T density_i = d.density[i], hi = variable ? d.smoothing[i] : h, inverse_h = T(1) / h;
  const T *const x = d.x.data(), *const y = d.y.data(), *const z = d.z.data();
  const T *const vx = d.vx.data(), *const vy = d.vy.data(), *const vz = d.vz.data();
  const T *const volume = d.volume.data(), *const density = d.density.data(), *const smoothing = d.smoothing.data();
  const T *const gxx = d.flux[0].data(), *const gxy = d.flux[1].data(), *const gxz = d.flux[2].data();
  const T *const gyx = d.flux[3].data(), *const gyy = d.flux[4].data(), *const gyz = d.flux[5].data();
  const T *const gzx = d.flux[6].data(), *const gzy = d.flux[7].data(), *const gzz = d.flux[8].data();
  const Index *const list = neighbours.data();
  const Index rounds = static_cast<Index>(neighbours.size()) / row_multiple;
  T fx{}, fy{}, fz{}, sx{}, sy{}, sz{}, power{};
#pragma omp simd reduction(+ : fx, fy, fz, sx, sy, sz, power)
  for (Index k = 0; k < rounds * row_multiple; ++k) {
    const Index j = list[k];
    const T dx = xi - x[j], dy = yi - y[j], dz = zi - z[j];
    const T r2 = dx * dx + dy * dy + dz * dz;
    const T pair_h = variable ? T(0.5) * (hi + smoothing[j]) : h;
    const T w = gradient_over_r<Kernel>(r2, variable ? T(1) / pair_h : inverse_h);
    const T approach = (vxi - vx[j]) * dx + (vyi - vy[j]) * dy + (vzi - vz[j]) * dz;
    const T q = viscous_pressure(viscosity, approach, r2, pair_h, density_i, density[j]);
    const T vw = volume[j] * w;
    fx += w * (gxx[j] * dx + gxy[j] * dy + gxz[j] * dz) - q * vw * dx;
    fy += w * (gyx[j] * dx + gyy[j] * dy + gyz[j] * dz) - q * vw * dy;
    fz += w * (gzx[j] * dx + gzy[j] * dy + gzz[j] * dz) - q * vw * dz;
    sx += vw * dx, sy += vw * dy, sz += vw * dz;
    power += q * vw * approach;
  }
  const T volume_i = volume[i];
  return {{volume_i * fx + gxx[i] * sx + gxy[i] * sy + gxz[i] * sz,
           volume_i * fy + gyx[i] * sx + gyy[i] * sy + gyz[i] * sz,
           volume_i * fz + gzx[i] * sx + gzy[i] * sy + gzz[i] * sz},
          T(0.5) * volume_i * power};
}

/// Adds the internal forces of the particles to their nodes, and the work of viscosity over `dt` (s) to its ledger.
template <class T, class Law, class K, class F>
void add_internal_force(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  PairData<T> &d = body.pair_data;
  for_particles_and_images(body, [&](Index k, Index i, const MirrorImage &image) {
    const T volume = body.point_mass[i] / body.points.density[i];
    Mat3<T> G = volume * full(body.points.deviator[i]) - volume * body.points.pressure[i] * Mat3<T>::Identity();
    if constexpr (F::corrected) G = G * body.correction[i];
    const std::array<T, 3> sign{image.flip_x ? T(-1) : T(1), image.flip_y ? T(-1) : T(1), T(1)};
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) d.flux[3 * r + c][k] = sign[r] * sign[c] * G(r, c);
    d.density[k] = body.points.density[i];
  });
  const T h = reference_smoothing_length(body);
  const ArtificialViscosity<T> viscosity{body.options.linear_viscosity, body.options.quadratic_viscosity,
                                         sound_speed(body.metal)};
  const auto drive = [&](auto variable) {
    parallel_for(body.points.size(), [&](Index i) {
      const auto pairs = pair_forces<K, variable.value>(d, i, row(body.neighbours, i), h, viscosity);
      nodes.force[body.nodes.begin + i] += pairs.force;
      body.viscous_energy[i] += dt * pairs.viscous_power;
    });
  };
  body.options.variable_smoothing ? drive(std::true_type{}) : drive(std::false_type{});
}

} // namespace ogive
