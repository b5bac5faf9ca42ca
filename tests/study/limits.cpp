// SPDX-License-Identifier: BSD-3-Clause
#include "study/limits.hpp"
#include "sample.hpp"

#include "catch.hpp"

#include <sstream>

using namespace study;

namespace {

constexpr double width_mps = 5;

/// A series of 12 mm Weldox 460 E, or what else is given.
Series series_with(const Pairs &pairs) { return series_of(case_of(options_with(pairs), {}, "")); }

/// The row of a shot of a series with this limit.
Row row_at(const Series &series, double velocity_mps, double limit_mps) {
  return sample_row(shot_of(series, velocity_mps, {}).key, limit_mps);
}

Published published(const Pairs &pairs) { return find_published(options_with(pairs)); }

std::ptrdiff_t commas_in(const std::string &line) { return std::count(line.begin(), line.end(), ','); }

} // namespace

TEST_CASE("What is published of a limit comes from the right rows") {
  const auto blunt = published({});
  CHECK(blunt.test_limit_mps == 184.5);
  CHECK(blunt.a == 0.76);
  CHECK(blunt.p == 2.36);
  CHECK(blunt.paper_velocity_mps == 195);

  // No curve is published of this one: Recht and Ipson's with the plug's mass.
  const auto thin = published({{"model", "jc"}, {"thickness_mm", "6"}, {"spacing_mm", "1.5"}});
  CHECK(thin.test_limit_mps == 145.5);
  CHECK(thin.a == Approx(197 / (197 + 7.85 * 0.31416 * 6)).epsilon(1e-4));
  CHECK(thin.p == 2);
  CHECK(thin.paper_velocity_mps == 110);

  const auto ogival = published({{"nose", "ogival"}});
  CHECK(ogival.test_limit_mps == 295.9);
  CHECK(ogival.a == 1);
  CHECK_FALSE(ogival.paper_velocity_mps.has_value());

  // The plate of 25 mm has a name of its own.
  const auto aluminium = published({{"material", "aa5083_h116_25mm"}, {"nose", "conical"}, {"thickness_mm", "25"}});
  CHECK(aluminium.test_limit_mps == 256.6);
  CHECK(aluminium.a == 1);
  CHECK(aluminium.p == 2);
  CHECK(published({{"material", "aa5083_h116"}, {"nose", "conical"}, {"thickness_mm", "15"}}).test_limit_mps == 216.8);
}

TEST_CASE("A search begins beside the limit that twice the particle distance has") {
  const Series series = series_with({});
  const auto coarse = coarser(series, {});
  REQUIRE(coarse);
  CHECK(coarse->options.spacing_mm == 1.2);
  CHECK(coarse->key != series.key);
  CHECK_FALSE(coarser(series_with({{"spacing_mm", "1.5"}}), {}).has_value()); // four distances through the plate
  CHECK_FALSE(coarser(series_with({{"layers_mm", "2,10"}}), {}).has_value()); // through each plate
  CHECK_FALSE(coarser(series_with({{"diameter_mm", "6"}, {"sph_radius_mm", "12"}}), {}).has_value()); // eight across

  const std::vector<Row> rows{row_at(*coarse, 170, 172.2), row_at(*coarse, 175, 172.2)};
  const Series guided = guided_by(series, 172.5, width_mps);
  CHECK(guided.expected_mps == 172.5);
  const auto pair = first_pair(guided, rows, width_mps, {});
  REQUIRE(pair.size() == 2);
  CHECK(pair[0].options.velocity_mps == 170);
  CHECK(pair[1].options.velocity_mps == 175);
  CHECK(pair[0].options.spacing_mm == 0.6);
  // Rightly expected, the pair is all; else the search continues.
  for (const double limit : {172.2, 165.0}) {
    std::vector<Row> all = rows;
    for (const Case &shot : pair) all.push_back(row_at(series, shot.options.velocity_mps, limit));
    CHECK(first_pair(guided, all, width_mps, {}).empty());
    CHECK(next_velocity(guided, all, width_mps).has_value() == (limit == 165.0));
  }
}

