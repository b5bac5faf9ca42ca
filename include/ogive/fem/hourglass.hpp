// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex8.hpp"

#include <cmath>
#include <numbers>

/// \file
/// Hourglass control by stiffness and viscosity (Flanagan & Belytschko 1981, Int. J. Numer. Meth. Engng 17, 679-706).
///
/// The four hourglass vectors are h_alpha = eta zeta, zeta xi, xi eta, xi eta zeta at the corners, made orthogonal to
/// linear fields: gamma_alpha,a = h_alpha,a - b_a . X_alpha, X_alpha = sum_a h_alpha,a x_a. With the unit mode
/// gamma/sqrt(8), a mode's rate is q' = sum_a gamma_a v_a / sqrt(8). On a cube of edge L every mode has the stiffness
///   k = stiffness (lambda + 2 mu) V sum_a |b_a|^2 = 1.5 stiffness (lambda + 2 mu) L.
/// The true bending stiffness is E L/6, which at Poisson's ratio 0.33 is met by stiffness = 0.075; the default 0.1
/// is 1.33 times as stiff as bending.
///
/// sum |b|^2 of a flat hex is that of its thickness, and k would lock the bending of plates of flat hexes. Therefore
/// each direction of a mode gets the gradients that strain it, without the parasitic shear (as in Belytschko & Bindeman
/// 1993, Comput. Methods Appl. Mech. Engng 105, 225-260): the mode xi eta has
///   K = 3/8 stiffness (lambda + 2 mu) V [g_xi (x) g_xi + g_eta (x) g_eta + (|g_xi|^2 + |g_eta|^2)/2 n (x) n],
/// g_xi = grad xi, n the unit normal to both, and xi eta zeta the sum of g (x) g. Any brick then has 1.33 times the
/// true bending stiffness, a cube the k above.
///
/// The resistance yields with the metal: it is the stress that varies within the hex, and that stress flows as the mean
/// does. Two things follow from the flow rule of Prandtl and Reuss, without a constant of its own.
/// 1. Where the mean stress flows, stresses beside it are carried away: in a step in which the return map takes the
///    mean trial stress back by the factor r = sigma/(sigma + 3 G d(eps_p)), it takes the hourglass forces back by the
///    same r. At a steady rate they are those of a viscosity, Q = K q' sigma/(3 G eps_p'), the first-order variation of
///    the flow stress with the direction of flow.
/// 2. Where the mean does not flow, a hex that is bent yields at the plastic moment. The root mean square of the
///    equivalent stress of a beam's bending is h = sqrt(24) |Q|/(V |g|), and at the plastic moment, Q = sigma V |g|/(2
///    sqrt(8)), it is sqrt(3)/2 sigma. For all modes together h^2 = 24 |Q|^2/V^2 in the norm of the stored energy, and
///    h is at most sqrt(3)/2 times the flow stress.

