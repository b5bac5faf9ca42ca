// SPDX-License-Identifier: BSD-3-Clause
#include "limits.hpp"

#include "shared/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace figures {

namespace {

/// Bisection ends with a bracket of this width: the limit to half of it.
constexpr double bracket_width_mps = 5;

/// The shots of a series, those that perforated thinned out to the lowest: the search steps outward by their number.
std::vector<ogive::TriedShot<double>> tried_shots(const SeriesKey &key, const std::vector<ShotRow> &rows, bool all) {
  std::vector<ogive::TriedShot<double>> tried;
  std::optional<double> lowest;
  for (const ShotRow &row : rows) {
    if (series_of(row.key) != key) continue;
    const double v = row.key.initial_velocity_mps;
    if (all || row.perforated == 0)
      tried.push_back({v, row.perforated != 0});
    else
      lowest = std::min(v, lowest.value_or(v));
  }
  if (lowest) tried.push_back({*lowest, true});
  return tried;
}

/// The curve through the residual velocities of a series; nothing if no shot perforated.
std::optional<ogive::BallisticFit<double>> fit_of(const SeriesKey &key, const std::vector<ShotRow> &rows,
                                                  const Published &published) {
  std::vector<ogive::ResidualShot<double>> shots;
  for (const ShotRow &shot : rows)
    if (series_of(shot.key) == key) shots.push_back({shot.key.initial_velocity_mps, shot.residual_velocity_mps});
  return ogive::fit_ballistic_curve<double>(shots, ogive::BallisticCurve<double>{published.a, published.p, 0});
}

/// A number of a table's field; nothing where it is empty.
std::optional<double> number_in(const std::string &field) { return ogive::number_from(field); }

std::string text_of(const std::optional<double> &value) { return value ? ogive::shortest(*value) : ""; }

/// To a hundredth: what lies behind is noise.
std::string rounded(double value) { return ogive::shortest(std::round(100 * value) / 100); }

std::string origin_of(const ogive::ParameterReport<double> &report) {
  using enum ogive::ParameterOrigin;
  return report.origin == held ? "held" : report.origin == fitted ? "fitted" : "at bound";
}

} // namespace

SeriesKey series_of(const ShotKey &k) { return {k.method, k.model, k.material, k.nose, k.thickness_mm, k.spacing_mm}; }

ShotKey shot_of(const SeriesKey &k, double velocity_mps) {
  return {k.method, k.model, k.material, k.nose, k.thickness_mm, velocity_mps, k.spacing_mm};
}

Published find_published(const SeriesKey &key, const std::filesystem::path &data) {
  const std::string metal = key.material.starts_with("weldox") ? "Weldox 460 E" : "AA5083-H116";
  const auto same = [&](const std::vector<std::string> &row) {
    const auto thickness = row.size() > 5 ? number_in(row[4]) : std::nullopt;
    return thickness && std::abs(*thickness - key.thickness_mm) < 0.01 && row[2] == metal && row[3] == key.nose;
  };
  Published p;
  for (auto row : experiment::read_rows(data / "experiment_limits.csv")) {
    row.insert(row.begin(), ""); // the columns then stand as in paper_simulations.csv
    if (!same(row) || row.size() < 9) continue;
    p.test_limit_mps = number_in(row[5]);
    const double plug = key.nose == "blunt" ? experiment::plug_mass_kg(key.thickness_mm) : 0;
    p.a = number_in(row[6]).value_or(experiment::projectile_mass_kg / (experiment::projectile_mass_kg + plug));
    p.p = number_in(row[7]).value_or(2);
    p.test_source = row[8];
  }
  for (const auto &row : experiment::read_rows(data / "paper_simulations.csv"))
    if (row[0] == "10" && same(row)) p.paper_velocity_mps = number_in(row[5]);
  return p;
}

std::vector<Task> next_round(const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
                             const std::filesystem::path &data) {
  std::vector<Task> round;
  for (const SeriesKey &key : series) {
    const Published published = find_published(key, data);
    const auto expected = ogive::expected_limit(fit_of(key, rows, published));
    const double guess = published.test_limit_mps.value_or(200);
    if (const auto v = ogive::next_velocity(tried_shots(key, rows, false), guess, bracket_width_mps, 1, expected))
      round.push_back({shot_of(key, *v)});
  }
  return round;
}

std::vector<LimitRow> find_limits(const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
                                  const std::filesystem::path &data) {
  std::vector<LimitRow> limits;
  for (const SeriesKey &key : series) {
    const auto tried = tried_shots(key, rows, true);
    if (tried.empty()) continue;
    LimitRow row{key, ogive::bracket(tried), std::nullopt, find_published(key, data)};
    row.fit = fit_of(key, rows, row.published);
    limits.push_back(std::move(row));
  }
  return limits;
}

std::string limits_csv(const std::vector<LimitRow> &limits) {
  std::string csv = "method,model,material,nose,thickness_mm,spacing_mm,highest_stopped_mps,lowest_perforated_mps,"
                    "bisection_limit_mps,consistent,fit_limit_mps,fit_limit_se_mps,fit_a,fit_a_se,fit_a_origin,fit_p,"
                    "fit_p_se,fit_p_origin,fit_points,fit_rms_mps,test_limit_mps,paper_velocity_mps\n";
  for (const LimitRow &row : limits) {
    const SeriesKey &k = row.key;
    csv += k.method + "," + k.model + "," + k.material + "," + k.nose + "," + ogive::shortest(k.thickness_mm) + "," +
           ogive::shortest(k.spacing_mm) + "," + text_of(row.bracket.highest_stopped) + "," +
           text_of(row.bracket.lowest_perforated) + ",";
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

std::string described(const LimitRow &row) {
  char text[240];
  std::string line = row.key.model + ", " + row.key.material + ", " + row.key.nose + ", " +
                     ogive::shortest(row.key.thickness_mm) + " mm: ";
  const auto estimate = ogive::limit_estimate(row.bracket);
  if (estimate) {
    std::snprintf(text, sizeof text, "limit %.1f +- %.1f m/s by bisection", estimate->limit, estimate->half_width);
    line += text;
  } else {
    line += "no limit by bisection yet";
  }
  if (row.fit) {
    const auto &f = *row.fit;
    std::snprintf(text, sizeof text, "; fit to %zu shots: %.1f", f.points, f.curve.limit);
    line += text;
    if (f.limit.standard_error) {
      std::snprintf(text, sizeof text, " +- %.1f", *f.limit.standard_error);
      line += text;
    }
    std::snprintf(text, sizeof text, " m/s, a %.2f, p %.2f", f.curve.a, f.curve.p);
    line += text;
    if (estimate) {
      std::snprintf(text, sizeof text, ", %+.1f m/s from the bisection", f.curve.limit - estimate->limit);
      line += text;
    }
  }
  if (row.published.test_limit_mps) line += "; test " + ogive::shortest(*row.published.test_limit_mps) + " m/s";
  if (!row.bracket.consistent) line += "; a shot stopped above one that perforated";
  return line;
}

} // namespace figures
