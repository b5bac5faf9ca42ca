// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/sph/control.hpp"

namespace ogive {

/// Artificial viscosity of a body, with what does not depend on the pair.
template <class T> struct ArtificialViscosity {
  T linear{};      ///< Monaghan's alpha
  T quadratic{};   ///< Monaghan's beta
  T sound_speed{}; ///< longitudinal, m/s
};

/// Forces on the particles of a cluster and the power that artificial viscosity takes from them.
template <class T> struct PairForces {
  Pack<T> x, y, z;       ///< N
  Pack<T> viscous_power; ///< W, half of each pair's
};

/// f_i = V_i sum_j V_j (G_i + G_j - rho_i rho_j Pi_ij I) grad W_ij, the transpose of the velocity gradient; G = sigma
/// B. rho_i rho_j Pi_ij is that of Monaghan & Gingold 1983, Pa, positive for approaching pairs, else zero: rho mu (beta
/// mu - alpha c) with rho the mean density and mu = h v_ij . x_ij / (r^2 + 0.01 h^2).
template <class Kernel, bool variable, class T>
PairForces<T> pair_forces(const PairData<T> &d, const Neighbours<T> &neighbours, Index c, T h,
                          const ArtificialViscosity<T> &viscosity) {
  using P = Pack<T>;
  const Index first = c * lanes<T>;
  const P xi = load_pack(&d.x[first]), yi = load_pack(&d.y[first]), zi = load_pack(&d.z[first]);
  const P vxi = load_pack(&d.vx[first]), vyi = load_pack(&d.vy[first]), vzi = load_pack(&d.vz[first]);
  const P density_i = load_pack(&d.density[first]), hi = variable ? load_pack(&d.smoothing[first]) : P(h);
  const P fixed_inverse = T(1) / hi, fixed_norm = gradient_norm<Kernel>(fixed_inverse);
  const T half_beta = T(0.5) * viscosity.quadratic, half_alpha_c = T(0.5) * viscosity.linear * viscosity.sound_speed;
  P fx{}, fy{}, fz{}, sx{}, sy{}, sz{}, power{};
  for (const Index j : row_within(neighbours, c)) {
    const P dx = xi - d.x[j], dy = yi - d.y[j], dz = zi - d.z[j];
    const P r2 = dx * dx + dy * dy + dz * dz;
    const P pair_h = variable ? T(0.5) * (hi + d.smoothing[j]) : hi;
    const P inverse_h = variable ? T(1) / pair_h : fixed_inverse;
    const P norm = variable ? gradient_norm<Kernel>(inverse_h) : fixed_norm;
    const P w = norm * slope_over_u<Kernel>(r2, inverse_h);
    const P approach = (vxi - d.vx[j]) * dx + (vyi - d.vy[j]) * dy + (vzi - d.vz[j]) * dz;
    const P mu = pair_h * min(approach, P(T(0))) * reciprocal(r2 + T(0.01) * (pair_h * pair_h));
    const P q = (density_i + d.density[j]) * mu * (half_beta * mu - half_alpha_c);
    const P vw = d.volume[j] * w, qvw = q * vw;
    fx += w * (d.flux[0][j] * dx + d.flux[1][j] * dy + d.flux[2][j] * dz), fx -= qvw * dx;
    fy += w * (d.flux[3][j] * dx + d.flux[4][j] * dy + d.flux[5][j] * dz), fy -= qvw * dy;
    fz += w * (d.flux[6][j] * dx + d.flux[7][j] * dy + d.flux[8][j] * dz), fz -= qvw * dz;
    sx += vw * dx, sy += vw * dy, sz += vw * dz;
    power += qvw * approach;
  }
  const auto own = [&](int k) { return load_pack(&d.flux[k][first]); };
  const P volume_i = load_pack(&d.volume[first]);
  return {volume_i * fx + own(0) * sx + own(1) * sy + own(2) * sz,
          volume_i * fy + own(3) * sx + own(4) * sy + own(5) * sz,
          volume_i * fz + own(6) * sx + own(7) * sy + own(8) * sz, T(0.5) * volume_i * power};
}

/// Brings what neighbours see of the stress up to date: G = sigma B times the volume, and the density.
template <class T, class Law, class K, class F> void gather_fluxes(SphBody<T, Law, K, F> &body) {
  PairData<T> &d = body.pair_data;
  const bool corrected = is_corrected(body);
  for_each_cluster(body.neighbours, [&](Index c) {
    const Index first = c * lanes<T>, *const particle = &body.neighbours.order[first];
    const MaterialPoints<T> &p = body.points;
    const auto of_lanes = [&](auto &&value) { return pack_of<T>([&](Index lane) { return value(particle[lane]); }); };
    const Pack<T> density = of_lanes([&](Index i) { return p.density[i]; });
    const Pack<T> volume = of_lanes([&](Index i) { return body.point_mass[i]; }) / density;
    const Pack<T> pressure = of_lanes([&](Index i) { return p.pressure[i]; });
    const auto component = [&](T Sym3<T>::*m) { return of_lanes([&](Index i) { return p.deviator[i].*m; }); };
    Mat3<Pack<T>> G = full(Sym3<Pack<T>>{component(&Sym3<T>::xx) - pressure, component(&Sym3<T>::yy) - pressure,
                                         component(&Sym3<T>::zz) - pressure, component(&Sym3<T>::xy),
                                         component(&Sym3<T>::yz), component(&Sym3<T>::zx)});
    if (corrected) {
      Mat3<Pack<T>> B;
      for (int k = 0; k < 9; ++k) B(k / 3, k % 3) = load_pack(&d.correction[k][first]);
      G = Mat3<Pack<T>>(G * B);
    }
    for (int k = 0; k < 9; ++k) store_pack(&d.flux[k][first], volume * G(k / 3, k % 3));
    store_pack(&d.density[first], density);
  });
  for_each_image(body.neighbours, [&](Index k, const MirrorImage &image) {
    const std::array<T, 3> sign{image.reflection.x ? T(-1) : T(1), image.reflection.y ? T(-1) : T(1), T(1)};
    for (int r = 0; r < 9; ++r) d.flux[r][k] = sign[r / 3] * sign[r % 3] * d.flux[r][image.place];
    d.density[k] = d.density[image.place];
  });
}

/// Adds the internal forces of the particles to their nodes, and the work of viscosity over `dt` (s) to its ledger.
/// Call it after velocity_gradient() and update_stress(). Reads the points' stress and density, the pair data and the
/// entries within the support; writes the fluxes and densities of the pair data.
template <class T, class Law, class K, class F>
void add_internal_force(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  gather_fluxes(body);
  const T h = reference_smoothing_length(body);
  const ArtificialViscosity<T> viscosity{body.options.linear_viscosity, body.options.quadratic_viscosity,
                                         sound_speed(body.metal)};
  const auto drive = [&]<class Kernel>(Kernel, auto variable) {
    for_each_cluster(body.neighbours, [&](Index c) {
      const auto pairs = pair_forces<Kernel, variable.value>(body.pair_data, body.neighbours, c, h, viscosity);
      for_each_lane(body, c, [&](Index i, Index lane) {
        nodes.force[body.nodes.begin + i] += Vec3<T>(pairs.x[lane], pairs.y[lane], pairs.z[lane]);
        body.viscous_energy[i] += dt * pairs.viscous_power[lane];
      });
    });
  };
  with_choice(body.kernel, [&](auto kernel) {
    body.options.variable_smoothing ? drive(kernel, std::true_type{}) : drive(kernel, std::false_type{});
  });
  if (!body.bonds.begin.empty()) add_control_force(body, nodes, dt);
}

} // namespace ogive
