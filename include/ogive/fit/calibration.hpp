// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/fitted_law.hpp"
#include "ogive/fit/least_squares.hpp"
#include "ogive/fit/three_steps.hpp"

#include <cmath>

namespace ogive {

namespace calibration_detail {

/// The parameters that are not given, in a row: A, B, a for each hardening, then C, then b.
inline Eigen::VectorXd packed(const FlowChoice &choice, const StepParameters &p) {
  std::vector<double> x;
  for (const auto &h : p.hardening) x.insert(x.end(), {h.A, h.B, h.a});
  if (!choice.C) x.push_back(p.C);
  if (!choice.b) x.push_back(p.b);
  return Eigen::Map<Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

inline StepParameters unpacked(const FlowChoice &choice, std::size_t hardenings, const Eigen::VectorXd &x) {
  StepParameters p;
  Eigen::Index k = 0;
  for (std::size_t h = 0; h < hardenings; ++h, k += 3) p.hardening.push_back({x[k], x[k + 1], x[k + 2]});
  p.C = choice.C ? *choice.C : x[k++];
  p.b = choice.b ? *choice.b : x[k];
  return p;
}

/// The size of each packed parameter, for differences. C may vanish.
inline Eigen::VectorXd sizes(const FlowChoice &choice, const Eigen::VectorXd &x) {
  Eigen::VectorXd size = x.cwiseAbs();
  if (!choice.C) {
    const Eigen::Index k = x.size() - (choice.b ? 1 : 2);
    size[k] = std::max(size[k], 0.01);
  }
  return size;
}

/// Row of a point: its part of the normal equations of the three steps.
inline void add_step_scores(const TestSeries &s, const FlowChoice &choice, const StepParameters &p, const TestPoint &q,
                            Eigen::Ref<Eigen::RowVectorXd> row) {
  const FlowFrame &f = choice.frame;
  const double rate0 = s.quasi_static_rate;
  const auto C_at = static_cast<Eigen::Index>(3 * p.hardening.size()), b_at = C_at + (choice.C ? 0 : 1);
  if (q.use == CurveUse::quasi_static)
    for (std::size_t h = 0; h < p.hardening.size(); ++h) {
      if (!hardens(s, q, h)) continue;
      const auto &law = p.hardening[h];
      const double factor = quasi_static_factor(f, p.C, p.b, q, rate0);
      const double grown = q.strain > 0 ? std::pow(q.strain, law.a) : 0;
      const double error = factor * (q.stress - factor * (law.A + law.B * grown));
      const auto at = static_cast<Eigen::Index>(3 * h);
      row[at] += error;
      row[at + 1] += error * grown;
      row[at + 2] += q.strain > 0 ? error * law.B * grown * std::log(q.strain) : 0;
    }
  if (!choice.C && gives_rate(s, q)) {
    const auto e = rate_equation(f, p.hardening[q.hardening], p.b, q, rate0);
    row[C_at] += e.x * (e.y - p.C * e.z);
  }
  if (!choice.b && gives_softening(s, q))
    row[b_at] += softening_slope(softening_point(f, p.hardening[q.hardening], p.C, q, rate0), p.b);
}

/// Calls `add(point, row)` for each point and returns the rows.
template <class Add> Eigen::MatrixXd score_rows(const std::vector<TestPoint> &points, Eigen::Index columns, Add &&add) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(points.size()), columns);
  Eigen::RowVectorXd row(columns);
  for (std::size_t i = 0; i < points.size(); ++i) {
    row.setZero();
    add(points[i], row);
    rows.row(static_cast<Eigen::Index>(i)) = row;
  }
  return rows;
}

/// The law's hardening from that of the quasi-static curve.
inline std::vector<Hardening> law_hardening(const FlowFrame &f, const StepParameters &p, double quasi_static_rate) {
  const double factor = rate_factor(f, p.C, quasi_static_rate);
  std::vector<Hardening> all = p.hardening;
  for (auto &h : all) h.A /= factor, h.B /= factor;
  return all;
}

/// A, B, a for each hardening, C, b of the law, from packed step parameters.
inline Eigen::VectorXd law_vector(const FlowChoice &choice, std::size_t hardenings, double quasi_static_rate,
                                  const Eigen::VectorXd &x) {
  StepParameters p = unpacked(choice, hardenings, x);
  p.hardening = law_hardening(choice.frame, p, quasi_static_rate);
  return packed({choice.frame, {}, {}}, p);
}

} // namespace calibration_detail

/// The three steps with the covariance that their stacked normal equations give: errors of A, B, a reach C and b.
/// Throws SetupError as three_steps() does.
inline Calibration calibrated(const TestSeries &s, const FlowChoice &choice) {
  using namespace calibration_detail;
  const auto points = used_points(s);
  const StepParameters steps = three_steps(s, points, choice);
  const std::size_t hardenings = steps.hardening.size();
  Calibration c{choice.frame, s.hardenings, steps.hardening, {}, steps.C, steps.b, {}};
  c.hardening = law_hardening(choice.frame, steps, s.quasi_static_rate);

  const Eigen::VectorXd x = packed(choice, steps), size = sizes(choice, x);
  const auto scores = [&](const Eigen::VectorXd &y) {
    const StepParameters p = unpacked(choice, hardenings, y);
    return score_rows(points, y.size(),
                      [&](const TestPoint &q, Eigen::RowVectorXd &row) { add_step_scores(s, choice, p, q, row); });
  };
  const auto law = [&](const Eigen::VectorXd &y) { return law_vector(choice, hardenings, s.quasi_static_rate, y); };
  c.covariance = propagated(law, x, size, sandwich_covariance(scores, x, size));
  return c;
}

} // namespace ogive
