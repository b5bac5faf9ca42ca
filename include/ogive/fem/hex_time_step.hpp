// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/extremes.hpp"
#include "ogive/fem/hex_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// \file
/// The stable time step of central differences, of a hex and of a mesh.
///
/// A hex with the corner masses m_a has omega_max^2 <= 2 mu s_max + lambda tr S with S = V sum_a b_a b_a^T / m_a and
/// s_max its largest eigenvalue: the strains of the corner motions b_a (x) g span all that stress resists. For equal
/// masses (rho V/8) this is (8/rho) [...] of S = sum_a b_a b_a^T. The bound is exact for a flat hex, 2 c/thickness,
/// and for a cube, whose stiffest mode is the dilatation (3 K instead of lambda + 2 mu: 0.71 times the step edge/c at
/// Poisson's ratio 0.33). lambda is that of the present density: compressed metal is stiffer.
///
/// In a mesh the sound neighbours of a thin hex carry part of its nodes. With e running over the hexes at a node n
///   u.K u = sum_e u_e.K_e u_e <= sum_e omega_e^2 sum_a m_ea |u_a|^2 = sum_n |u_n|^2 sum_e m_en omega_e^2,
/// so that no motion is faster than the largest, over the nodes, of the means of omega_e^2 weighted with the hexes'
/// shares m_en in the node's mass. The same holds for the damping. It is the step of the worst hex only if that is
/// alone at a node or its neighbours are as bad.

namespace ogive {

/// Fraction of the bound that is used: room for hourglass modes of distorted hexes and for the change within a step.
inline constexpr double hex_courant = 0.9;

/// Most that a step may strain one of several points. Where a hex yields, a point beside a sharp corner can lose its
/// volume while the hex keeps its own: gradients there grow faster than the bound of the waves falls.
inline constexpr double largest_point_strain = 0.1;

/// An upper bound of the largest eigenvalue of a symmetric positive tensor, a few percent above it at most: Newton's
/// steps on the characteristic polynomial, which come from above. `N` is T or a pack of T, here and below.
template <class T, class N> N largest_eigenvalue_bound(const Sym3<N> &s) {
  using std::max;
  using std::sqrt;
  const N mean = trace(s) / N(3);
  const Sym3<N> d = deviator(s);
  const N j2 = N(0.5) * double_dot(d, d);
  const N j3 = determinant<N>(full(d));
  const N guess = N(2) * sqrt(j2 / N(3));
  N t = guess;
  for (int step = 0; step < 4; ++step) {
    const N slope = N(3) * t * t - j2;
    t -= select(slope > N(T(1e-3)) * j2, max((t * t * t - j2 * t - j3) / slope, N(0)), N(0));
  }
  return mean + select(guess > N(std::numeric_limits<T>::epsilon()) * mean, t, guess);
}

/// sum_a w_a b_a b_a^T of gradients (row a: b_a) with weights w_a.
template <class T> Sym3<T> gradient_moment(const Corners<T> &b, const CornerWeights<T> &w) {
  const Corners<T> wb = w.asDiagonal() * b;
  const Mat3<T> m = b.transpose() * wb;
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)};
}

/// Bounds of the fastest motion of a hex; both are inverse to its mass.
template <class N> struct FastestMotion {
  N omega_squared{}; ///< 1/s2
  N damping{};       ///< 2 zeta omega of bulk and hourglass viscosity, 1/s
};

/// Density, pressure and dilatation rate of the first point of a hex. `N` is T or a pack of T.
template <class N> struct Compression {
  N density{};    ///< kg/m3
  N pressure{};   ///< Pa
  N dilatation{}; ///< rate, 1/s
};

