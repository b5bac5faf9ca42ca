// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/stress_update.hpp"
#include "ogive/sph/gradient.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

/// \file
/// Control of the zero-energy modes of particles: motion of neighbours against each other that the velocity gradient,
/// a mean over all of them, does not see and no stress resists. A particle arrangement under tension comes apart by
/// such motion at plastic strains that the metal would bear.
///
/// Each two particles that are close together in the undeformed body are bonded. A bond resists the part of their
/// relative motion that the velocity gradient at its ends does not explain, like a stiff and weak metal: elastic, with
/// a fraction of the shear modulus, up to a fraction of the flow stress. Its force is equal and opposite on both ends
/// and vanishes for every linear field of velocity. (Ganzenmueller 2015, Comput. Methods Appl. Mech. Eng. 286:87,
/// penalises the same part of the motion in total-Lagrangian SPH, without a bound.)

namespace ogive {

/// What the bonds of this step are made of: volumes, moduli and strengths of the particles.
template <class T, class Law, class K, class F> void prepare_bonds(SphBody<T, Law, K, F> &body, T dt) {
  const ZeroEnergyControl<T> &control = body.options.control;
  const T growth = control.stiffness * shear_modulus(body.metal.elasticity) * dt;
  const MaterialPoints<T> &p = body.points;
  Bonds<T> &bonds = body.bonds;
  parallel_for(p.size(), [&](Index i) {
    bonds.volume[i] = kernel_volume(body, i);
    bonds.growth[i] = p.plastic_strain_rate[i] > T(0) ? control.while_flowing * growth : growth;
    bonds.strength[i] = is_failed(body.metal.damage, p.damage[i]) ? T(0) : control.strength * p.quasi_static_yield[i];
  });
}

/// A row of bonds seen from the particles at this end.
template <class T> struct RowOfBonds {
  Vec3<Pack<T>> x; ///< from here to the other end, m
  Vec3<Pack<T>> v; ///< of the other end against this one, m/s
  Mat3<Pack<T>> L; ///< mean velocity gradient of both ends, 1/s
};

/// The moment of a bond after a step: q += k dt (v - L x), turned with the spin of the metal. `growth` is k dt, Pa.
template <class T, class P> Vec3<P> grown_moment(const Vec3<P> &q, const RowOfBonds<T> &bond, P growth, T dt) {
  const Mat3<P> &L = bond.L;
  const P half = T(0.5) * dt;
  const Vec3<P> spin(half * (L(2, 1) - L(1, 2)), half * (L(0, 2) - L(2, 0)), half * (L(1, 0) - L(0, 1)));
  return q + growth * (bond.v - L * bond.x) + spin.cross(q);
}

/// add_control_force() with the kernel `Kernel`.
template <class Kernel, class T, class Law, class K, class F>
void add_control_force_with(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  using P = Pack<T>;
  prepare_bonds(body, dt);
  const P inverse_h = T(1) / reference_smoothing_length(body), norm = gradient_norm<Kernel>(inverse_h);
  Bonds<T> &bonds = body.bonds;
  const Vec3<T> *position = &nodes.position[body.nodes.begin], *velocity = &nodes.velocity[body.nodes.begin];
  const Index count = body.points.size();
  parallel_for_chunks(static_cast<Index>(bonds.begin.size()) - 1, 16, [&](Index first_group, Index last_group) {
    for (Index g = first_group; g < last_group; ++g) {
      const auto member = [&](Index lane) { return std::min(g * lanes<T> + lane, count - 1); };
      const auto here = [&](auto &&value) { return pack_of<T>([&](Index lane) { return value(member(lane)); }); };
      const auto vector_here = [&](const Vec3<T> *field) {
        return Vec3<P>(here([&](Index i) { return field[i][0]; }), here([&](Index i) { return field[i][1]; }),
                       here([&](Index i) { return field[i][2]; }));
      };
      const Vec3<P> xi = vector_here(position), vi = vector_here(velocity);
      const Mat3<P> Li = load_gradients(body.points, member);
      const P volume = here([&](Index i) { return bonds.volume[i]; }),
              growth = here([&](Index i) { return bonds.growth[i]; }),
              strength = here([&](Index i) { return bonds.strength[i]; });
      Vec3<P> force = Vec3<P>::Zero();
      P work{};
      for (auto r = bonds.begin[g]; r < bonds.begin[g + 1]; ++r) {
        const Bond *ends = &bonds.ends[r * lanes<T>];
        const auto there = [&](auto &&value) {
          return pack_of<T>([&](Index lane) { return value(ends[lane].other); });
        };
        const auto sign = [&](auto flip) {
          return pack_of<T>([&](Index lane) { return ends[lane].reflection.*flip ? T(-1) : T(1); });
        };
        const Vec3<P> mirror(sign(&Reflection::x), sign(&Reflection::y), P(T(1)));
        RowOfBonds<T> bond;
        for (int d = 0; d < 3; ++d) {
          bond.x[d] = mirror[d] * there([&](Index j) { return position[j][d]; }) - xi[d];
          bond.v[d] = mirror[d] * there([&](Index j) { return velocity[j][d]; }) - vi[d];
        }
        const Mat3<P> Lj = load_gradients(body.points, [&](Index lane) { return ends[lane].other; });
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) bond.L(a, b) = T(0.5) * (Li(a, b) + mirror[a] * mirror[b] * Lj(a, b));

        T *const moment = &bonds.moment[3 * r * lanes<T>];
        const Vec3<P> before(load_pack(moment), load_pack(moment + lanes<T>), load_pack(moment + 2 * lanes<T>));
        Vec3<P> q = grown_moment<T, P>(before, bond, min(growth, there([&](Index j) { return bonds.growth[j]; })), dt);
        const P r2 = bond.x.dot(bond.x);
        const P most = min(strength, there([&](Index j) { return bonds.strength[j]; }));
        // Longest where the moment reaches the strength times the distance; none without strength or beyond the
        // support.
        const P excess = q.dot(q), bound = most * most * r2;
        q *= select(excess > bound, sqrt(bound / max(excess, P(std::numeric_limits<T>::min()))), P(T(1)));
        q *= select(is_within_support(r2, inverse_h), P(T(1)), P(T(0)));
        for (int d = 0; d < 3; ++d) store_pack(moment + d * lanes<T>, q[d]);

        const P weight =
            volume * there([&](Index j) { return bonds.volume[j]; }) * -(norm * slope_over_u<Kernel>(r2, inverse_h));
        force += weight * q;
        work += T(0.25) * weight * (before + q).dot(bond.v);
      }
      for (Index lane = 0; lane < std::min(lanes<T>, count - g * lanes<T>); ++lane) {
        const Index i = g * lanes<T> + lane;
        nodes.force[body.nodes.begin + i] += Vec3<T>(force[0][lane], force[1][lane], force[2][lane]);
        bonds.energy[i] += dt * work[lane];
      }
    }
  });
}

/// Adds the forces of the bonds to the particles' nodes, and the work of the step before, `dt` (s), to their ledger.
template <class T, class Law, class K, class F>
void add_control_force(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  with_choice(body.kernel, [&]<class Kernel>(Kernel) { add_control_force_with<Kernel>(body, nodes, dt); });
}

} // namespace ogive
