// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/calibration.hpp"

#include <algorithm>
#include <vector>

/// \file
/// All parameters at once on all curves, so that no single test decides, with a loss that outliers do not bend.

namespace ogive {

/// Huber's constant: 95 % of the efficiency of least squares where the scatter is normal (Huber 1964).
inline constexpr double huber_constant = 1.345;

/// Weight of an error among errors of this scale: 1, and less beyond 1.345 scales (Huber 1964).
inline double huber_weight(double error, double scale) {
  const double limit = huber_constant * scale;
  return std::abs(error) <= limit ? 1 : limit / std::abs(error);
}

/// Standard deviation from the median of the absolute errors, as if they were normal.
inline double robust_scale(std::vector<double> errors) {
  for (double &e : errors) e = std::abs(e);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return 1.4826 * *middle;
}

namespace simultaneous_detail {

/// A point as one hardening sees it: quasi-static points count for their plate's and for the one of all plates.
struct Observation {
  std::size_t point, hardening;
  double mean_stress; ///< of the curve, Pa
  double share;       ///< 1/points of the curve, so that curves count alike
};

inline std::vector<Observation> observations(const TestSeries &s, const std::vector<TestPoint> &points) {
  std::vector<double> sum(s.curves.size()), count(s.curves.size());
  for (const auto &p : points) sum[p.curve] += p.stress, ++count[p.curve];
  std::vector<Observation> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &p = points[i];
    const double n = count[p.curve];
    all.push_back({i, p.hardening, sum[p.curve] / n, 1 / n});
    for (std::size_t h = 0; p.use == CurveUse::quasi_static && h < s.hardenings.size(); ++h)
      if (h != p.hardening && hardens(s, p, h)) all.push_back({i, h, sum[p.curve] / n, 1 / n});
  }
  return all;
}

} // namespace simultaneous_detail

/// Fits all parameters that are not given to all used curves: least squares of (law - test)/mean stress of the curve,
/// each curve with the same weight, points weighted anew by Huber's loss until nothing changes (Holland & Welsch 1977).
/// Starts from `start`. Throws SetupError if A, B or a come out not positive.
inline Calibration simultaneously_calibrated(const TestSeries &s, const FlowChoice &choice, const Calibration &start) {
  using namespace calibration_detail;
  const auto points = used_points(s);
  const auto all = simultaneous_detail::observations(s, points);
  const std::size_t hardenings = start.hardening.size();
  const auto error_of = [&](const StepParameters &p, const simultaneous_detail::Observation &o) {
    const TestPoint &q = points[o.point];
    const double model =
        flow_stress_value(choice.frame, p.hardening[o.hardening], p.C, p.b, q.strain, q.rate, q.temperature);
    return (model - q.stress) / o.mean_stress;
  };

  Eigen::VectorXd x = packed(choice, {start.hardening, start.C, start.b});
  const Eigen::VectorXd size = sizes(choice, x);
  double scale = 0;
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round) {
    const StepParameters now = unpacked(choice, hardenings, x);
    std::vector<double> errors;
    for (const auto &o : all) errors.push_back(error_of(now, o));
    // Noise-free curves leave round-off only.
    scale = std::max(robust_scale(errors), 1e-9);
    std::vector<double> weight;
    weight.reserve(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      weight.push_back(std::sqrt(huber_weight(errors[k], scale) * all[k].share));
    const auto residual = [&](const Eigen::VectorXd &y) {
      const StepParameters p = unpacked(choice, hardenings, y);
      Eigen::VectorXd r(static_cast<Eigen::Index>(all.size()));
      for (std::size_t k = 0; k < all.size(); ++k) r[static_cast<Eigen::Index>(k)] = weight[k] * error_of(p, all[k]);
      return r;
    };
    const Eigen::VectorXd next = least_squares(residual, x, size);
    const double change = (next - x).cwiseQuotient(size).cwiseAbs().maxCoeff();
    x = next;
    if (change < 1e-9) break;
  }

  const StepParameters p = unpacked(choice, hardenings, x);
  for (std::size_t h = 0; h < hardenings; ++h) {
    const auto &v = p.hardening[h];
    require(v.A > 0 && v.B > 0 && v.a > 0, "simultaneous fit: smallest of A (MPa), B (MPa) and a",
            shortest(std::min({v.A / 1e6, v.B / 1e6, v.a})), "must come out positive; the curves contradict the law");
  }
  Calibration c{choice.frame, s.hardenings, p.hardening, p.hardening, p.C, p.b, {}};
  const double factor = rate_factor(choice.frame, p.C, s.quasi_static_rate);
  for (auto &h : c.quasi_static) h.A *= factor, h.B *= factor;

  const auto scores = [&](const Eigen::VectorXd &y) {
    const StepParameters at = unpacked(choice, hardenings, y);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), y.size());
    for (const auto &o : all) {
      const double error = error_of(at, o);
      const auto one = [&](const Eigen::VectorXd &z) {
        return Eigen::VectorXd(Eigen::VectorXd::Constant(1, error_of(unpacked(choice, hardenings, z), o)));
      };
      rows.row(static_cast<Eigen::Index>(o.point)) +=
          o.share * huber_weight(error, scale) * error * central_differences(one, y, size);
    }
    return rows;
  };
  const auto law = [&](const Eigen::VectorXd &y) {
    return packed({choice.frame, {}, {}}, unpacked(choice, hardenings, y));
  };
  c.covariance = propagated(law, x, size, sandwich_covariance(scores, x, size));
  return c;
}

} // namespace ogive
