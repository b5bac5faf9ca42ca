// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study.hpp"

#include "ogive/fit/ballistic_curve.hpp"
#include "ogive/perforation/limit_search.hpp"

/// \file
/// Ballistic limits: bisection on "perforated", and a curve through the residual velocities.

namespace study {

/// Published values of a limit, from tests and from the paper; empty where there are none.
struct Published {
  std::optional<double> test_limit_mps;
  std::optional<double> paper_velocity_mps; ///< the paper's strike velocity close to its own limit
  double a = 1;                             ///< of Recht and Ipson's curve through the measured limit
  double p = 2;
};

/// Shots that differ in their velocity alone, and so have one ballistic limit.
struct Series {
  shot::Options options; ///< of a shot; its velocity counts for nothing
  Key key;               ///< with an empty velocity
  double guess_mps = 0;  ///< velocity of the first shot
  Published published;
  std::optional<double> expected_mps{}; ///< the limit that a coarser series has
};

/// A series with its limits.
struct LimitRow {
  Key key; ///< with an empty velocity
  ogive::LimitBracket<double> bracket;
  std::optional<ogive::BallisticFit<double>> fit;
  Published published;
};

/// The key without its velocity.
Key series_key(Key key);

/// The first velocity of a search where no limit is known: the limits of the tests grow about so with the thickness.
double guess_mps(const shot::Options &options);

/// The series of a shot. The first velocity is the limit of the tests, or guess_mps() where there is none.
Series series_of(const Case &shot);

/// The series of all shots, each once.
std::vector<Series> series_in(const std::vector<Case> &shots);

/// The shot of a series at a velocity.
Case shot_of(const Series &series, double velocity_mps, const Texts &own_columns);

/// Published values of the limit of a case, from the tables of tests; empty for plates and projectiles other than those
/// of the tests. Throws SetupError for a damaged table.
Published find_published(const shot::Options &options);

/// The series with twice the particle distance, of which a shot costs a tenth; nothing if so few particles would lie
/// through a plate or across the projectile that it promised little.
std::optional<Series> coarser(const Series &series, const Texts &own_columns);

/// The series that expects a limit, of a coarser series or of another arrangement: its first two shots lie on both
/// sides of it.
Series guided_by(Series series, double limit_mps, double width_mps);

/// Those two shots; none where no limit is expected or a shot of the series is known.
std::vector<Case> first_pair(const Series &series, const std::vector<Row> &rows, double width_mps,
                             const Texts &own_columns);

/// The velocity of the next shot of a bisection to a bracket of `width_mps`; nothing once the bracket is that narrow.
/// The first ones lie beside the limit that is expected: that of a coarser series, or where that is contradicted that
/// of the curve through the residual velocities.
std::optional<double> next_velocity(const Series &series, const std::vector<Row> &rows, double width_mps);

/// The shot with twice the time that its undecided row has had, up to eight times the default; unchanged if its time is
/// not the default.
Case with_more_time(Case shot, const Row &row);

/// Bisects the limits of all series, those of different series at the same time. A series ends with a shot that fails
/// and is left out if its rows are of another case. Its shots that are there before count as known; one that the
/// default time has left undecided gets more, see with_more_time(). Series that differ in the arrangement of the
/// particles alone wait for the first of them and begin beside its limit, if it has one. Throws as run_cases().
Outcome find_limits(const Study &study, const std::vector<Series> &series, double width_mps, const Report &report);

/// The limits that rows give.
std::vector<LimitRow> limits_in(const std::vector<Series> &series, const std::vector<Row> &rows);

/// The limits as CSV, with a header.
std::string limits_csv(const std::vector<LimitRow> &limits, const Texts &own_columns);

/// One line for the terminal: bisection, fit, and the difference between them.
std::string described(const LimitRow &row, const Texts &own_columns);

} // namespace study
