#pragma once

#include "ogive/fem/hex8.hpp"

/// \file
/// Hourglass control by stiffness and viscosity (Flanagan & Belytschko 1981, Int. J. Numer. Meth. Engng 17, 679-706).
///
/// The four hourglass vectors are h_alpha = eta zeta, zeta xi, xi eta, xi eta zeta at the corners, made orthogonal to
/// linear fields: gamma_alpha,a = h_alpha,a - b_a . X_alpha, X_alpha = sum_a h_alpha,a x_a. With the unit mode
/// gamma/sqrt(8), a mode's rate is q' = sum_a gamma_a v_a / sqrt(8) and its stiffness
///   k = stiffness (lambda + 2 mu) V sum_a |b_a|^2,
/// that is 1.5 stiffness (lambda + 2 mu) L for a cube of edge L. The true bending stiffness of that mode is E L/6, which
/// at Poisson's ratio 1/3 is met by stiffness = 0.074; the default 0.1 is 1.35 times as stiff as bending.

namespace ogive {

/// A vector for each hourglass mode: column alpha.
template <class T> using HourglassModes = Eigen::Matrix<T, 3, 4>;

/// What hourglass control knows of a hex: X_alpha (m, times 8) and the rates q'_alpha (m/s).
template <class T> struct HourglassMotion {
  HourglassModes<T> shape;
  HourglassModes<T> rate;
};

/// Hourglass shape and rates from the modes of positions and velocities and the mean velocity gradient L (1/s). The rates
/// vanish for every linear velocity field.
template <class T>
HourglassMotion<T> hourglass_motion(const HexModes<T> &position, const HexModes<T> &velocity, const Mat3<T> &L) {
  HourglassMotion<T> motion;
  motion.shape = T(8) * position.template bottomRows<4>().transpose();
  motion.rate = (T(8) * velocity.template bottomRows<4>().transpose() - L * motion.shape) / std::sqrt(T(8));
  return motion;
}

/// Generalised stiffness k (N/m) and viscosity c (N s/m) of a unit hourglass mode.
template <class T> struct HourglassResistance {
  T stiffness{};
  T viscosity{};
};

/// `stiffness` and `viscosity` are the fractions of HexOptions, `p_wave_modulus` is lambda + 2 mu (Pa),
/// `gradient_norm` = sum_a |b_a|^2 (1/m2). c = viscosity sqrt((lambda + 2 mu) rho V^2 sum |b|^2 / 8).
template <class T>
HourglassResistance<T> hourglass_resistance(T stiffness, T viscosity, T p_wave_modulus, T density, T volume,
                                            T gradient_norm) {
  HourglassResistance<T> r;
  r.stiffness = stiffness * p_wave_modulus * volume * gradient_norm;
  if (viscosity > T(0)) r.viscosity = viscosity * volume * std::sqrt(T(0.125) * p_wave_modulus * density * gradient_norm);
  return r;
}

/// Sum over the modes of h_alpha,a Q_alpha for each corner a.
template <class T> Corners<T> hourglass_pattern(const HourglassModes<T> &Q) {
  Corners<T> f;
  for (int i = 0; i < 3; ++i) {
    const T q0 = Q(i, 0), q1 = Q(i, 1), q2 = Q(i, 2), q3 = Q(i, 3);
    const T a = q0 + q1 + q2, b = q0 - q1 - q2, c = q2 - q0 - q1, d = q1 - q0 - q2;
    f(0, i) = a - q3, f(6, i) = a + q3;
    f(1, i) = b + q3, f(7, i) = b - q3;
    f(2, i) = c - q3, f(4, i) = c + q3;
    f(3, i) = d + q3, f(5, i) = d - q3;
  }
  return f;
}

/// The part of the hourglass forces that acts like a stress: -(1/V) sum_alpha Q_alpha (x) X_alpha / sqrt(8), Pa. It is
/// not symmetric. The corner forces of the generalised forces Q (N) are -V (this) b_a - pattern(Q)_a / sqrt(8).
template <class T>
Mat3<T> hourglass_stress(const HourglassModes<T> &Q, const HourglassModes<T> &shape, T volume) {
  return (T(-1) / (std::sqrt(T(8)) * volume)) * (Q * shape.transpose());
}

} // namespace ogive