TEST_CASE("A shot that the default time leaves undecided gets more, a shot with a time of its own does not") {
  const Case shot = shot_of(series_with({}), 200, {});
  Row row = row_at(series_with({}), 200, 190);
  const auto &columns = result_columns();
  const auto set = [&](const char *column, const std::string &text) {
    row.results[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin())] = text;
  };
  set("perforated", ""), set("residual_velocity_mps", "");
  const double usual_us = shot.options.end_us;
  for (const auto &[had, next] : {std::pair{1.0, 2.0}, {2.0, 4.0}, {3.9, 4.0}, {4.0, 8.0}, {8.0, 8.0}}) {
    set("simulated_us", ogive::shortest(had * usual_us));
    CHECK(with_more_time(shot, row).options.end_us == next * usual_us);
  }
  Case own = shot;
  own.options.end_us = 0.5 * usual_us;
  CHECK(with_more_time(own, row).options.end_us == own.options.end_us);
}

TEST_CASE("Nothing is published of plates and projectiles that were not tested") {
  for (const Pairs &other : std::vector<Pairs>{{{"nose", "conical"}, {"thickness_mm", "15"}},
                                               {{"thickness_mm", "13"}},
                                               {{"layers_mm", "6,6"}},
                                               {{"diameter_mm", "12"}},
                                               {{"mass_g", "150"}},
                                               {{"obliquity_deg", "20"}, {"extent", "half"}},
                                               {{"nose", "ogival"}, {"nose_length_mm", "20"}}}) {
    CAPTURE(other.front().first);
    CHECK_FALSE(published(other).test_limit_mps.has_value());
  }
  // The metal of a file, whatever its name.
  shot::Options own = options_with({{"material", "aa5083_h116"}, {"nose", "conical"}, {"thickness_mm", "15"}});
  own.material = "weldox_460e.toml";
  CHECK_FALSE(find_published(own).test_limit_mps.has_value());
}

TEST_CASE("A bisection ends with a bracket of 5 m/s and tries no velocity twice") {
  const std::vector<double> limits{171.3, 184.5, 2, 40, 320, 1500};
  std::vector<Series> series;
  std::vector<Row> rows;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    series.push_back(series_with({{"thickness_mm", std::to_string(10 + k)}}));
    for (const double v : {200, 250, 300, 400}) rows.push_back(row_at(series[k], v, limits[k]));
  }
  for (std::size_t k = 0; k < limits.size(); ++k) {
    int shots = 0;
    while (const auto velocity = next_velocity(series[k], rows, width_mps)) {
      REQUIRE(++shots < 120);
      const Case next = shot_of(series[k], *velocity, {});
      REQUIRE(find_row(rows, next.key) == nullptr);
      CHECK(next.options.velocity_mps == *velocity);
      CHECK_FALSE(next.options.vtk);
      rows.push_back(sample_row(next.key, limits[k]));
    }
  }
  const auto found = limits_in(series, rows);
  REQUIRE(found.size() == limits.size());
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const auto estimate = ogive::limit_estimate(found[k].bracket);
    REQUIRE(estimate.has_value());
    CHECK(estimate->half_width <= width_mps / 2);
    CHECK(std::abs(estimate->limit - limits[k]) <= estimate->half_width);
  }
}

TEST_CASE("The first velocities of a bisection") {
  const Series steel = series_with({});
  const auto next = [&](const std::vector<Row> &rows) { return next_velocity(steel, rows, width_mps).value_or(0); };
  // The measured limit, or one by the thickness where none is known.
  CHECK(next({}) == 184.5);
  CHECK(next_velocity(series_with({{"thickness_mm", "13"}}), {}, width_mps) == 205);

  // Half a bracket below the limit of the curve, 150.4 m/s.
  std::vector<Row> rows;
  for (const double v : {200.0, 244.2, 303.5, 399.6}) rows.push_back(row_at(steel, v, 150.4));
  CHECK(next(rows) == 148);
  // Shots of other series say nothing.
  rows.push_back(row_at(series_with({{"spacing_mm", "1.5"}}), 170, 180));
  CHECK(next(rows) == 148);
  rows.push_back(row_at(steel, 180, 190));
  CHECK(next(rows) == 190);
  rows.push_back(row_at(steel, 185, 180));
  CHECK(next(rows) == 0);

  // Shots on a straight line, which would end at 100 m/s: 6 % below the slowest.
  rows.clear();
  for (const double v : {300.0, 320.0, 340.0, 360.0, 380.0, 400.0}) {
    rows.push_back(row_at(steel, v, 100));
    result(rows.back(), "residual_velocity_mps") = ogive::shortest(v - 100);
  }
  CHECK(next(rows) == 282);
}

