// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/calibration.hpp"

#include <cmath>

namespace ogive {

/// How far a law is from one curve.
struct CurveMisfit {
  int points = 0;     ///< of the curve
  double rms = 0;     ///< Pa
  double largest = 0; ///< law - test where it is largest in size, Pa
  double strain = 0;  ///< plastic, there
};

/// How far the law is from a curve, along the temperature of the test.
inline CurveMisfit misfit(const SortedCurve &s, const Calibration &c) {
  CurveMisfit m;
  double squares = 0;
  for (std::size_t i = 0; i < s.curve.strain.size(); ++i, ++m.points) {
    const double error =
        flow_stress_value(c, s.hardening, s.curve.strain[i], s.curve.rate, s.temperature[i]) - s.curve.stress[i];
    squares += error * error;
    if (std::abs(error) > std::abs(m.largest)) m.largest = error, m.strain = s.curve.strain[i];
  }
  m.rms = std::sqrt(squares / m.points);
  return m;
}

/// Root mean square over all points of the curves that are not left out.
struct Misfit {
  double rms = 0;      ///< Pa
  double relative = 0; ///< of the measured stress
};
/// How far the law is from all points that are used.
inline Misfit misfit(const TestSeries &s, const Calibration &c) {
  double squares = 0, relative = 0;
  const auto points = used_points(s);
  for (const auto &p : points) {
    const double error = flow_stress_value(c, p.hardening, p.strain, p.rate, p.temperature) - p.stress;
    squares += error * error;
    relative += error * error / (p.stress * p.stress);
  }
  const auto n = static_cast<double>(points.size());
  return {std::sqrt(squares / n), std::sqrt(relative / n)};
}

} // namespace ogive
