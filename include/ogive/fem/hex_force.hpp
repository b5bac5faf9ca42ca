#pragma once

#include "ogive/fem/hex_body.hpp"
#include "ogive/material/stress_update.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// Nothing to prepare: hexes keep their neighbours.
template <class T, class Law, class Rule> void prepare(HexBody<T, Law, Rule> &, const Nodes<T> &) {}

/// Takes the rates from a removed hex, whose corners may be anywhere.
template <class T, class Law, class Rule> void stop_motion(HexBody<T, Law, Rule> &body, Index e) {
  for (int p = 0; p < Rule::points; ++p) body.points.velocity_gradient[e * Rule::points + p].setZero();
  if constexpr (Rule::points == 1) body.hourglass_motion[e].rate.setZero();
}

/// Velocity gradient at every material point with respect to the latest positions; keeps the gradients for the force.
template <class T, class Law, class Rule> void velocity_gradient(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes) {
  parallel_for(static_cast<Index>(body.hexes.size()), [&](Index e) {
    if (is_removed(body, e)) {
      stop_motion(body, e);
      return;
    }
    const Corners<T> x = gather_corners(nodes.position, body.hexes[e]);
    const Corners<T> v = gather_corners(nodes.velocity, body.hexes[e]);
    const HexModes<T> x_modes = modes<T>(x);
    const HexModes<T> v_modes = modes<T>(v);
    body.mean_gradient[e] = mean_gradient<T>(x_modes);
    const Mat3<T> L = mean_velocity_gradient<T>(body.mean_gradient[e], v_modes);
    if constexpr (Rule::points == 1) {
      body.points.velocity_gradient[e] = L;
      body.hourglass_motion[e] = hourglass_motion<T>(x_modes, v_modes, L);
    } else {
      for (int p = 0; p < Rule::points; ++p)
        body.points.velocity_gradient[e * Rule::points + p] =
            b_bar_velocity_gradient<T>(point_gradient<T>(x, p), L.trace(), v);
    }
  });
}

/// sum_a |b_a|^2 of a hex, 1/m2: 1.5/L^2 for a cube of edge L.
template <class T> T gradient_norm(const MeanGradient<T> &mean) {
  return T(8) * mean.integral.squaredNorm() / (mean.volume * mean.volume);
}

/// Length of a hex for its bulk viscosity, m: the edge of a cube, between one and sqrt(3) thicknesses of a flat hex.
template <class T> T viscous_length(T gradient_norm) { return std::sqrt(T(1.5) / gradient_norm); }

/// Pressure of bulk viscosity, Pa, where the hex is being compressed: rho l (c1 c |D| + c2 l D^2) with D = tr L (1/s).
template <class T> T bulk_viscosity(const HexOptions<T> &options, T density, T sound_speed, T length, T dilatation) {
  if (!(dilatation < T(0))) return T(0);
  return -density * length * dilatation *
         (options.linear_bulk_viscosity * sound_speed - options.quadratic_bulk_viscosity * length * dilatation);
}

/// Moves the generalised hourglass forces of hex e through the step `dt` (s) and returns those that act at its end, N.
/// They turn with the material and vanish when it fails; their work is added to the hex's hourglass energy.
template <class T, class Law>
HourglassModes<T> update_hourglass(HexBody<T, Law, OnePoint> &body, Index e, T gradient_norm, T dt) {
  const auto &options = body.options;
  if (!(options.hourglass_stiffness > T(0)) && !(options.hourglass_viscosity > T(0))) return HourglassModes<T>::Zero();
  const MeanGradient<T> &mean = body.mean_gradient[e];
  const HourglassModes<T> &rate = body.hourglass_motion[e].rate;
  const T modulus = p_wave_modulus(body.metal.elasticity);
  const Mat3<T> R = spin_rotation<T>(midstep_gradient<T>(body.points.velocity_gradient[e], dt), dt);
  const HourglassModes<T> turned = R * body.hourglass_force[e];
  if (is_failed(body, e))
    body.hourglass_force[e].setZero();
  else
    body.hourglass_force[e] = turned + dt * hourglass_force_rate<T>(mean, options.hourglass_stiffness * modulus, rate);
  const HourglassModes<T> viscous =
      hourglass_damping<T>(options.hourglass_viscosity, modulus, body.points.density[e], mean.volume, gradient_norm) *
      rate;
  body.hourglass_energy[e] += dt * (T(0.5) * (turned + body.hourglass_force[e]) + viscous).cwiseProduct(rate).sum();
  return body.hourglass_force[e] + viscous;
}

/// Corner forces of hex e from its stress and the viscous pressure q (Pa), N.
template <class T, class Law, class Rule>
Corners<T> stress_forces(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e, T gradient_norm, T q, T dt) {
  const MeanGradient<T> &mean = body.mean_gradient[e];
  if constexpr (Rule::points == 1) {
    Mat3<T> sigma = full(body.points.deviator[e]);
    sigma.diagonal().array() -= body.points.pressure[e] + q;
    HexModes<T> force = force_modes<T>(mean, sigma);
    add_hourglass_forces<T>(mean, body.hourglass_motion[e].shape, update_hourglass(body, e, gradient_norm, dt), force);
    return corner_values<T>(force);
  } else {
    if (is_removed(body, e)) return Corners<T>::Zero();
    const Corners<T> x = gather_corners(nodes.position, body.hexes[e]);
    Corners<T> force = Corners<T>::Zero();
    T pressure_volume = q * mean.volume;
    for (int p = 0; p < Rule::points; ++p) {
      const Index i = e * Rule::points + p;
      const PointGradient<T> point = point_gradient<T>(x, p);
      force += deviatoric_forces<T>(point, full(body.points.deviator[i]));
      pressure_volume += point.volume * body.points.pressure[i];
    }
    return force + (pressure_volume / mean.volume) * corner_integrals<T>(mean);
  }
}

/// Adds the forces of stress, bulk viscosity and hourglass control to the nodes, N, and their work over the step `dt`
/// (s) to the energies. Call it after `velocity_gradient` and `update_stress`.
template <class T, class Law, class Rule> void add_internal_force(HexBody<T, Law, Rule> &body, Nodes<T> &nodes, T dt) {
  const T c = sound_speed(body.metal);
  parallel_for(static_cast<Index>(body.hexes.size()), [&](Index e) {
    const Index i = e * Rule::points;
    const MeanGradient<T> &mean = body.mean_gradient[e];
    const T norm = gradient_norm<T>(mean);
    const T dilatation = body.points.velocity_gradient[i].trace();
    const T q = bulk_viscosity<T>(body.options, body.points.density[i], c, viscous_length<T>(norm), dilatation);
    body.viscous_energy[e] -= T(0.5) * dt * (body.viscous_pressure[e] + q) * dilatation * mean.volume;
    body.viscous_pressure[e] = q;
    const Corners<T> force = stress_forces(body, nodes, e, norm, q, dt);
    for (int a = 0; a < 8; ++a) body.corner_force[8 * e + a] = force.row(a).transpose();
  });
  const CornersOfNodes &list = body.corners_of_nodes;
  parallel_for(body.nodes.size(), [&](Index n) {
    Vec3<T> sum = Vec3<T>::Zero();
    for (Index k = list.begin[n]; k < list.begin[n + 1]; ++k) sum += body.corner_force[list.corners[k]];
    nodes.force[body.nodes.begin + n] += sum;
  });
}

} // namespace ogive