TEST_CASE("The series of shots differ in more than the velocity") {
  std::vector<Case> shots;
  for (const char *thickness : {"8", "12"})
    for (const char *velocity : {"200", "300", "400"})
      shots.push_back(case_of(options_with({{"thickness_mm", thickness}, {"velocity_mps", velocity}}), {}, ""));
  const auto series = series_in(shots);
  REQUIRE(series.size() == 2);
  CHECK(series[0].key.values[velocity_column].empty());
  CHECK(series[0].key == series_key(shots[2].key));
  CHECK(shot_of(series[1], 300, {}).key == shots[4].key);
}

TEST_CASE("A line for a limit has bisection, fit, test, and shots that contradict each other") {
  const Series steel = series_with({}), ogival = series_with({{"nose", "ogival"}});
  std::vector<Row> rows;
  for (const double v : {181.0, 185.0, 200.0, 250.0, 300.0, 350.0}) rows.push_back(row_at(steel, v, 182));
  auto limits = limits_in({steel, ogival}, rows);
  REQUIRE(limits.size() == 1); // no shots of the other
  CHECK(limits[0].fit->curve.limit == Approx(182).margin(0.1));
  CHECK(described(limits[0], {}) ==
        "stabilised, mjc, weldox_460e, blunt, 12 mm: limit 183.0 +- 2.0 m/s by bisection; fit to 5 shots: "
        "182.0 +- 0.0 m/s, a 0.80, p 2.00, -1.0 m/s from the bisection; test 184.5 m/s");

  rows.push_back(row_at(steel, 260, 270));
  limits = limits_in({steel}, rows);
  CHECK_FALSE(limits[0].bracket.consistent);
  CHECK(described(limits[0], {}).ends_with("; a shot stopped above one that perforated"));

  limits = limits_in({ogival}, {row_at(ogival, 300, 310)});
  REQUIRE(limits.size() == 1);
  CHECK_FALSE(limits[0].fit.has_value());
  CHECK(described(limits[0], {}) ==
        "stabilised, mjc, weldox_460e, ogival, 12 mm: no limit by bisection yet; test 295.9 m/s");

  limits[0].key.values.emplace_back("0.1");
  CHECK(described(limits[0], {"friction"}).starts_with("stabilised, mjc, weldox_460e, ogival, 12 mm, friction 0.1: "));
}

TEST_CASE("The table of limits has all its columns, whatever is known") {
  const Series steel = series_with({}), stopped = series_with({{"model", "jc"}}),
               untested = series_with({{"thickness_mm", "13"}});
  const std::vector<Row> rows{row_at(steel, 180, 190), row_at(steel, 303.5, 182), row_at(stopped, 180, 190),
                              row_at(untested, 300, 190)};
  auto limits = limits_in({steel, stopped, untested}, rows);
  std::istringstream csv(limits_csv(limits, {}));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  REQUIRE(lines.size() == 4);
  for (const auto &line : lines) CHECK(commas_in(line) == commas_in(lines[0]));
  CHECK(lines[0].starts_with("method,model,material,nose,thickness_mm,spacing_mm,highest_stopped_mps,"));
  CHECK(lines[1].starts_with("stabilised,mjc,weldox_460e,blunt,12,0.6,180,303.5,241.75,1,"));
  CHECK(lines[1].ends_with(",184.5,195"));
  CHECK(lines[2] == "stabilised,jc,weldox_460e,blunt,12,0.6,180,,,1,,,,,,,,,,,184.5,195");
  CHECK(lines[3].starts_with("stabilised,mjc,weldox_460e,blunt,13,0.6,,300,,1,"));
  CHECK(lines[3].ends_with(",,"));

  for (LimitRow &row : limits) row.key.values.emplace_back("6,7");
  CHECK(limits_csv(limits, {"layers_mm"}).find("spacing_mm,layers_mm,highest_stopped_mps") != std::string::npos);
  CHECK(limits_csv(limits, {"layers_mm"}).find("blunt,12,0.6,\"6,7\",180,303.5,") != std::string::npos);
}
