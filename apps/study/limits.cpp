// SPDX-License-Identifier: BSD-3-Clause
#include "limits.hpp"

#include "materials/library.hpp"
#include "ogive/io/text.hpp"
#include "shot/defaults.hpp"
#include "shot/experiment.hpp"
#include "shot/projectile.hpp"

#include <algorithm>
#include <cmath>

namespace study {

namespace {

/// The shots of a series, those that perforated thinned out to the lowest: the search steps outward by their number.
std::vector<ogive::TriedShot<double>> tried_shots(const Key &key, const std::vector<Row> &rows, bool all) {
  std::vector<ogive::TriedShot<double>> tried;
  std::optional<double> lowest;
  for (const Row &row : rows) {
    if (series_key(row.key) != key) continue;
    const double v = number(row.key, velocity_column);
    const bool perforated = number(row, "perforated") != 0;
    if (all || !perforated)
      tried.push_back({v, perforated});
    else
      lowest = std::min(v, lowest.value_or(v));
  }
  if (lowest) tried.push_back({*lowest, true});
  return tried;
}

/// The curve through the residual velocities of a series; nothing if no shot perforated.
std::optional<ogive::BallisticFit<double>> fit_of(const Key &key, const std::vector<Row> &rows,
                                                  const Published &published) {
  std::vector<ogive::ResidualShot<double>> shots;
  for (const Row &row : rows)
    if (series_key(row.key) == key)
      shots.push_back({number(row.key, velocity_column), number(row, "residual_velocity_mps")});
  return ogive::fit_ballistic_curve<double>(shots, ogive::BallisticCurve<double>{published.a, published.p, 0});
}

std::string text_of(const std::optional<double> &value) { return value ? ogive::shortest(*value) : ""; }

/// To a hundredth: what lies behind is noise.
std::string rounded(double value) { return ogive::shortest(std::round(100 * value) / 100); }

std::string origin_of(const ogive::ParameterReport<double> &report) {
  using enum ogive::ParameterOrigin;
  return report.origin == held ? "held" : report.origin == fitted ? "fitted" : "at bound";
}

/// Why the rows of a series are not its own: the results of a shot are of another case. Empty if they are.
std::string conflict_in(const Study &study, const Series &series, const std::vector<Row> &rows) {
  for (const Row &row : rows) {
    if (series_key(row.key) != series.key) continue;
    const Case shot = shot_of(series, number(row.key, velocity_column), study.own_columns);
    if (const std::string reason = conflict(study, shot); !reason.empty()) return shot.name + ": " + reason;
  }
  return "";
}

} // namespace

Key series_key(Key key) {
  key.values[velocity_column].clear();
  return key;
}

double guess_mps(const shot::Options &options) { return 5 * std::round((90 + 9 * options.thickness_mm) / 5); }

Series series_of(const Case &shot) {
  Series series{shot.options, series_key(shot.key), 0, find_published(shot.options)};
  series.guess_mps = series.published.test_limit_mps.value_or(guess_mps(shot.options));
  return series;
}

std::vector<Series> series_in(const std::vector<Case> &shots) {
  std::vector<Series> all;
  for (const Case &shot : shots)
    if (std::none_of(all.begin(), all.end(), [&](const Series &s) { return s.key == series_key(shot.key); }))
      all.push_back(series_of(shot));
  return all;
}

Case shot_of(const Series &series, double velocity_mps, const std::vector<std::string> &own_columns) {
  shot::Options options = series.options;
  options.velocity_mps = velocity_mps;
  options.vtk = false;
  return case_of(options, own_columns, "");
}

Published find_published(const shot::Options &o) {
  Published p;
  const materials::LibraryMetal *metal = materials::find_library_metal(o.material);
  if (metal == nullptr || !is_of_the_tests(o) || !o.layers_mm.empty()) return p;
  const std::string nose(ogive::name(o.nose));
  const auto same = [&](const std::vector<std::string> &row) {
    const auto thickness = row.size() > 5 ? ogive::number_from(row[4]) : std::nullopt;
    return thickness && std::abs(*thickness - o.thickness_mm) < 0.01 && row[2] == metal->test_name && row[3] == nose;
  };
  for (auto row : experiment::read_rows(experiment::data_folder() / "experiment_limits.csv")) {
    row.insert(row.begin(), ""); // the columns then stand as in paper_simulations.csv
    if (!same(row) || row.size() < 9) continue;
    p.test_limit_mps = ogive::number_from(row[5]);
    const double plug = nose == "blunt" ? experiment::plug_mass_kg(o.thickness_mm) : 0;
    p.a = ogive::number_from(row[6]).value_or(experiment::projectile_mass_kg / (experiment::projectile_mass_kg + plug));
    p.p = ogive::number_from(row[7]).value_or(2);
  }
  for (const auto &row : experiment::read_rows(experiment::data_folder() / "paper_simulations.csv"))
    if (row[0] == "10" && same(row)) p.paper_velocity_mps = ogive::number_from(row[5]);
  return p;
}

std::optional<double> next_velocity(const Series &series, const std::vector<Row> &rows, double width_mps) {
  const auto expected = ogive::expected_limit(fit_of(series.key, rows, series.published));
  return ogive::next_velocity(tried_shots(series.key, rows, false), series.guess_mps, width_mps, 1, expected);
}

Outcome find_limits(const Study &study, const std::vector<Series> &series, double width_mps, const Report &report) {
  const auto before = read_all_rows(study.out, study.own_columns);
  Outcome all;
  std::vector<Series> own;
  for (const Series &one : series) {
    const std::string reason = conflict_in(study, one, before);
    if (!reason.empty()) {
      all.failed.push_back(reason);
      report("failed: " + reason);
      continue;
    }
    own.push_back(one);
    all.known += static_cast<int>(
        std::count_if(before.begin(), before.end(), [&](const Row &row) { return series_key(row.key) == one.key; }));
  }
  std::vector<std::optional<Key>> last(own.size());
  const auto next = [&](const std::vector<Row> &rows) -> std::optional<Case> {
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (last[k] && find_row(rows, *last[k]) == nullptr) continue; // its shot is running, or has failed
      const auto velocity = next_velocity(own[k], rows, width_mps);
      if (!velocity) continue;
      Case shot = shot_of(own[k], *velocity, study.own_columns);
      last[k] = shot.key;
      return shot;
    }
    return std::nullopt;
  };
  add(all, run_chosen(study, own.size(), next, report));
  return all;
}

