// SPDX-License-Identifier: BSD-3-Clause
#include "timoshenko.hpp"

#include <array>
#include <cmath>

namespace verification {

namespace {

/// Deflection, rotation, bending moment and shear force, by width.
using State = std::array<double, 4>;

/// Where the clamped end's state leads to at the free end: Runge and Kutta's rule of fourth order.
State at_free_end(const BeamSection &beam, double omega, State y) {
  const double bending = beam.young * std::pow(beam.height, 3) / 12, shear = 5.0 / 6.0 * beam.shear * beam.height;
  const double mass = beam.density * beam.height * omega * omega, turning = mass * beam.height * beam.height / 12;
  const auto slope = [&](const State &s) {
    return State{s[1] + s[3] / shear, s[2] / bending, -s[3] - turning * s[1], -mass * s[0]};
  };
  const auto moved = [](const State &s, const State &k, double by) {
    State next;
    for (std::size_t i = 0; i < 4; ++i) next[i] = s[i] + by * k[i];
    return next;
  };
  constexpr int intervals = 400;
  const double dz = beam.length / intervals;
  for (int n = 0; n < intervals; ++n) {
    const State k1 = slope(y), k2 = slope(moved(y, k1, dz / 2)), k3 = slope(moved(y, k2, dz / 2)),
                k4 = slope(moved(y, k3, dz));
    for (std::size_t i = 0; i < 4; ++i) y[i] += dz / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

/// Vanishes at an eigenfrequency: then some moment and shear force at the clamp leave the other end free of both.
double free_end_determinant(const BeamSection &beam, double omega) {
  const State a = at_free_end(beam, omega, {0, 0, 1, 0}), b = at_free_end(beam, omega, {0, 0, 0, 1});
  return a[2] * b[3] - a[3] * b[2];
}

} // namespace

double timoshenko_frequency(const BeamSection &beam) {
  const double k = 1.875104 / beam.length;
  const double euler = k * k * beam.height * std::sqrt(beam.young / (12 * beam.density));
  double low = 0.5 * euler, high = 1.05 * euler;
  const bool sign = free_end_determinant(beam, low) > 0;
  for (int i = 0; i < 50; ++i) {
    const double omega = 0.5 * (low + high);
    ((free_end_determinant(beam, omega) > 0) == sign ? low : high) = omega;
  }
  return 0.5 * (low + high);
}

} // namespace verification
