// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_body.hpp"
#include "ogive/material/stress_update.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// Corner values of a node field for a pack of hexes. The nodes of removed hexes may be anywhere: their values are
/// `of_removed`.
template <class T, class Law, class Rule>
Corners<Pack<T>> gather_corners(const HexBody<T, Law, Rule> &body, const std::vector<Vec3<T>> &field, Index pack,
                                const std::array<Vec3<T>, 8> &of_removed) {
  Corners<Pack<T>> values;
  for (int a = 0; a < 8; ++a) {
    std::array<const T *, lanes<T>> at;
    for (Index l = 0; l < lanes<T>; ++l) {
      const Index e = hex_in(body, pack, l);
      at[l] = (is_removed(body, e) ? of_removed[a] : field[body.hexes[e][a]]).data();
    }
    for (int d = 0; d < 3; ++d) values(a, d) = pack_of<T>([&](Index l) { return at[l][d]; });
  }
  return values;
}

/// Positions of the corners of a pack of hexes, m; removed ones count as cubes, so that all that follows is finite.
template <class T, class Law, class Rule>
Corners<Pack<T>> corner_positions(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index pack) {
  std::array<Vec3<T>, 8> cube;
  for (int a = 0; a < 8; ++a) cube[a] = hex_corner<T>(a);
  return gather_corners(body, nodes.position, pack, cube);
}

/// Velocities of the corners of a pack of hexes, m/s; zero for removed ones.
template <class T, class Law, class Rule>
Corners<Pack<T>> corner_velocities(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index pack) {
  std::array<Vec3<T>, 8> rest;
  rest.fill(Vec3<T>::Zero());
  return gather_corners(body, nodes.velocity, pack, rest);
}

/// Calls `f(e, lane)` for each hex of a pack.
template <class T, class Law, class Rule, class F>
void for_each_hex_of(const HexBody<T, Law, Rule> &body, Index pack, F &&f) {
  const Index first = pack * lanes<T>, count = static_cast<Index>(body.hexes.size());
  for (Index l = 0; l < std::min(lanes<T>, count - first); ++l) f(first + l, l);
}

/// Calls `f(pack)` for each pack of hexes, in parallel. `f` must write only what belongs to the pack's hexes.
template <class T, class Law, class Rule, class F> void for_each_pack(const HexBody<T, Law, Rule> &body, F &&f) {
  // All in one piece: a pack that is handed to a function goes through memory.
  parallel_for_chunks(
      packs(body), 16, [&](Index begin, Index end) __attribute__((flatten)) {
        for (Index pack = begin; pack < end; ++pack) f(pack);
      });
}

/// Velocity gradient at every material point with respect to the latest positions. Reads positions and velocities of
/// the nodes; writes the points' velocity gradients and, for add_internal_force(), mean gradients and hourglass motion.
template <class T, class Law, class Rule> void velocity_gradient(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  using P = Pack<T>;
  with_choice(body.rule, [&]<class Chosen>(Chosen) {
    for_each_pack(body, [&](Index pack) {
      const Corners<P> x = corner_positions(body, nodes, pack), v = corner_velocities(body, nodes, pack);
      const HexModes<P> x_modes = modes<P>(x), v_modes = modes<P>(v);
      body.mean_gradient[pack] = mean_gradient<P>(x_modes);
      const Mat3<P> L = mean_velocity_gradient<P>(body.mean_gradient[pack], v_modes);
      if constexpr (Chosen::points == 1) {
        body.hourglass_motion[pack] = hourglass_motion<P>(x_modes, v_modes, L);
        for_each_hex_of(body, pack, [&](Index e, Index lane) { body.points.velocity_gradient[e] = lane_of(L, lane); });
      } else {
        const P mean_trace = L(0, 0) + L(1, 1) + L(2, 2);
        for (int p = 0; p < Chosen::points; ++p) {
          const Mat3<P> at_point = b_bar_velocity_gradient<P>(point_gradient<P>(x, p), mean_trace, v);
          for_each_hex_of(body, pack, [&](Index e, Index lane) {
            body.points.velocity_gradient[e * Chosen::points + p] = lane_of(at_point, lane);
          });
        }
      }
    });
  });
}

/// sum_a |b_a|^2 of a hex, 1/m2: 1.5/L^2 for a cube of edge L. `N` is T or a pack of T, here and below.
template <class N> N gradient_norm(const MeanGradient<N> &mean) {
  return N(8) * mean.integral.cwiseProduct(mean.integral).sum() / (mean.volume * mean.volume);
}

