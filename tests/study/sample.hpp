// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/parse.hpp"
#include "study/limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Cases and rows for the tests of studies: made up, and of shots that take a fraction of a second.

/// Names of options and their values.
using Pairs = std::vector<std::pair<std::string, std::string>>;

inline shot::Level level_of(const Pairs &pairs) {
  shot::Level level;
  for (const auto &[key, value] : pairs) level.given.push_back({key, key, value});
  return level;
}

inline shot::Options options_with(const Pairs &pairs) { return shot::settled({level_of(pairs)}); }

/// What shots that are run in these tests share: some hundred particles, 5 us.
inline const Pairs small_shot{{"spacing_mm", "2"},   {"sph_radius_mm", "15"}, {"clamp_radius_mm", "30"},
                              {"thickness_mm", "4"}, {"projectile", "rigid"}, {"end_us", "5"},
                              {"vtk", "false"}};

/// A shot that can be run, with further options.
inline study::Case small_case(double velocity_mps, const Pairs &more = {}) {
  const Pairs velocity{{"velocity_mps", ogive::shortest(velocity_mps)}};
  return study::case_of(shot::settled({level_of(small_shot), level_of(velocity), level_of(more)}), {}, "");
}

inline std::vector<study::Case> small_cases(const std::vector<double> &velocities) {
  std::vector<study::Case> cases;
  for (const double velocity : velocities) cases.push_back(small_case(velocity));
  return cases;
}

/// A result of a row as text.
inline std::string &result(study::Row &row, const std::string &column) {
  const auto &columns = study::result_columns();
  return row.results.at(static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin()));
}

inline study::Key key_at(double velocity_mps, const std::string &thickness_mm = "12") {
  return {{"paper", "mjc", "weldox_460e", "blunt", thickness_mm, ogive::shortest(velocity_mps), "0.6"}};
}

/// The row of a shot that nobody ran: it perforates above `limit_mps`, and its numbers need all their digits.
inline study::Row sample_row(const study::Key &key, double limit_mps = 200) {
  study::Row row{key, std::vector<std::string>(study::result_columns().size(), "0.30000000000000004")};
  const double v = study::number(key, study::velocity_column);
  const bool perforated = v > limit_mps;
  result(row, "residual_velocity_mps") =
      ogive::shortest(perforated ? 0.8 * std::sqrt(v * v - limit_mps * limit_mps) : 0);
  result(row, "perforated") = perforated ? "1" : "0";
  result(row, "momentum_error") = "5e-324", result(row, "steps") = "1000000000000002", result(row, "dishing_mm") = "-0";
  result(row, "state_hash") = "0123456789abcdef", result(row, "version") = "0.1.0";
  return row;
}

inline std::vector<double> velocities_of(const std::vector<study::Row> &rows) {
  std::vector<double> velocities;
  for (const study::Row &row : rows) velocities.push_back(study::number(row.key, study::velocity_column));
  return velocities;
}

inline std::vector<std::string> hashes_of(std::vector<study::Row> rows) {
  std::vector<std::string> hashes;
  for (study::Row &row : rows) hashes.push_back(result(row, "state_hash"));
  return hashes;
}

inline long lines_in(const std::string &text) { return std::count(text.begin(), text.end(), '\n'); }
