// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/step_equations.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ogive {

/// A law fitted to tests, with its uncertainty. The order of `covariance` is A, B, a for each hardening, then C, b;
/// what was given has no error. The errors take the points' scatter as independent: that of specimens is not in them.
struct Calibration {
  FlowFrame frame;                     ///< form of the law and what was given
  std::vector<std::string> hardenings; ///< names of the plates, as in TestSeries
  std::vector<Hardening> quasi_static; ///< A0, B0, a: stress at the quasi-static rate and room temperature
  std::vector<Hardening> hardening;    ///< A, B, a of the law
  double C{}, b{};                     ///< rate and thermal exponent
  Eigen::MatrixXd covariance;          ///< Pa, Pa, 1, ..., 1, 1
};

/// Covariance of A, B, a of hardening `h`, C and b.
inline Eigen::MatrixXd covariance_of(const Calibration &c, std::size_t h) {
  const auto first = static_cast<Eigen::Index>(3 * h), last = c.covariance.rows();
  const std::vector<Eigen::Index> rows{first, first + 1, first + 2, last - 2, last - 1};
  return c.covariance(rows, rows);
}

/// Flow stress of the fitted law, Pa.
inline double flow_stress_value(const Calibration &c, std::size_t h, double strain, double rate, double temperature) {
  return flow_stress_value(c.frame, c.hardening[h], c.C, c.b, strain, rate, temperature);
}

/// Errors of a law against one curve.
struct CurveMisfit {
  int points = 0;     ///< of the curve
  double rms = 0;     ///< Pa
  double largest = 0; ///< law - test where it is largest in size, Pa
  double strain = 0;  ///< plastic, there
};

/// Errors of the law against a curve, along the temperature of the test.
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
/// Errors of the law against all points that are used.
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