/// Length of a hex for its bulk viscosity, m: the edge of a cube, between one and sqrt(3) thicknesses of a flat hex.
template <class N> N viscous_length(N gradient_norm) {
  using std::sqrt;
  return sqrt(N(1.5) / gradient_norm);
}

/// Pressure of bulk viscosity, Pa, where the hex is being compressed: rho l (c1 c |D| + c2 l D^2) with D = tr L (1/s).
template <class T, class N>
N bulk_viscosity(const HexOptions<T> &options, N density, T sound_speed, N length, N dilatation) {
  using std::max;
  const N closing = length * max(-dilatation, N(0));
  return density * closing * (options.linear_bulk_viscosity * sound_speed + options.quadratic_bulk_viscosity * closing);
}

/// The generalised hourglass forces of a pack of hexes of one point.
template <class T, class Law, class Rule>
HourglassModes<Pack<T>> hourglass_forces_of(const HexBody<T, Law, Rule> &body, Index pack) {
  HourglassModes<Pack<T>> force;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      force(r, c) = pack_of<T>([&](Index l) { return body.hourglass_force[hex_in(body, pack, l)](r, c); });
  return force;
}

/// The hourglass forces (N) that the metal of a pack of hexes bears, of those that it would have if it stayed elastic
/// in the step `dt` (s): see the head of hourglass.hpp. Read after the stress of the step's end. For hexes of one
/// point.
template <class T, class Law, class Rule>
HourglassModes<Pack<T>> yielded_hourglass(const HexBody<T, Law, Rule> &body, Index pack,
                                          const HourglassModes<Pack<T>> &trial, T dt) {
  using P = Pack<T>;
  const auto of = [&](const std::vector<T> &field) {
    return pack_of<T>([&](Index l) { return field[hex_in(body, pack, l)]; });
  };
  const MaterialPoint<P> point = load_points(body.points, [&](Index l) { return hex_in(body, pack, l); });
  const auto flows = point.plastic_strain_rate > P(0);
  const P stress = von_mises(point.deviator), still = of(body.points.quasi_static_yield);
  const P flow_stress = select(flows, stress, still);
  const P relaxing = P(T(3) * shear_modulus(body.metal.elasticity) * dt) * point.plastic_strain_rate;
  const P returned = select(flows, stress / (stress + relaxing), P(1));
  const P strength = T(hourglass_strength) * flow_stress;
  const P squared = returned * returned * hourglass_stress_squared<P>(body.mean_gradient[pack], trial);
  const P bound = select(squared > strength * strength, strength / sqrt(squared), P(1));
  return P(returned * bound) * trial;
}

/// Moves the generalised hourglass forces of a pack of hexes through the step `dt` (s) and returns those that act at
/// its end, N. They turn with the material, yield with it and vanish when it fails; their work is added to the hexes'
/// hourglass energy. For hexes of one point.
template <class T, class Law, class Rule>
HourglassModes<Pack<T>> update_hourglass(HexBody<T, Law, Rule> &body, Index pack, const Mat3<Pack<T>> &L,
                                         Pack<T> density, Pack<T> gradient_norm, T dt) {
  using P = Pack<T>;
  using Forces = HourglassModes<P>;
  const auto &options = body.options;
  if (!(options.hourglass_stiffness > T(0)) && !(options.hourglass_viscosity > T(0))) return Forces::Constant(P(0));
  const MeanGradient<P> &mean = body.mean_gradient[pack];
  const Forces &rate = body.hourglass_motion[pack].rate;
  const T modulus = p_wave_modulus(body.metal.elasticity);
  const Mat3<P> R = spin_rotation<P>(midstep_gradient<P>(L, P(dt)), P(dt));
  const Forces turned = R * hourglass_forces_of(body, pack);
  const Forces trial = turned + P(dt) * hourglass_force_rate<P>(mean, options.hourglass_stiffness * modulus, rate);
  Forces force = yielded_hourglass<T>(body, pack, trial, dt);
  if (body.metal.damage.effect != FailureEffect::none)
    for (int k = 0; k < 12; ++k)
      force.data()[k] =
          pack_of<T>([&](Index l) { return is_failed(body, hex_in(body, pack, l)) ? T(0) : force.data()[k][l]; });
  const P damping = hourglass_damping<T, P>(options.hourglass_viscosity, modulus, density, mean.volume, gradient_norm);
  const Forces viscous = damping * rate;
  const P work = P(dt) * (P(0.5) * (turned + force) + viscous).cwiseProduct(rate).sum();
  for_each_hex_of(body, pack, [&](Index e, Index lane) {
    body.hourglass_energy[e] += work[lane];
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) body.hourglass_force[e](r, c) = force(r, c)[lane];
  });
  return force + viscous;
}