/// The fastest motion of a hex with the corners `x` (m), the inverse masses there (1/kg) and the state `now` of its
/// first point; `Chosen` is the rule. With SelectiveReduced the deviatoric part is bounded
/// point by point: sum_p 2 mu s_max,p + K tr S.
template <class Chosen, class T, class N, class Law, class Rule>
FastestMotion<N> fastest_motion(const HexBody<T, Law, Rule> &body, const Corners<N> &x,
                                const CornerWeights<N> &inverse_mass, const Compression<N> &now) {
  using std::max;
  const Elasticity<T> &elastic = body.metal.elasticity;
  const T mu = shear_modulus(elastic);
  const N bulk = tangent_bulk_modulus<T, N>(body.metal.eos, bulk_modulus(elastic),
                                            now.density / body.metal.density - T(1), now.pressure);
  const N lambda = bulk - T(2) / T(3) * mu;
  const T c = sound_speed(body.metal);
  const MeanGradient<N> mean = mean_gradient<N>(x);
  Sym3<N> S = gradient_moment<N>(corner_integrals<N>(mean), inverse_mass);
  S *= N(1) / mean.volume;
  FastestMotion<N> motion;
  if constexpr (Chosen::points == 1) {
    motion.omega_squared = T(2) * mu * largest_eigenvalue_bound<T>(S) + max(lambda, N(0)) * trace(S);
  } else {
    const auto of_point = [&](int p) {
      const PointGradient<N> point = point_gradient<N>(x, p);
      const Sym3<N> at_point = gradient_moment<N>(point.gradient, inverse_mass);
      return N(T(2) * mu * point.volume * largest_eigenvalue_bound<T>(at_point));
    };
    // Of a sum of two products the compiler fuses one, and which one would depend on what else it compiles: max(), of
    // what is positive, leaves it no choice.
    motion.omega_squared = bulk * trace(S) + max(of_point(0), N(0));
    for (int p = 1; p < Chosen::points; ++p) motion.omega_squared += of_point(p);
  }

  const HexOptions<T> &options = body.options;
  const N norm = gradient_norm<N>(mean), length = viscous_length<N>(norm), closing = max(-now.dilatation, N(0));
  // The slope of bulk_viscosity() over the dilatation rate.
  motion.damping = now.density * length * trace(S) *
                   (options.linear_bulk_viscosity * c + T(2) * options.quadratic_bulk_viscosity * length * closing);
  if constexpr (Chosen::points == 1) {
    N most = inverse_mass[0];
    for (int a = 1; a < 8; ++a) most = max(most, inverse_mass[a]);
    motion.damping += most * hourglass_damping<T, N>(options.hourglass_viscosity, p_wave_modulus(elastic), now.density,
                                                     mean.volume, norm);
  }
  return motion;
}

/// The fastest motion of hex e at the latest positions; `Chosen` is the rule.
template <class Chosen, class T, class Law, class Rule>
FastestMotion<T> fastest_motion(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e) {
  CornerWeights<T> inverse_mass;
  for (int a = 0; a < 8; ++a) inverse_mass[a] = T(1) / body.corner_mass[e][a];
  const Index i = e * Chosen::points;
  return fastest_motion<Chosen, T, T>(
      body, gather_corners(nodes.position, body.hexes[e]), inverse_mass,
      {body.points.density[i], body.points.pressure[i], body.points.velocity_gradient[i].trace()});
}

/// The fastest motions of a pack of hexes at the latest positions; without meaning for removed ones. `Chosen` is the
/// rule.
template <class Chosen, class T, class Law, class Rule>
FastestMotion<Pack<T>> fastest_motions(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index pack) {
  using P = Pack<T>;
  CornerWeights<P> inverse_mass;
  for (int a = 0; a < 8; ++a)
    inverse_mass[a] = P(1) / pack_of<T>([&](Index l) { return body.corner_mass[hex_in(body, pack, l)][a]; });
  const auto point = [&](Index l) { return hex_in(body, pack, l) * Chosen::points; };
  return fastest_motion<Chosen, T, P>(
      body, corner_positions(body, nodes, pack), inverse_mass,
      {pack_of<T>([&](Index l) { return body.points.density[point(l)]; }),
       pack_of<T>([&](Index l) { return body.points.pressure[point(l)]; }),
       pack_of<T>([&](Index l) { return body.points.velocity_gradient[point(l)].trace(); })});
}

/// The stable step of a motion, s: hex_courant times (2/omega) (sqrt(1 + zeta^2) - zeta).
template <class T> T stable_time_step(const FastestMotion<T> &motion) {
  const T half = T(0.5) * motion.damping;
  return T(hex_courant) * T(2) / (half + std::sqrt(half * half + motion.omega_squared));
}

/// The step that strains the fastest of several points of hex e by largest_point_strain, s.
template <class T, class Law, class Rule>
T step_of_strain(SelectiveReduced, const HexBody<T, Law, Rule> &body, Index e) {
  constexpr int points = SelectiveReduced::points;
  T fastest = std::numeric_limits<T>::min();
  for (int p = 0; p < points; ++p)
    fastest = most(fastest, full(symmetric_part(body.points.velocity_gradient[e * points + p])).squaredNorm());
  return T(largest_point_strain) / std::sqrt(fastest);
}

/// One point strains with its hex.
template <class T, class Law, class Rule> T step_of_strain(OnePoint, const HexBody<T, Law, Rule> &, Index) {
  return std::numeric_limits<T>::max();
}

