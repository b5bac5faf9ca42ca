// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/fit/stress_curve.hpp"
#include "ogive/io/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// \file
/// The tests of a metal, sorted by what each is used for.

namespace ogive {

/// An interval, ends included.
struct Interval {
  double from = 0;                                     ///< least value
  double to = std::numeric_limits<double>::infinity(); ///< greatest value
};
/// True if `x` lies in the interval.
inline bool holds(const Interval &interval, double x) { return x >= interval.from && x <= interval.to; }

/// Known data of the metal and of the tests, and the choices of the fit.
struct SeriesSettings {
  double room = 293;                   ///< Tr, K
  double melting{};                    ///< Tm, K
  double heat_per_work{};              ///< beta/(rho cp), K/Pa; 0: isothermal
  double adiabatic_above = 10;         ///< rate from which a test counts as adiabatic, 1/s
  Interval rate_window{0.05};          ///< plastic strain that C is taken from
  Interval thermal_window{0.03, 0.15}; ///< plastic strain that b is taken from
  std::optional<Interval> left_out;    ///< temperatures that b is not taken from, K (blue brittleness)
};

/// The use of a curve in the fit.
enum class CurveUse {
  quasi_static, ///< A, B, a
  rate,         ///< C
  thermal,      ///< b
  left_out      ///< nothing
};

/// Name of a use, as it is written in files.
inline const char *name(CurveUse use) {
  switch (use) {
  case CurveUse::quasi_static:
    return "hardening";
  case CurveUse::rate:
    return "rate";
  case CurveUse::thermal:
    return "temperature";
  default:
    return "left_out";
  }
}

/// Room temperature, as the thermal factor takes it: T*^b is steep there, so that a few K would count for much.
inline constexpr double room_tolerance = 10;
/// Rates this near to the lowest one count as quasi-static.
inline constexpr double quasi_static_ratio = 3;

/// A curve and what is made of it.
struct SortedCurve {
  StressCurve curve;                 ///< at room temperature where it is within the tolerance
  CurveUse use = CurveUse::left_out; ///< use in the fit
  bool adiabatic = false;            ///< the test kept its heat
  std::vector<double> temperature;   ///< K, at each point
  std::size_t hardening = 0;         ///< index in TestSeries::hardenings
};

/// All tests of a metal.
struct TestSeries {
  SeriesSettings settings;         ///< as given
  std::vector<SortedCurve> curves; ///< in the order of the tables
  /// Plates with a hardening curve of their own; last, if a plate has no quasi-static curve, `all_plates`.
  std::vector<std::string> hardenings;
  bool pooled = false;               ///< whether the last one is for all plates
  double quasi_static_rate{};        ///< 1/s, geometric mean over the quasi-static curves
  std::vector<std::string> messages; ///< one line each, for the user
};

/// Name of the hardening that plates without a quasi-static curve share.
inline constexpr const char *all_plates = "all plates";

/// "plate 25 mm, specimen 3, 1522 1/s, 293 K"
inline std::string description(const StressCurve &c) {
  std::string text = c.plate.empty() ? "" : "plate " + printable(c.plate) + ", ";
  if (!c.specimen.empty()) text += "specimen " + printable(c.specimen) + ", ";
  return text + shortest(c.rate) + " 1/s, " + shortest(c.temperature) + " K";
}

namespace series_detail {

inline CurveUse use_of(const StressCurve &c, const SeriesSettings &s, double lowest_rate) {
  if (c.temperature < s.room - room_tolerance) return CurveUse::left_out;
  if (c.temperature <= s.room + room_tolerance)
    return c.rate <= quasi_static_ratio * lowest_rate ? CurveUse::quasi_static : CurveUse::rate;
  return s.left_out && holds(*s.left_out, c.temperature) ? CurveUse::left_out : CurveUse::thermal;
}

/// The hardening that each curve follows.
inline void assign_hardenings(TestSeries &series) {
  auto &names = series.hardenings;
  for (const auto &c : series.curves)
    if (c.use == CurveUse::quasi_static && std::find(names.begin(), names.end(), c.curve.plate) == names.end())
      names.push_back(c.curve.plate);
  const std::size_t own = names.size();
  for (auto &c : series.curves) {
    const auto found = std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(own), c.curve.plate);
    // With one plate only, a curve without a name of its plate can come from no other.
    c.hardening = own == 1 ? 0 : static_cast<std::size_t>(found - names.begin());
    series.pooled = series.pooled || c.hardening == own;
  }
  if (series.pooled) names.emplace_back(all_plates);
}

inline void note_extrapolation(TestSeries &series) {
  for (const auto &c : series.curves) {
    if (c.use != CurveUse::rate && c.use != CurveUse::thermal) continue;
    double largest = 0;
    for (const auto &other : series.curves)
      if (other.use == CurveUse::quasi_static &&
          (other.hardening == c.hardening || series.hardenings[c.hardening] == all_plates))
        largest = std::max(largest, other.curve.strain.back());
    // A little further the power law is safe.
    if (c.curve.strain.back() > 1.2 * largest)
      series.messages.push_back(description(c.curve) + ": reaches plastic strain " + shortest(c.curve.strain.back()) +
                                ", its quasi-static curve only " + shortest(largest) +
                                "; beyond that the hardening is extrapolated");
  }
}

} // namespace series_detail