std::vector<LimitRow> limits_in(const std::vector<Series> &series, const std::vector<Row> &rows) {
  std::vector<LimitRow> limits;
  for (const Series &s : series) {
    const auto tried = tried_shots(s.key, rows, true);
    if (!tried.empty()) limits.push_back({s.key, ogive::bracket(tried), fit_of(s.key, rows, s.published), s.published});
  }
  return limits;
}

std::string limits_csv(const std::vector<LimitRow> &limits, const std::vector<std::string> &own_columns) {
  std::string csv;
  for (const auto &column : key_columns())
    if (column != key_columns()[velocity_column]) csv += column + ",";
  for (const auto &column : own_columns) csv += column + ",";
  csv += "highest_stopped_mps,lowest_perforated_mps,"
         "bisection_limit_mps,consistent,fit_limit_mps,fit_limit_se_mps,fit_a,fit_a_se,fit_a_origin,fit_p,"
         "fit_p_se,fit_p_origin,fit_points,fit_rms_mps,test_limit_mps,paper_velocity_mps\n";
  for (const LimitRow &row : limits) {
    for (std::size_t k = 0; k < row.key.values.size(); ++k)
      if (k != velocity_column) csv += csv_field(row.key.values[k]) + ",";
    csv += text_of(row.bracket.highest_stopped) + "," + text_of(row.bracket.lowest_perforated) + ",";
    const auto estimate = ogive::limit_estimate(row.bracket);
    csv += (estimate ? ogive::shortest(estimate->limit) : "") + (row.bracket.consistent ? ",1," : ",0,");
    if (row.fit) {
      const auto &f = *row.fit;
      const auto error = [](const ogive::ParameterReport<double> &r) {
        return r.standard_error ? rounded(*r.standard_error) : "";
      };
      csv += rounded(f.curve.limit) + "," + error(f.limit) + "," + rounded(f.curve.a) + "," + error(f.a) + "," +
             origin_of(f.a) + "," + rounded(f.curve.p) + "," + error(f.p) + "," + origin_of(f.p) + "," +
             std::to_string(f.points) + "," + rounded(f.rms) + ",";
    } else {
      csv += ",,,,,,,,,,";
    }
    csv += text_of(row.published.test_limit_mps) + "," + text_of(row.published.paper_velocity_mps) + "\n";
  }
  return csv;
}

std::string described(const LimitRow &row, const std::vector<std::string> &own_columns) {
  using ogive::with_decimals;
  const auto &v = row.key.values;
  std::string line = (v[method_column] == "sfm" ? "" : v[method_column] + ", ") + v[model_column] + ", " +
                     v[material_column] + ", " + v[nose_column] + ", " + v[thickness_column] + " mm";
  for (std::size_t k = 0; k < own_columns.size(); ++k)
    line += ", " + own_columns[k] + " " + v[key_columns().size() + k];
  line += ": ";
  const auto estimate = ogive::limit_estimate(row.bracket);
  if (estimate) {
    line += "limit " + with_decimals(estimate->limit, 1) + " +- " + with_decimals(estimate->half_width, 1) +
            " m/s by bisection";
  } else {
    line += "no limit by bisection yet";
  }
  if (row.fit) {
    const auto &f = *row.fit;
    line += "; fit to " + std::to_string(f.points) + " shots: " + with_decimals(f.curve.limit, 1);
    if (f.limit.standard_error) line += " +- " + with_decimals(*f.limit.standard_error, 1);
    line += " m/s, a " + with_decimals(f.curve.a, 2) + ", p " + with_decimals(f.curve.p, 2);
    if (estimate) {
      const double apart = f.curve.limit - estimate->limit;
      line += (std::signbit(apart) ? ", " : ", +") + with_decimals(apart, 1) + " m/s from the bisection";
    }
  }
  if (row.published.test_limit_mps) line += "; test " + ogive::shortest(*row.published.test_limit_mps) + " m/s";
  if (!row.bracket.consistent) line += "; a shot stopped above one that perforated";
  return line;
}

} // namespace study
