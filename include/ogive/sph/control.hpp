// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/stress_update.hpp"
#include "ogive/sph/gradient.hpp"

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

/// Brings what bonds see of the particles up to date, for a step of `dt` (s).
template <class T, class Law, class K, class F>
void prepare_bonds(SphBody<T, Law, K, F> &body, const Nodes<T> &nodes, T dt) {
  const ZeroEnergyControl<T> &control = body.options.control;
  const T growth = control.stiffness * shear_modulus(body.metal.elasticity) * dt;
  const MaterialPoints<T> &p = body.points;
  Bonds<T> &bonds = body.bonds;
  parallel_for(p.size(), [&](Index i) {
    BondEnd &end = bonds.ends[i];
    for (int r = 0; r < 3; ++r) {
      end.x[r] = static_cast<float>(nodes.position[body.nodes.begin + i][r]);
      end.v[r] = static_cast<float>(nodes.velocity[body.nodes.begin + i][r]);
      for (int c = 0; c < 3; ++c) end.L[3 * r + c] = static_cast<float>(p.velocity_gradient[i](r, c));
    }
    end.volume = static_cast<float>(kernel_volume(body, i));
    end.growth = static_cast<float>(p.plastic_strain_rate[i] > T(0) ? control.while_flowing * growth : growth);
    const bool failed = is_failed(body.metal.damage, p.damage[i]);
    end.strength = failed ? 0.0F : static_cast<float>(control.strength * p.quasi_static_yield[i]);
  });
  parallel_for(static_cast<Index>(bonds.images.size()), [&](Index k) {
    const BondedTo &image = bonds.images[k];
    BondEnd end = bonds.ends[image.particle];
    const std::array<float, 3> sign{image.reflection.x ? -1.0F : 1.0F, image.reflection.y ? -1.0F : 1.0F, 1.0F};
    for (int r = 0; r < 3; ++r) {
      end.x[r] *= sign[r], end.v[r] *= sign[r];
      for (int c = 0; c < 3; ++c) end.L[3 * r + c] *= sign[r] * sign[c];
    }
    bonds.ends[p.size() + k] = end;
  });
}

/// The ends of a row of bonds on one side.
template <class Width = SimdWidth> struct RowOfEnds {
  Vec3<Pack<float>> x;                        ///< m
  Vec3<Pack<float>> v;                        ///< m/s
  Mat3<Pack<float>> L;                        ///< velocity gradient, 1/s
  Pack<float> volume{}, growth{}, strength{}; ///< m3, Pa, Pa
};

/// The ends `end(lane)`.
template <class F> RowOfEnds<> load_ends(F &&end) {
  const auto of = [&](auto &&value) { return pack_of<float>([&](Index lane) { return value(end(lane)); }); };
  RowOfEnds<> row;
  for (int d = 0; d < 3; ++d) {
    row.x[d] = of([&](const BondEnd &e) { return e.x[d]; });
    row.v[d] = of([&](const BondEnd &e) { return e.v[d]; });
  }
  for (int k = 0; k < 9; ++k) row.L(k / 3, k % 3) = of([&](const BondEnd &e) { return e.L[k]; });
  row.volume = of([](const BondEnd &e) { return e.volume; });
  row.growth = of([](const BondEnd &e) { return e.growth; });
  row.strength = of([](const BondEnd &e) { return e.strength; });
  return row;
}

/// A row of bonds seen from the particles at this end.
template <class Width = SimdWidth> struct RowOfBonds {
  Vec3<Pack<float>> x; ///< from here to the other end, m
  Vec3<Pack<float>> v; ///< of the other end against this one, m/s
  Mat3<Pack<float>> L; ///< mean velocity gradient of both ends, 1/s
};

/// The moment of a bond after a step: q += k dt (v - L x), turned with the spin of the metal. `growth` is k dt, Pa.
inline Vec3<Pack<float>> grown_moment(const Vec3<Pack<float>> &q, const RowOfBonds<> &bond, Pack<float> growth,
                                      float dt) {
  using P = Pack<float>;
  const Mat3<P> &L = bond.L;
  const P half = 0.5F * dt;
  const Vec3<P> spin(half * (L(2, 1) - L(1, 2)), half * (L(0, 2) - L(2, 0)), half * (L(1, 0) - L(0, 1)));
  Vec3<P> grown = q + cross(spin, q);
  for (int r = 0; r < 3; ++r)
    grown[r] += growth * (bond.v[r] - (L(r, 0) * bond.x[0] + L(r, 1) * bond.x[1] + L(r, 2) * bond.x[2]));
  return grown;
}