/// Corner forces of a pack of hexes from its stress and the viscous pressure q (Pa), N. `L` is the velocity gradient of
/// the first points, `Chosen` the rule.
template <class Chosen, class T, class Law, class Rule>
Corners<Pack<T>> stress_forces(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index pack, const Mat3<Pack<T>> &L,
                               Pack<T> density, Pack<T> gradient_norm, Pack<T> q, T dt) {
  using P = Pack<T>;
  const MeanGradient<P> &mean = body.mean_gradient[pack];
  const auto points_of = [&](int p) {
    return load_points(body.points, [&, p](Index l) { return hex_in(body, pack, l) * Chosen::points + p; });
  };
  if constexpr (Chosen::points == 1) {
    const MaterialPoint<P> point = points_of(0);
    const Mat3<P> sigma = full(point.deviator - spherical(P(point.pressure + q)));
    HexModes<P> force = force_modes<P>(mean, sigma);
    add_hourglass_forces<P>(mean, body.hourglass_motion[pack].shape,
                            update_hourglass(body, pack, L, density, gradient_norm, dt), force);
    return corner_values<P>(force);
  } else {
    const Corners<P> x = corner_positions(body, nodes, pack);
    Corners<P> force = Corners<P>::Constant(P(0));
    P pressure_volume = q * mean.volume;
    for (int p = 0; p < Chosen::points; ++p) {
      const MaterialPoint<P> at_point = points_of(p);
      const PointGradient<P> point = point_gradient<P>(x, p);
      force += deviatoric_forces<P>(point, full(at_point.deviator));
      pressure_volume += point.volume * at_point.pressure;
    }
    return force + P(pressure_volume / mean.volume) * corner_integrals<P>(mean);
  }
}

/// Adds the forces of stress, bulk viscosity and hourglass control to the nodes, N, and their work over the step `dt`
/// (s) to the energies. Call it after `velocity_gradient` and `update_stress`.
template <class T, class Law, class Rule> void add_internal_force(HexBody<T, Law, Rule> &body, Nodes<T> &nodes, T dt) {
  using P = Pack<T>;
  const T c = sound_speed(body.metal);
  with_choice(body.rule, [&]<class Chosen>(Chosen) {
    for_each_pack(body, [&](Index pack) {
      const auto first_point = [&](Index l) { return hex_in(body, pack, l) * Chosen::points; };
      const Mat3<P> L = load_gradients(body.points, first_point);
      const P density = pack_of<T>([&](Index l) { return body.points.density[first_point(l)]; });
      const MeanGradient<P> &mean = body.mean_gradient[pack];
      const P norm = gradient_norm<P>(mean), dilatation = L(0, 0) + L(1, 1) + L(2, 2);
      const P q = bulk_viscosity<T, P>(body.options, density, c, viscous_length<P>(norm), dilatation);
      const Corners<P> force = stress_forces<Chosen>(body, nodes, pack, L, density, norm, q, dt);
      for_each_hex_of(body, pack, [&](Index e, Index lane) {
        body.viscous_energy[e] -=
            T(0.5) * dt * (body.viscous_pressure[e] + q[lane]) * dilatation[lane] * mean.volume[lane];
        body.viscous_pressure[e] = q[lane];
        for (int a = 0; a < 8; ++a)
          body.corner_force[8 * e + a] = Vec3<T>(force(a, 0)[lane], force(a, 1)[lane], force(a, 2)[lane]);
      });
    });
  });
  const CornersOfNodes &list = body.corners_of_nodes;
  parallel_for(body.nodes.size(), [&](Index n) {
    Vec3<T> sum = Vec3<T>::Zero();
    for (Index k = list.begin[n]; k < list.begin[n + 1]; ++k) sum += body.corner_force[list.corners[k]];
    nodes.force[body.nodes.begin + n] += sum;
  });
}

} // namespace ogive