namespace ogive {

/// A vector for each hourglass mode: column alpha.
template <class T> using HourglassModes = Eigen::Matrix<T, 3, 4>;

/// The input of hourglass control for one hex: X_alpha (m, times 8) and the rates q'_alpha (m/s).
template <class T> struct HourglassMotion {
  HourglassModes<T> shape; ///< X_alpha, m, times 8
  HourglassModes<T> rate;  ///< q'_alpha, m/s
};

/// Square root of eight, the length of a hourglass vector.
inline constexpr double root8 = 2 * std::numbers::sqrt2;

/// Hourglass shape and rates from the modes of positions and velocities and the mean velocity gradient L (1/s). The
/// rates vanish for every linear velocity field.
template <class T>
HourglassMotion<T> hourglass_motion(const HexModes<T> &position, const HexModes<T> &velocity, const Mat3<T> &L) {
  HourglassMotion<T> motion;
  motion.shape = T(8) * position.template bottomRows<4>().transpose();
  motion.rate =
      T(1 / root8) * (T(8) * velocity.template bottomRows<4>().transpose() - HourglassModes<T>(L * motion.shape));
  return motion;
}

/// K q' of the file's head for all modes, N/s: the rate of the generalised forces for the rates `rate` (m/s).
/// `modulus` is stiffness (lambda + 2 mu), Pa.
template <class T>
HourglassModes<T> hourglass_force_rate(const MeanGradient<T> &mean, T modulus, const HourglassModes<T> &rate) {
  const Mat3<T> g = T(T(8) / mean.volume) * mean.integral.template topRows<3>().transpose();
  const T scale = T(0.375) * modulus * mean.volume;
  const Vec3<T> squares = g.colwise().squaredNorm().transpose();
  const Eigen::Matrix<T, 3, 4> along = g.transpose() * rate; // g_i . q'_alpha
  HourglassModes<T> force;
  for (int m = 0; m < 3; ++m) {
    const int i = (m + 1) % 3, j = (m + 2) % 3;
    const Vec3<T> gi = g.col(i), gj = g.col(j), normal = cross<T>(gi, gj);
    const T shear = T(0.5) * (squares[i] + squares[j]) * normal.dot(rate.col(m)) / normal.squaredNorm();
    force.col(m) = scale * (along(i, m) * gi + along(j, m) * gj + shear * normal);
  }
  force.col(3) = scale * (g * along.col(3));
  return force;
}

/// Largest equivalent stress of hourglass forces over the flow stress: sqrt(3)/2, that of the plastic moment.
inline constexpr double hourglass_strength = 0.5 * std::numbers::sqrt3;

/// The square of the root mean square over the hex of the equivalent stress that the generalised hourglass forces Q (N)
/// are, Pa^2: 24 Q K^-1 Q/V^2 with K of hourglass_force_rate() for 3/8 modulus V = 1. `T` is a number or a pack.
template <class T> T hourglass_stress_squared(const MeanGradient<T> &mean, const HourglassModes<T> &Q) {
  const Mat3<T> g = T(T(8) / mean.volume) * mean.integral.template topRows<3>().transpose();
  const Mat3<T> dual = inverse<T>(g); // row k: 1 along g_k, 0 along the others
  const Eigen::Matrix<T, 3, 4> parts = dual * Q;
  T sum = parts.col(3).squaredNorm();
  for (int m = 0; m < 3; ++m) {
    const int i = (m + 1) % 3, j = (m + 2) % 3;
    const Vec3<T> gi = g.col(i), gj = g.col(j), normal = cross<T>(gi, gj);
    const T out_of_plane = normal.dot(Q.col(m)), along = out_of_plane / normal.squaredNorm();
    const T a = parts(i, m) - along * dual.row(i).dot(normal), b = parts(j, m) - along * dual.row(j).dot(normal);
    sum += a * a + b * b + out_of_plane * along / (T(0.5) * (gi.squaredNorm() + gj.squaredNorm()));
  }
  return T(24) * sum / (mean.volume * mean.volume);
}

/// Viscosity (N s/m) of a unit mode: viscosity sqrt((lambda + 2 mu) rho V^2 sum |b|^2 / 8), `viscosity` the fraction of
/// HexOptions, `p_wave_modulus` = lambda + 2 mu (Pa), `gradient_norm` = sum_a |b_a|^2 (1/m2).
/// `N` is T or a pack of T.
template <class T, class N> N hourglass_damping(T viscosity, T p_wave_modulus, N density, N volume, N gradient_norm) {
  using std::sqrt;
  return viscosity * volume * sqrt(T(0.125) * p_wave_modulus * density * gradient_norm);
}

/// Adds the generalised hourglass forces Q (N) to the coefficients of the corner forces:
/// f_a = -sum_alpha gamma_alpha,a Q_alpha / sqrt(8).
template <class T>
void add_hourglass_forces(const MeanGradient<T> &mean, const HourglassModes<T> &shape, const HourglassModes<T> &Q,
                          HexModes<T> &force) {
  const HourglassModes<T> unit = T(1 / root8) * Q;
  const Mat3<T> moment = (T(1) / mean.volume) * (unit * shape.transpose());
  force.template topRows<6>() += mean.integral * moment.transpose();
  force.template bottomRows<4>() -= unit.transpose();
}

} // namespace ogive
