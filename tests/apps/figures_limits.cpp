// SPDX-License-Identifier: BSD-3-Clause
#include "figures/limits.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cmath>

using namespace figures;

namespace {

const std::filesystem::path data = FIGURES_DATA_FOLDER;

const SeriesKey steel_12mm{"sfm", "mjc", "weldox_460e", "blunt", 12, 0.6};

/// A computed shot of a series with this limit.
ShotRow shot(const SeriesKey &series, double velocity, double limit) {
  ShotRow row;
  row.key = shot_of(series, velocity);
  row.perforated = velocity > limit;
  row.residual_velocity_mps = row.perforated != 0 ? 0.8 * std::sqrt(velocity * velocity - limit * limit) : 0;
  return row;
}

std::size_t columns_of(const std::string &line) {
  return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
}

} // namespace

TEST_CASE("What is published of a series comes from the right rows") {
  const auto blunt = find_published(steel_12mm, data);
  CHECK(blunt.test_limit_mps == 184.5);
  CHECK(blunt.a == 0.76);
  CHECK(blunt.p == 2.36);
  CHECK(blunt.paper_velocity_mps == 195);
  CHECK(blunt.test_source.find("2002, IJIE 27:19") != std::string::npos);

  // No curve is published of this one: Recht and Ipson's with the plug's mass.
  const auto thin = find_published({"sfm", "jc", "weldox_460e", "blunt", 6, 1.5}, data);
  CHECK(thin.test_limit_mps == 145.5);
  CHECK(thin.a == Approx(197 / (197 + 7.85 * 0.31416 * 6)).epsilon(1e-4));
  CHECK(thin.p == 2);
  CHECK(thin.paper_velocity_mps == 110);

  const auto ogival = find_published({"sfm", "mjc", "weldox_460e", "ogival", 12, 0.6}, data);
  CHECK(ogival.test_limit_mps == 295.9);
  CHECK(ogival.a == 1);
  CHECK_FALSE(ogival.paper_velocity_mps.has_value());

  // Its material has a name of its own.
  const auto aluminium = find_published({"sfm", "mjc", "aa5083_h116_25mm", "conical", 25, 0.6}, data);
  CHECK(aluminium.test_limit_mps == 256.6);
  CHECK(aluminium.a == 1);
  CHECK(aluminium.p == 2);
  CHECK(find_published({"sfm", "mjc", "aa5083_h116", "conical", 15, 0.6}, data).test_limit_mps == 216.8);
  CHECK_FALSE(find_published({"sfm", "mjc", "weldox_460e", "conical", 15, 0.6}, data).test_limit_mps.has_value());
  CHECK_FALSE(find_published({"sfm", "mjc", "weldox_460e", "blunt", 13, 0.6}, data).test_limit_mps.has_value());
}

TEST_CASE("Rounds of bisection end with a bracket of 5 m/s, at most one shot of a series in each") {
  std::vector<SeriesKey> series;
  std::vector<double> limits{171.3, 184.5, 2, 40, 320, 1500};
  for (std::size_t k = 0; k < limits.size(); ++k) {
    series.push_back(steel_12mm);
    series.back().thickness_mm = 10 + static_cast<double>(k);
  }
  const auto limit_of = [&](const SeriesKey &key) { return limits[static_cast<std::size_t>(key.thickness_mm) - 10]; };
  std::vector<ShotRow> rows;
  for (const SeriesKey &key : series)
    for (const double v : {200, 250, 300, 400}) rows.push_back(shot(key, v, limit_of(key)));

  int rounds = 0;
  for (auto round = next_round(series, rows, data); !round.empty(); round = next_round(series, rows, data)) {
    REQUIRE(++rounds < 120);
    REQUIRE(round.size() <= series.size());
    for (const Task &task : round) {
      REQUIRE(find_row(rows, task.key) == nullptr);
      CHECK(task.frames_us == 0);
      rows.push_back(shot(series_of(task.key), task.key.initial_velocity_mps, limit_of(series_of(task.key))));
    }
  }
  for (const LimitRow &row : find_limits(series, rows, data)) {
    const auto estimate = ogive::limit_estimate(row.bracket);
    REQUIRE(estimate.has_value());
    CHECK(estimate->half_width <= 2.5);
    CHECK(std::abs(estimate->limit - limit_of(row.key)) <= estimate->half_width);
  }
}