/// The stable step of hex e at the latest positions if it were alone, s.
template <class T, class Law, class Rule>
T stable_time_step_of_hex(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e) {
  return with_choice(body.rule, [&]<class Chosen>(Chosen rule) {
    return least(stable_time_step(fastest_motion<Chosen>(body, nodes, e)), step_of_strain(rule, body, e));
  });
}

/// The mean of the fastest motions of the hexes at the n-th node of the body, weighted with their shares in its mass.
/// That of removed hexes does not count: it may go at any time.
template <class T, class Law, class Rule>
FastestMotion<T> mean_at_node(const HexBody<T, Law, Rule> &body, const std::vector<FastestMotion<T>> &of_hexes,
                              Index n) {
  const CornersOfNodes &list = body.corners_of_nodes;
  FastestMotion<T> mean;
  T mass{};
  for (Index k = list.begin[n]; k < list.begin[n + 1]; ++k) {
    const Index e = list.corners[k] / 8;
    if (is_removed(body, e)) continue;
    const T share = body.corner_mass[e][list.corners[k] % 8];
    mean.omega_squared += share * of_hexes[e].omega_squared;
    mean.damping += share * of_hexes[e].damping;
    mass += share;
  }
  if (!(mass > T(0))) return {};
  mean.omega_squared /= mass, mean.damping /= mass;
  return mean;
}

/// Stable step of the mesh of all hexes that are there at the latest positions, s.
template <class T, class Law, class Rule> T stable_time_step(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  const Index count = static_cast<Index>(body.hexes.size());
  std::vector<FastestMotion<T>> of_hexes(body.hexes.size());
  with_choice(body.rule, [&]<class Chosen>(Chosen) {
    for_each_pack(body, [&](Index pack) {
      const FastestMotion<Pack<T>> motions = fastest_motions<Chosen>(body, nodes, pack);
      // One without volume has no bound, and must not lower that of its neighbours.
      for_each_hex_of(body, pack, [&](Index e, Index lane) {
        if (motions.omega_squared[lane] > T(0)) of_hexes[e] = {motions.omega_squared[lane], motions.damping[lane]};
      });
    });
  });
  const T none = std::numeric_limits<T>::max();
  const T of_waves =
      parallel_min(body.nodes.size(), none, [&](Index n) { return stable_time_step(mean_at_node(body, of_hexes, n)); });
  return with_choice(body.rule, [&](auto rule) {
    return parallel_min(count, of_waves,
                        [&](Index e) { return is_removed(body, e) ? none : step_of_strain(rule, body, e); });
  });
}

/// The first of the hexes that would alone have the shortest stable step.
template <class T, class Law, class Rule>
Index shortest_step_at(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  const Index count = static_cast<Index>(body.hexes.size());
  const T none = std::numeric_limits<T>::max();
  std::vector<T> steps(body.hexes.size(), none);
  parallel_for(count, [&](Index e) {
    if (!is_removed(body, e)) steps[e] = stable_time_step_of_hex(body, nodes, e);
  });
  const T shortest = parallel_min(count, none, [&](Index e) { return steps[e]; });
  return parallel_min(count, count, [&](Index e) { return steps[e] <= shortest || is_nan(steps[e]) ? e : count; });
}

/// Adds mass to the nodes of those hexes whose stable step lies below `dt` (s), as much as brings each up to it, and
/// returns the added mass, kg. Meant for the thin hexes at a sharp tip. Density, stress and energy of the material
/// points are not changed. Throws SetupError unless dt is positive.
template <class T, class Law, class Rule> T raise_time_step(HexBody<T, Law, Rule> &body, Nodes<T> &nodes, T dt) {
  require(dt > T(0) && std::isfinite(dt), body.name + " time step to raise to (s)", dt, "must be positive");
  const T limit = dt / T(hex_courant);
  return with_choice(body.rule, [&]<class Chosen>(Chosen) {
    T added = T(0);
    for (Index e = 0; e < static_cast<Index>(body.hexes.size()); ++e) {
      const FastestMotion<T> motion = fastest_motion<Chosen>(body, nodes, e);
      // The step is stable as long as this is at most one.
      const T factor = T(0.25) * motion.omega_squared * limit * limit + T(0.5) * motion.damping * limit;
      if (!(factor > T(1))) continue;
      for (int a = 0; a < 8; ++a) {
        const T more = (factor - T(1)) * body.corner_mass[e][a];
        body.corner_mass[e][a] += more;
        nodes.mass[body.hexes[e][a]] += more;
        added += more;
      }
    }
    return added;
  });
}

} // namespace ogive
