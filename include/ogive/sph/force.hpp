// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/sph/control.hpp"

namespace ogive {

/// Artificial viscosity of a body, with what does not depend on the pair.
struct ArtificialViscosity {
  float linear{};      ///< Monaghan's alpha
  float quadratic{};   ///< Monaghan's beta
  float sound_speed{}; ///< longitudinal, m/s
};

/// Forces on the particles of a cluster, with x_ij in quanta and W without its norm.
struct PairForces {
  std::array<std::array<float, cluster_size>, 3> force; ///< along x, y, z
  std::array<float, cluster_size> viscous_power; ///< that artificial viscosity takes, of both particles of each pair
};

/// f_i = V_i sum_j V_j (G_i + G_j - rho_i rho_j Pi_ij I) grad W_ij, the transpose of the velocity gradient, for the
/// particles of cluster c; G = sigma B. `h` in quanta. rho_i rho_j Pi_ij is that of Monaghan & Gingold 1983, Pa,
/// positive for approaching pairs, else zero: rho mu (beta mu - alpha c) with rho the mean density and mu = h v_ij .
/// x_ij / (r^2 + 0.01 h^2).
template <class Kernel, bool variable, class T>
PairForces pair_forces(const PairData &d, const Neighbours<T> &neighbours, Index c, float h,
                       const ArtificialViscosity &viscosity) {
  using P = Pack<float>;
  const ClusterMotion &i = d.motion[c];
  const auto xi = spread(&i.x[0][0]), yi = spread(&i.x[1][0]), zi = spread(&i.x[2][0]);
  const P vxi = spread(&i.v[0][0]), vyi = spread(&i.v[1][0]), vzi = spread(&i.v[2][0]);
  const P density_i = spread(&i.density[0]), hi = variable ? spread(&d.smoothing[c * cluster_size]) : P(h);
  const P fixed_inverse = 1 / h;
  const float half_beta = 0.5F * viscosity.quadratic, half_alpha_c = 0.5F * viscosity.linear * viscosity.sound_speed;
  P fx{}, fy{}, fz{}, sx{}, sy{}, sz{}, power{};
  for (const Index place : row_within(neighbours, c)) {
    const ClusterMotion &j = d.motion[place / cluster_size];
    const ClusterFlux &flux_j = d.flux[place / cluster_size];
    const Index at_j = place % cluster_size;
    const P dx = xi - repeat(&j.x[0][at_j]), dy = yi - repeat(&j.x[1][at_j]), dz = zi - repeat(&j.x[2][at_j]);
    const P r2 = dx * dx + 1.0F + dy * dy + dz * dz; // as in the gradient
    const P pair_h = variable ? 0.5F * (hi + repeat(&d.smoothing[place])) : hi;
    const P inverse_h = variable ? 1.0F / pair_h : fixed_inverse;
    P w = rough_slope_over_u<Kernel>(P(r2 * (inverse_h * inverse_h)));
    if constexpr (variable) w *= relative_norm(inverse_h * h);
    const P approach =
        (vxi - repeat(&j.v[0][at_j])) * dx + (vyi - repeat(&j.v[1][at_j])) * dy + (vzi - repeat(&j.v[2][at_j])) * dz;
    const P mu = min(approach, P(0.0F)) * (pair_h * rough_reciprocal(r2 + 0.01F * (pair_h * pair_h)));
    const P volume = repeat(&j.volume[at_j]);
    const P q = volume * (density_i + repeat(&j.density[at_j])) * (mu * (half_beta * mu - half_alpha_c));
    const auto flux = [&](int k) { return repeat(&flux_j[k][at_j]); };
    fx += w * ((flux(0) - q) * dx + flux(1) * dy + flux(2) * dz);
    fy += w * (flux(3) * dx + (flux(4) - q) * dy + flux(5) * dz);
    fz += w * (flux(6) * dx + flux(7) * dy + (flux(8) - q) * dz);
    const P vw = volume * w;
    sx += vw * dx, sy += vw * dy, sz += vw * dz;
    power += w * q * approach;
  }
  const auto own = [&](int k) { return spread(&d.flux[c][k][0]); };
  const P volume_i = spread(&i.volume[0]);
  PairForces sums;
  store_row_sums(&sums.force[0][0], volume_i * fx + own(0) * sx + own(1) * sy + own(2) * sz);
  store_row_sums(&sums.force[1][0], volume_i * fy + own(3) * sx + own(4) * sy + own(5) * sz);
  store_row_sums(&sums.force[2][0], volume_i * fz + own(6) * sx + own(7) * sy + own(8) * sz);
  store_row_sums(&sums.viscous_power[0], volume_i * power);
  return sums;
}

/// Brings what neighbours see of the stress up to date: G = sigma B times the volume, in the place of B, and the
/// density.
template <class T, class Law, class K, class F> void gather_fluxes(SphBody<T, Law, K, F> &body) {
  PairData &d = body.pair_data;
  const Neighbours<T> &n = body.neighbours;
  const MaterialPoints<T> &p = body.points;
  const bool corrected = is_corrected(body);
  parallel_for(clusters(n), [&](Index c) {
    for (Index l = 0; l < cluster_size; ++l) {
      const Index k = c * cluster_size + l, i = n.order[k];
      const Sym3<T> sigma = p.deviator[i] - spherical(p.pressure[i]);
      Mat3<float> G = full(sigma).template cast<float>();
      if (corrected) {
        Mat3<float> B;
        for (int m = 0; m < 9; ++m) B(m / 3, m % 3) = d.flux[c][m][l];
        G = product(G, B);
      }
      const float volume = is_filler(n, k) ? 0.0F : static_cast<float>(body.point_mass[i] / p.density[i]);
      for (int m = 0; m < 9; ++m) d.flux[c][m][l] = volume * G(m / 3, m % 3);
      d.motion[c].density[l] = static_cast<float>(p.density[i]);
    }
  });
  for_each_image(n, [&](Index from, Index to, Reflection in) {
    const std::array<float, 3> sign{in.x ? -1.0F : 1.0F, in.y ? -1.0F : 1.0F, 1.0F};
    for (int m = 0; m < 9; ++m)
      for (Index l = 0; l < cluster_size; ++l) d.flux[to][m][l] = sign[m / 3] * sign[m % 3] * d.flux[from][m][l];
    d.motion[to].density = d.motion[from].density;
  });
}

/// Adds the internal forces of the particles to their nodes, and the work of viscosity over `dt` (s) to its ledger.
/// Call it after velocity_gradient() and update_stress(). Reads the points' stress and density, the pair data and the
/// entries within the support; writes the fluxes and densities of the pair data.
template <class T, class Law, class K, class F>
void add_internal_force(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  gather_fluxes(body);
  const Neighbours<T> &neighbours = body.neighbours;
  const PairData &d = body.pair_data;
  const T h = reference_smoothing_length(body), quantum = neighbours.quantum;
  const float h_in_quanta = static_cast<float>(h / quantum);
  const ArtificialViscosity viscosity{float(body.options.linear_viscosity), float(body.options.quadratic_viscosity),
                                      float(sound_speed(body.metal))};
  const auto drive = [&]<class Kernel>(Kernel, auto variable) {
    const T scale = gradient_norm<Kernel>(T(1) / h) * quantum;
    for_each_cluster(neighbours, [&](Index c) {
      const PairForces pairs = pair_forces<Kernel, variable.value>(d, neighbours, c, h_in_quanta, viscosity);
      for (Index l = 0; l < cluster_size; ++l) {
        if (is_filler(neighbours, c * cluster_size + l)) continue;
        const Index i = neighbours.order[c * cluster_size + l];
        for (int axis = 0; axis < 3; ++axis) nodes.force[body.nodes.begin + i][axis] += scale * T(pairs.force[axis][l]);
        body.viscous_energy[i] += dt * T(0.5) * scale * T(pairs.viscous_power[l]);
      }
    });
  };
  with_choice(body.kernel, [&](auto kernel) {
    body.options.variable_smoothing ? drive(kernel, std::true_type{}) : drive(kernel, std::false_type{});
  });
  if (!body.bonds.begin.empty()) add_control_force(body, nodes, dt);
}

} // namespace ogive
