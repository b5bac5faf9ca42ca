// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/fit/johnson_cook_form.hpp"
#include "ogive/fit/least_squares.hpp"
#include "ogive/io/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ogive {

/// A stress to be fitted by factor * (A + B strain^a).
struct HardeningPoint {
  double strain{};   ///< plastic
  double stress{};   ///< Pa
  double factor = 1; ///< the law's factors besides hardening
};

namespace hardening_detail {

/// The best A and B for a given exponent, by their normal equations, and the sum of squares.
inline std::pair<Hardening, double> with_exponent(const std::vector<HardeningPoint> &points, double a) {
  double s00 = 0, s01 = 0, s11 = 0, t0 = 0, t1 = 0;
  for (const auto &p : points) {
    const double u = p.factor, v = p.factor * std::pow(p.strain, a);
    s00 += u * u, s01 += u * v, s11 += v * v, t0 += u * p.stress, t1 += v * p.stress;
  }
  const double determinant = s00 * s11 - s01 * s01;
  const Hardening h{(s11 * t0 - s01 * t1) / determinant, (s00 * t1 - s01 * t0) / determinant, a};
  double squares = 0;
  for (const auto &p : points) {
    const double error = p.stress - p.factor * (h.A + h.B * std::pow(p.strain, a));
    squares += error * error;
  }
  return {h, std::isfinite(squares) ? squares : std::numeric_limits<double>::infinity()};
}

} // namespace hardening_detail

/// Least squares of factor * (A + B strain^a), Pa. Starts from the best of a row of exponents between 0.01 and 2, for
/// each of which A and B follow from linear equations (variable projection, Golub & Pereyra 1973). Throws SetupError
/// for fewer than four points and for an A, B or a that is not positive; `name` is that of the curve.
inline Hardening fit_hardening(const std::vector<HardeningPoint> &points, const std::string &name) {
  require(points.size() > 3, name + ": points", points.size(), "must be four or more to give A, B and a");
  constexpr int steps = 60;
  Hardening start;
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= steps; ++k) {
    const auto [h, squares] = hardening_detail::with_exponent(points, 0.01 * std::pow(200.0, double(k) / steps));
    if (squares < smallest) smallest = squares, start = h;
  }
  const double largest = std::max_element(points.begin(), points.end(), [](const auto &p, const auto &q) {
                           return p.stress < q.stress;
                         })->stress;
  const auto residual = [&](const Eigen::VectorXd &x) {
    Eigen::VectorXd r(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto &p = points[i];
      const double grown = p.strain > 0 ? std::pow(p.strain, x[2]) : 0;
      r[static_cast<Eigen::Index>(i)] = (p.factor * (x[0] + x[1] * grown) - p.stress) / largest;
    }
    return r;
  };
  const auto x =
      least_squares(residual, Eigen::VectorXd{{start.A, start.B, start.a}}, Eigen::VectorXd{{largest, largest, 1}});
  const auto positive = [&](double value, const std::string &thing) {
    require(std::isfinite(value) && value > 0, name + ": " + thing, shortest(value),
            "least squares must give a positive one; is the curve one of true stress against plastic strain that "
            "hardens from its first point on?");
  };
  positive(x[0] / 1e6, "A (MPa)");
  positive(x[1] / 1e6, "B (MPa)");
  positive(x[2], "a");
  return {x[0], x[1], x[2]};
}

} // namespace ogive
