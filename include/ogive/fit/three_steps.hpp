// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/hardening_fit.hpp"
#include "ogive/fit/step_equations.hpp"

#include <optional>
#include <vector>

/// \file
/// The three steps of Liu et al. 2012, section 2.1: A, B, a from the quasi-static curve, then C from faster curves,
/// then b from hotter ones. Each step sees the whole law and solves for its own parameters only, so that the steps are
/// repeated until nothing changes.

namespace ogive {

namespace three_steps_detail {

inline std::string from_to(const Interval &i) {
  return std::isfinite(i.to) ? "between " + shortest(i.from) + " and " + shortest(i.to) : "from " + shortest(i.from);
}

/// Throws SetupError unless there are points for each parameter that is not given.
inline void require_points(const TestSeries &s, const std::vector<TestPoint> &points, const FlowChoice &choice) {
  const auto count = [&](auto gives) {
    return std::count_if(points.begin(), points.end(), [&](const TestPoint &p) { return gives(s, p); });
  };
  if (!choice.C)
    require(count(gives_rate) > 1, "points for C", count(gives_rate),
            "needs two or more of a curve at room temperature faster than " + shortest(quasi_static_ratio) + " times " +
                shortest(s.quasi_static_rate) + " 1/s with plastic strains " + from_to(s.settings.rate_window) +
                ", or a known value of C");
  if (!choice.b)
    require(count(gives_softening) > 1, "points for b", count(gives_softening),
            "needs two or more of a curve hotter than " + shortest(s.settings.room + room_tolerance) +
                " K that is not left out, with plastic strains " + from_to(s.settings.thermal_window) +
                ", or a known value of b");
}

inline std::vector<Hardening> hardening_step(const TestSeries &s, const std::vector<TestPoint> &points,
                                             const FlowFrame &f, double C, double b) {
  std::vector<Hardening> all;
  for (std::size_t h = 0; h < s.hardenings.size(); ++h) {
    std::vector<HardeningPoint> own;
    for (const auto &p : points)
      if (p.use == CurveUse::quasi_static && hardens(s, p, h))
        own.push_back({p.strain, p.stress, quasi_static_factor(f, C, b, p, s.quasi_static_rate)});
    const std::string &plate = s.hardenings[h];
    const bool named = !plate.empty() && plate != all_plates;
    all.push_back(fit_hardening(own, "quasi-static curve" + (named ? " of plate " + printable(plate) : "")));
  }
  return all;
}

inline double rate_step(const TestSeries &s, const std::vector<TestPoint> &points, const FlowFrame &f,
                        const std::vector<Hardening> &hardening, double b) {
  double xy = 0, xz = 0;
  for (const auto &p : points) {
    if (!gives_rate(s, p)) continue;
    const auto e = rate_equation(f, hardening[p.hardening], b, p, s.quasi_static_rate);
    xy += e.x * e.y, xz += e.x * e.z;
  }
  const double C = xy / xz;
  require(std::isfinite(C), "C", shortest(C),
          "must be finite; do the faster curves' rates differ from the reference rate and the quasi-static rate?");
  return C;
}

inline double thermal_step(const TestSeries &s, const std::vector<TestPoint> &points, const FlowFrame &f,
                           const std::vector<Hardening> &hardening, double C) {
  std::vector<SofteningPoint> softening;
  for (const auto &p : points)
    if (gives_softening(s, p))
      softening.push_back(softening_point(f, hardening[p.hardening], C, p, s.quasi_static_rate));
  const auto b = fit_thermal_exponent(softening);
  if (!b)
    throw SetupError("b: no value between 0.02 and 20 fits; the stress must fall from room temperature to the melting "
                     "temperature, are the hot curves weaker than the quasi-static one?");
  return *b;
}

inline double change(const StepParameters &p, const StepParameters &q) {
  double largest = std::max(std::abs(p.C - q.C), std::abs(p.b - q.b) / std::abs(q.b));
  for (std::size_t h = 0; h < p.hardening.size(); ++h) {
    const auto &u = p.hardening[h], &v = q.hardening[h];
    for (const double d : {(u.A - v.A) / v.A, (u.B - v.B) / v.B, (u.a - v.a) / v.a})
      largest = std::max(largest, std::abs(d));
  }
  return largest;
}

} // namespace three_steps_detail

/// The three steps, repeated until no parameter changes by more than 1e-10. Throws SetupError if a step lacks points or
/// finds no value.
inline StepParameters three_steps(const TestSeries &s, const std::vector<TestPoint> &points, const FlowChoice &choice) {
  using namespace three_steps_detail;
  require_points(s, points, choice);
  const FlowFrame &f = choice.frame;
  StepParameters now{{}, choice.C.value_or(0), choice.b.value_or(1)};
  constexpr int most_rounds = 200;
  for (int round = 0; round < most_rounds; ++round) {
    StepParameters next = now;
    next.hardening = hardening_step(s, points, f, now.C, now.b);
    if (!choice.C) next.C = rate_step(s, points, f, next.hardening, now.b);
    if (!choice.b) next.b = thermal_step(s, points, f, next.hardening, next.C);
    const bool settled = round > 0 && change(now, next) < 1e-10;
    now = std::move(next);
    if (settled) return now;
  }
  throw SetupError("calibration: the three steps do not converge in " + std::to_string(most_rounds) +
                   " rounds; isothermal curves or a known value of C or b would help");
}

} // namespace ogive