/// add_control_force() with the kernel `Kernel`.
template <class Kernel, class T, class Law, class K, class F>
void add_control_force_with(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  using P = Pack<float>;
  prepare_bonds(body, nodes, dt);
  const T h = reference_smoothing_length(body), norm = -gradient_norm<Kernel>(T(1) / h);
  const float inverse_h = static_cast<float>(T(1) / h);
  Bonds<T> &bonds = body.bonds;
  const Index count = body.points.size();
  const auto add_group = [&](Index g) {
    const auto member = [&](Index lane) { return std::min(g * lanes<float> + lane, count - 1); };
    const RowOfEnds<> here = load_ends([&](Index lane) -> const BondEnd & { return bonds.ends[member(lane)]; });
    Vec3<P> force(P(0.0F), P(0.0F), P(0.0F));
    P work{};
    for (auto r = bonds.begin[g]; r < bonds.begin[g + 1]; ++r) {
      const Index *other = &bonds.other[r * lanes<float>];
      const RowOfEnds<> there = load_ends([&](Index lane) -> const BondEnd & { return bonds.ends[other[lane]]; });
      RowOfBonds<> bond;
      for (int d = 0; d < 3; ++d) bond.x[d] = there.x[d] - here.x[d], bond.v[d] = there.v[d] - here.v[d];
      for (int k = 0; k < 9; ++k) bond.L(k / 3, k % 3) = 0.5F * (here.L(k / 3, k % 3) + there.L(k / 3, k % 3));

      float *const moment = &bonds.moment[3 * r * lanes<float>];
      const Vec3<P> before(load_pack(moment), load_pack(moment + lanes<float>), load_pack(moment + 2 * lanes<float>));
      Vec3<P> q = grown_moment(before, bond, min(here.growth, there.growth), static_cast<float>(dt));
      const P r2 = bond.x[0] * bond.x[0] + bond.x[1] * bond.x[1] + bond.x[2] * bond.x[2];
      const P u2 = r2 * (inverse_h * inverse_h);
      // Longest where the moment reaches the strength times the distance; none without strength or beyond the support.
      const P most = min(here.strength, there.strength), bound = most * most * r2;
      const P excess = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
      P scale = select(excess > bound, sqrt(bound / max(excess, P(std::numeric_limits<float>::min()))), P(1.0F));
      scale = select(u2 < P(float(support_squared)), scale, P(0.0F));
      const P weight = here.volume * there.volume * slope_over_u<Kernel>(u2);
      P power{};
      for (int d = 0; d < 3; ++d) {
        q[d] *= scale;
        store_pack(moment + d * lanes<float>, q[d]);
        force[d] += weight * q[d];
        power += (before[d] + q[d]) * bond.v[d];
      }
      work += 0.25F * weight * power;
    }
    for (Index lane = 0; lane < std::min(lanes<float>, count - g * lanes<float>); ++lane) {
      const Index i = g * lanes<float> + lane;
      for (int d = 0; d < 3; ++d) nodes.force[body.nodes.begin + i][d] += norm * T(force[d][lane]);
      bonds.energy[i] += dt * norm * T(work[lane]);
    }
  };
  // All in one piece: a pack that is handed to a function goes through memory.
  parallel_for_chunks(
      static_cast<Index>(bonds.begin.size()) - 1, 8, [&](Index first, Index last) __attribute__((flatten)) {
        for (Index g = first; g < last; ++g) add_group(g);
      });
}

/// Adds the forces of the bonds to the particles' nodes, and the work of the step before, `dt` (s), to their ledger.
template <class T, class Law, class K, class F>
void add_control_force(SphBody<T, Law, K, F> &body, Nodes<T> &nodes, T dt) {
  with_choice(body.kernel, [&]<class Kernel>(Kernel) { add_control_force_with<Kernel>(body, nodes, dt); });
}

} // namespace ogive