/// Sorts the curves: quasi-static (lowest rate at room temperature), faster ones, hotter ones; computes how warm each
/// gets. Throws SetupError if there is none at room temperature or if one would melt.
inline TestSeries sorted_series(std::vector<StressCurve> curves, const SeriesSettings &settings) {
  TestSeries series;
  series.settings = settings;
  const auto at_room = [&](const StressCurve &c) { return std::abs(c.temperature - settings.room) <= room_tolerance; };
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto &c : curves)
    if (at_room(c)) lowest = std::min(lowest, c.rate);
  require(std::isfinite(lowest), "curves within 10 K of room temperature", 0,
          "must be one or more: A, B and a are taken from the slowest of them; room temperature is " +
              shortest(settings.room) + " K");

  double log_rates = 0, quasi_static = 0;
  for (auto &c : curves) {
    SortedCurve sorted{std::move(c), CurveUse::left_out, false, {}, 0};
    auto &curve = sorted.curve;
    sorted.use = series_detail::use_of(curve, settings, lowest);
    if (curve.temperature < settings.room - room_tolerance)
      series.messages.push_back(description(curve) + ": left out, colder than room temperature");
    else if (sorted.use == CurveUse::left_out)
      series.messages.push_back(description(curve) + ": left out, in the temperature band that is left out");
    if (at_room(curve)) curve.temperature = settings.room;
    sorted.adiabatic = settings.heat_per_work > 0 && curve.rate >= settings.adiabatic_above;
    sorted.temperature = adiabatic_temperature(curve, curve.temperature, sorted.adiabatic ? settings.heat_per_work : 0);
    if (!sorted.temperature.empty())
      require(sorted.temperature.back() < settings.melting, description(curve) + ": temperature at its end (K)",
              shortest(sorted.temperature.back()),
              "must stay below the melting temperature; density, specific heat or the rate of adiabatic tests may be "
              "wrong");
    if (sorted.use == CurveUse::quasi_static) log_rates += std::log(curve.rate), ++quasi_static;
    series.curves.push_back(std::move(sorted));
  }
  series.quasi_static_rate = quasi_static == 1 ? lowest : std::exp(log_rates / quasi_static);
  series_detail::assign_hardenings(series);
  series_detail::note_extrapolation(series);
  return series;
}

/// A point of a curve, with all that a law needs to give its stress.
struct TestPoint {
  double strain{}, stress{}, rate{}, temperature{}; ///< plastic; Pa; 1/s; K
  std::size_t hardening = 0;                        ///< index in TestSeries::hardenings
  std::size_t curve = 0;                            ///< index in TestSeries::curves
  CurveUse use = CurveUse::left_out;                ///< use in the fit
};

/// The points of all curves that are used, in the order of the curves.
inline std::vector<TestPoint> used_points(const TestSeries &series) {
  std::vector<TestPoint> points;
  for (std::size_t k = 0; k < series.curves.size(); ++k) {
    const auto &c = series.curves[k];
    if (c.use == CurveUse::left_out) continue;
    for (std::size_t i = 0; i < c.curve.strain.size(); ++i)
      points.push_back({c.curve.strain[i], c.curve.stress[i], c.curve.rate, c.temperature[i], c.hardening, k, c.use});
  }
  return points;
}

/// Whether the point belongs to the curves that hardening `h` is fitted to: those of its plate, or all.
inline bool hardens(const TestSeries &series, const TestPoint &p, std::size_t h) {
  return p.hardening == h || (series.pooled && h + 1 == series.hardenings.size());
}

} // namespace ogive