TEST_CASE("The first velocities of a bisection") {
  const auto next = [&](const std::vector<ShotRow> &rows) {
    const auto round = next_round({steel_12mm}, rows, data);
    return round.empty() ? 0 : round.at(0).key.initial_velocity_mps;
  };
  // The measured limit, or 200 m/s where none is known.
  CHECK(next({}) == 184.5);
  SeriesKey unknown = steel_12mm;
  unknown.nose = "hemispherical";
  CHECK(next_round({unknown}, {}, data).at(0).key == shot_of(unknown, 200));

  // Half a bracket below the limit of the curve, 150 m/s.
  std::vector<ShotRow> rows;
  for (const double v : {200.0, 244.2, 303.5, 399.6}) rows.push_back(shot(steel_12mm, v, 150));
  CHECK(next(rows) == 147);
  // Shots of other series say nothing.
  SeriesKey other = steel_12mm;
  other.spacing_mm = 1.5;
  rows.push_back(shot(other, 170, 180));
  CHECK(next(rows) == 147);
  rows.push_back(shot(steel_12mm, 180, 190));
  CHECK(next(rows) == 190);
  rows.push_back(shot(steel_12mm, 185, 180));
  CHECK(next(rows) == 0);

  // Shots on a straight line, which would end at 100 m/s: 6 % below the slowest.
  rows.clear();
  for (const double v : {300.0, 320.0, 340.0, 360.0, 380.0, 400.0}) {
    rows.push_back(shot(steel_12mm, v, 100));
    rows.back().residual_velocity_mps = v - 100;
  }
  CHECK(next(rows) == 282);
}

TEST_CASE("Limits tell how far bisection and fit lie apart, and of shots that contradict each other") {
  std::vector<ShotRow> rows;
  for (const double v : {181.0, 185.0, 200.0, 250.0, 300.0, 350.0}) rows.push_back(shot(steel_12mm, v, 182));
  SeriesKey without = steel_12mm;
  without.nose = "ogival";
  auto limits = find_limits({steel_12mm, without}, rows, data);
  REQUIRE(limits.size() == 1); // no shots of the other
  CHECK(limits[0].fit->curve.limit == Approx(182).margin(0.1));
  CHECK(described(limits[0]) == "mjc, weldox_460e, blunt, 12 mm: limit 183.0 +- 2.0 m/s by bisection; fit to 5 shots: "
                                "182.0 +- 0.0 m/s, a 0.80, p 2.00, -1.0 m/s from the bisection; test 184.5 m/s");

  rows.push_back(shot(steel_12mm, 260, 270));
  limits = find_limits({steel_12mm}, rows, data);
  CHECK_FALSE(limits[0].bracket.consistent);
  CHECK(described(limits[0]).ends_with("; a shot stopped above one that perforated"));

  limits = find_limits({without}, {shot(without, 300, 310)}, data);
  REQUIRE(limits.size() == 1);
  CHECK_FALSE(limits[0].fit.has_value());
  CHECK(described(limits[0]) == "mjc, weldox_460e, ogival, 12 mm: no limit by bisection yet; test 295.9 m/s");
}

TEST_CASE("The table of limits has all its columns, whatever is known") {
  std::vector<ShotRow> rows{shot(steel_12mm, 180, 190), shot(steel_12mm, 303.5, 182)};
  SeriesKey stopped = steel_12mm, no_test = steel_12mm;
  stopped.model = "jc", no_test.thickness_mm = 13;
  rows.push_back(shot(stopped, 180, 190));
  rows.push_back(shot(no_test, 300, 190));
  const std::string csv = limits_csv(find_limits({steel_12mm, stopped, no_test}, rows, data));
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = 0; (end = csv.find('\n', at)) != std::string::npos; at = end + 1)
    lines.push_back(csv.substr(at, end - at));
  REQUIRE(lines.size() == 4);
  for (const auto &line : lines) CHECK(columns_of(line) == columns_of(lines[0]));
  CHECK(lines[1].starts_with("sfm,mjc,weldox_460e,blunt,12,0.6,180,303.5,241.75,1,"));
  CHECK(lines[1].ends_with(",184.5,195"));
  CHECK(lines[2] == "sfm,jc,weldox_460e,blunt,12,0.6,180,,,1,,,,,,,,,,,184.5,195");
  CHECK(lines[3].starts_with("sfm,mjc,weldox_460e,blunt,13,0.6,,300,,1,"));
  CHECK(lines[3].ends_with(",,"));
}
