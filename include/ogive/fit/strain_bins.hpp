// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/fitted_law.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

/// \file
/// C and b against plastic strain (Liu et al. 2012, Fig. 1b and 1c).

namespace ogive {

/// Width of a bin of plastic strain.
inline constexpr double strain_bin_width = 0.01;

/// A parameter from the points of one bin alone.
struct StrainBin {
  double strain{};         ///< plastic, middle of the bin
  double value{};          ///< C or b
  double standard_error{}; ///< infinite for a single point
  int points = 0;          ///< in the bin
};

namespace strain_bins_detail {

/// Points by bin and key, in the order of both.
template <class Key, class Gives, class KeyOf>
std::map<std::pair<Key, long>, std::vector<TestPoint>> binned(const std::vector<TestPoint> &points, Gives &&gives,
                                                              KeyOf &&key) {
  std::map<std::pair<Key, long>, std::vector<TestPoint>> bins;
  for (const auto &p : points)
    // 0.03 is a little less than three bins in binary.
    if (gives(p)) bins[{key(p), std::lround(std::floor(p.strain / strain_bin_width + 1e-9))}].push_back(p);
  return bins;
}

/// Standard error of a value that makes the sum of scores vanish (White 1980).
inline double error_of(const std::vector<double> &scores, double slope) {
  double squares = 0;
  for (const double g : scores) squares += g * g;
  const auto n = static_cast<double>(scores.size());
  return n > 1 ? std::sqrt(squares * n / (n - 1)) / std::abs(slope) : INFINITY;
}

inline double middle(long bin) { return (static_cast<double>(bin) + 0.5) * strain_bin_width; }

} // namespace strain_bins_detail

/// C of each bin of plastic strain, from all faster curves.
inline std::vector<StrainBin> rate_bins(const TestSeries &s, const Calibration &c) {
  using namespace strain_bins_detail;
  std::vector<StrainBin> bins;
  const auto is_rate = [](const TestPoint &p) { return p.use == CurveUse::rate; };
  for (const auto &[key, points] : binned<int>(used_points(s), is_rate, [](const auto &) { return 0; })) {
    double xy = 0, xz = 0;
    std::vector<RateEquation> equations;
    for (const auto &p : points) {
      equations.push_back(rate_equation(c.frame, c.quasi_static[p.hardening], c.b, p, s.quasi_static_rate));
      xy += equations.back().x * equations.back().y, xz += equations.back().x * equations.back().z;
    }
    std::vector<double> scores;
    scores.reserve(equations.size());
    for (const auto &e : equations) scores.push_back(e.x * (e.y - xy / xz * e.z));
    bins.push_back({middle(key.second), xy / xz, error_of(scores, xz), static_cast<int>(points.size())});
  }
  return bins;
}

/// b of each bin of plastic strain: for each initial temperature alone, and under temperature 0 for all together. Bins
/// that no b between 0.02 and 20 fits are missing.
inline std::map<double, std::vector<StrainBin>> thermal_bins(const TestSeries &s, const Calibration &c) {
  using namespace strain_bins_detail;
  std::map<double, std::vector<StrainBin>> bins;
  const auto is_thermal = [](const TestPoint &p) { return p.use == CurveUse::thermal; };
  const auto add = [&](const auto &all) {
    for (const auto &[key, points] : all) {
      std::vector<SofteningPoint> softening;
      for (const auto &p : points)
        softening.push_back(softening_point(c.frame, c.quasi_static[p.hardening], c.C, p, s.quasi_static_rate));
      const auto b = fit_thermal_exponent(softening);
      if (!b) continue;
      std::vector<double> scores;
      double slope = 0;
      for (const auto &p : softening) {
        scores.push_back(softening_slope(p, *b));
        slope += (softening_slope(p, *b * (1 + 1e-6)) - softening_slope(p, *b * (1 - 1e-6))) / (2e-6 * *b);
      }
      bins[key.first].push_back({middle(key.second), *b, error_of(scores, slope), static_cast<int>(points.size())});
    }
  };
  const auto points = used_points(s);
  add(binned<double>(points, is_thermal, [](const auto &) { return 0.0; }));
  add(binned<double>(points, is_thermal, [&](const TestPoint &p) { return s.curves[p.curve].curve.temperature; }));
  return bins;
}

} // namespace ogive
