// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_shots.hpp"

#include "ogive/fit/ballistic_limit.hpp"
#include "ogive/perforation/limit_search.hpp"

#include <optional>
#include <vector>

/// \file
/// Ballistic limits: bisection on "perforated", and a curve through the residual velocities.

namespace figures {

/// Everything of a shot but its velocity: what has one ballistic limit.
struct SeriesKey {
  std::string method, model, material, nose;
  double thickness_mm = 0;
  double spacing_mm = 0;

  auto operator<=>(const SeriesKey &) const = default;
};

/// What the tests and the paper say about a series, where they do.
struct Published {
  std::optional<double> test_limit_mps;
  std::optional<double> paper_velocity_mps; ///< the paper's strike velocity close to its own limit
  double a = 1;                             ///< of Recht and Ipson's curve through the measured limit
  double p = 2;
  std::string test_source;
};

/// A series with its limits.
struct LimitRow {
  SeriesKey key;
  ogive::LimitBracket<double> bracket;
  std::optional<ogive::BallisticFit<double>> fit;
  Published published;
};

/// The series of a shot, and a shot of a series.
SeriesKey series_of(const ShotKey &key);
ShotKey shot_of(const SeriesKey &key, double velocity_mps);

/// What is published about a series, from the tables in `data`. Throws SetupError for a damaged table.
Published find_published(const SeriesKey &key, const std::filesystem::path &data);

/// The shots that the next round of bisection needs, to 5 m/s: at most one for each series. The first ones lie beside
/// the limit of the curve through the residual velocities.
std::vector<Task> next_round(const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
                             const std::filesystem::path &data);

/// The limits that the rows give.
std::vector<LimitRow> find_limits(const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
                                  const std::filesystem::path &data);

/// The limits as CSV, with a header.
std::string limits_csv(const std::vector<LimitRow> &limits);

/// One line for the terminal: bisection, fit, and how far they lie apart.
std::string described(const LimitRow &row);

} // namespace figures
