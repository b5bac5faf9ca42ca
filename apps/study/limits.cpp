// SPDX-License-Identifier: BSD-3-Clause
#include "limits.hpp"

#include "instances/fits.hpp"
#include "materials/library.hpp"
#include "ogive/io/text.hpp"
#include "shot/defaults.hpp"
#include "shot/experiment.hpp"
#include "shot/projectile.hpp"

namespace study {

namespace {

/// The shots of a series, those that perforated thinned out to the lowest: the search steps outward by their number.
std::vector<ogive::TriedShot<double>> tried_shots(const Key &key, const std::vector<Row> &rows, bool all) {
  std::vector<ogive::TriedShot<double>> tried;
  std::optional<double> lowest;
  for (const Row &row : rows) {
    if (series_key(row.key) != key) continue;
    if (is_undecided(row)) continue;
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
    if (series_key(row.key) == key && !is_undecided(row))
      shots.push_back({number(row.key, velocity_column), number(row, "residual_velocity_mps")});
  return ogive::fit_ballistic_curve<double>(shots, ogive::BallisticCurve<double>{published.a, published.p, 0});
}

std::string text_of(const std::optional<double> &value) { return value ? ogive::shortest(*value) : ""; }

/// To a hundredth: what lies behind is noise.
std::string rounded(double value) { return ogive::shortest(std::round(100 * value) / 100); }

std::string error_of(const ogive::ParameterReport<double> &report) {
  return report.standard_error ? rounded(*report.standard_error) : "";
}

std::string origin_of(const ogive::ParameterReport<double> &report) {
  using enum ogive::ParameterOrigin;
  return report.origin == held ? "held" : report.origin == fitted ? "fitted" : "at bound";
}

/// Description of a row that is not of this series: the results of its shot are of another case. Empty if all match.
std::string conflict_in(const Study &study, const Series &series, const std::vector<Row> &rows) {
  for (const Row &row : rows) {
    if (series_key(row.key) != series.key) continue;
    const Case shot = shot_of(series, number(row.key, velocity_column), study.own_columns);
    if (const std::string reason = conflict(study, shot); !reason.empty()) return shot.name + ": " + reason;
  }
  return "";
}

/// Of each series the first of those that differ in the arrangement of the particles alone, itself if there is none.
std::vector<std::size_t> first_arrangements(const std::vector<Series> &series, const Texts &own_columns) {
  std::vector<std::size_t> first(series.size());
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto is_other = [&](const Series &s) {
      shot::Options o = s.options;
      o.seed = series[k].options.seed;
      return series_key(case_of(o, own_columns, "").key) == series[k].key;
    };
    first[k] = static_cast<std::size_t>(std::find_if(series.begin(), series.begin() + k, is_other) - series.begin());
  }
  return first;
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

Case shot_of(const Series &series, double velocity_mps, const Texts &own_columns) {
  shot::Options options = series.options;
  const bool default_end = options.end_us == default_end_us(options);
  options.velocity_mps = velocity_mps;
  if (default_end) options.end_us = default_end_us(options);
  options.vtk = false;
  return case_of(options, own_columns, "");
}

Published find_published(const shot::Options &o) {
  const materials::LibraryMetal *metal = materials::find_library_metal(o.material);
  if (metal == nullptr || !is_of_the_tests(o) || !o.layers_mm.empty()) return {};
  const experiment::Specimen tested{std::string(metal->title), std::string(ogive::name(o.nose)), o.thickness_mm};
  Published p;
  p.paper_velocity_mps = experiment::find_paper_velocity(tested);
  if (const auto limit = experiment::find_limit(tested))
    p.test_limit_mps = limit->limit_mps, p.a = limit->a, p.p = limit->p;
  return p;
}

std::optional<Series> coarser(const Series &series, const Texts &own_columns) {
  shot::Options o = series.options;
  o.spacing_mm *= 2;
  double thinnest = o.thickness_mm;
  if (!o.layers_mm.empty()) thinnest = *std::min_element(o.layers_mm.begin(), o.layers_mm.end());
  if (o.spacing_mm > thinnest / 5 || o.spacing_mm > o.diameter_mm / 8) return std::nullopt;
  Series coarse = series_of(case_of(o, own_columns, ""));
  coarse.published = series.published, coarse.guess_mps = series.guess_mps;
  return coarse;
}

Series guided_by(Series series, double limit_mps, double width_mps) {
  series.expected_mps = limit_mps;
  const double below = limit_mps - width_mps / 2;
  series.guess_mps = std::max(1.0, width_mps < 2 ? below : std::round(below));
  return series;
}

std::vector<Case> first_pair(const Series &series, const std::vector<Row> &rows, double width_mps,
                             const Texts &own_columns) {
  if (!series.expected_mps || !tried_shots(series.key, rows, false).empty()) return {};
  const auto above =
      ogive::next_velocity<double>({{series.guess_mps, false}}, series.guess_mps, width_mps, 1.0, series.expected_mps);
  std::vector<Case> pair{shot_of(series, series.guess_mps, own_columns)};
  if (above && *above <= shot::largest_velocity_mps) pair.push_back(shot_of(series, *above, own_columns));
  return pair;
}

std::optional<double> next_velocity(const Series &series, const std::vector<Row> &rows, double width_mps) {
  const auto tried = tried_shots(series.key, rows, false);
  const auto b = ogive::bracket(tried);
  std::optional<double> expected = series.expected_mps;
  if (!expected || (b.highest_stopped && *b.highest_stopped >= *expected) ||
      (b.lowest_perforated && *b.lowest_perforated <= *expected))
    expected = ogive::expected_limit(fit_of(series.key, rows, series.published));
  return ogive::next_velocity(tried, series.guess_mps, width_mps, 1, expected);
}

Case with_more_time(Case shot, const Row &row) {
  const double usual_us = default_end_us(shot.options), longest_us = std::min(8 * usual_us, shot::longest_us);
  if (shot.options.end_us != usual_us) return shot;
  while (is_final(row, shot) && shot.options.end_us < longest_us)
    shot.options.end_us = std::min(2 * shot.options.end_us, longest_us);
  return shot;
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
  const auto first = first_arrangements(own, study.own_columns);
  std::vector<std::optional<Key>> last(own.size());
  std::vector<double> given_us(own.size(), 0); // of the last shot
  std::vector<bool> ended(own.size(), false);
  const auto end = [&](std::size_t k, const std::string &reason) {
    ended[k] = true;
    all.failed.push_back(reason);
    report("failed: " + reason);
  };
  const auto next = [&](const std::vector<Row> &rows) -> std::optional<Case> {
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (ended[k]) continue;
      if (last[k] && find_row(rows, *last[k]) == nullptr) continue; // its shot is running, or has failed
      if (const std::size_t j = first[k]; j != k && !own[k].expected_mps) {
        if (!ended[j] && next_velocity(own[j], rows, width_mps)) continue;
        if (const auto limit = ogive::limit_estimate(ogive::bracket(tried_shots(own[j].key, rows, false))))
          own[k] = guided_by(own[k], limit->limit, width_mps);
      }
      const auto velocity = next_velocity(own[k], rows, width_mps);
      if (!velocity) continue;
      Case shot = shot_of(own[k], *velocity, study.own_columns);
      if (*velocity > shot::largest_velocity_mps) {
        end(k, shot.name + ": no shot up to " + ogive::shortest(shot::largest_velocity_mps) +
                   " m/s perforates: the limit lies above all velocities that are allowed");
        continue;
      }
      const Row *row = find_row(rows, shot.key);
      if (row != nullptr && is_undecided(*row)) {
        const double had_us = number(*row, "simulated_us");
        if (last[k] == shot.key && had_us < given_us[k] * (1 - 1e-9)) continue; // it is running again
        shot = with_more_time(shot, *row);
        if (is_final(*row, shot)) {
          end(k, shot.name + ": undecided at " + ogive::shortest(had_us) + " us; a later --end-us decides it");
          continue;
        }
      }
      last[k] = shot.key, given_us[k] = shot.options.end_us;
      return shot;
    }
    return std::nullopt;
  };
  for (bool waiting = true; waiting && all.stopped_by == 0;) {
    add(all, run_chosen(study, own.size(), next, report));
    // Those that waited for an arrangement whose shot has failed are searched without its limit.
    const auto rows = read_all_rows(study.out, study.own_columns);
    waiting = false;
    for (std::size_t k = 0; k < own.size(); ++k) {
      const std::size_t j = first[k];
      if (j == k || last[k] || ended[k] || ended[j] || !last[j] || find_row(rows, *last[j]) != nullptr) continue;
      waiting = ended[j] = true;
    }
  }
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

std::string limits_csv(const std::vector<LimitRow> &limits, const Texts &own_columns) {
  const auto line = [](Texts fields, const Texts &results) {
    fields.erase(fields.begin() + velocity_column);
    fields.insert(fields.end(), results.begin(), results.end());
    return csv_line(fields);
  };
  Texts columns = key_columns();
  columns.insert(columns.end(), own_columns.begin(), own_columns.end());
  std::string csv = line(columns, options::split("highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps,"
                                                 "consistent,fit_limit_mps,fit_limit_se_mps,fit_a,fit_a_se,"
                                                 "fit_a_origin,fit_p,fit_p_se,fit_p_origin,fit_points,fit_rms_mps,"
                                                 "test_limit_mps,paper_velocity_mps",
                                                 ','));
  for (const LimitRow &row : limits) {
    const auto estimate = ogive::limit_estimate(row.bracket);
    Texts results{text_of(row.bracket.highest_stopped), text_of(row.bracket.lowest_perforated),
                  estimate ? ogive::shortest(estimate->limit) : "", row.bracket.consistent ? "1" : "0"};
    Texts fit(10);
    if (row.fit) {
      const auto &f = *row.fit;
      fit = {rounded(f.curve.limit),   error_of(f.limit),  rounded(f.curve.a), error_of(f.a),
             origin_of(f.a),           rounded(f.curve.p), error_of(f.p),      origin_of(f.p),
             std::to_string(f.points), rounded(f.rms)};
    }
    results.insert(results.end(), fit.begin(), fit.end());
    results.push_back(text_of(row.published.test_limit_mps));
    results.push_back(text_of(row.published.paper_velocity_mps));
    csv += line(row.key.values, results);
  }
  return csv;
}

std::string described(const LimitRow &row, const Texts &own_columns) {
  using options::printed;
  const Texts &v = row.key.values;
  std::string line = v[method_column] + ", " + v[model_column] + ", " + v[material_column] + ", " + v[nose_column] +
                     ", " + v[thickness_column] + " mm";
  for (std::size_t k = key_columns().size(); k < v.size(); ++k) line += ", " + column_name(k, own_columns) + " " + v[k];
  const auto estimate = ogive::limit_estimate(row.bracket);
  line += estimate ? printed(": limit %.1f +- %.1f m/s by bisection", estimate->limit, estimate->half_width)
                   : ": no limit by bisection yet";
  if (row.fit) {
    const auto &f = *row.fit;
    line += printed("; fit to %zu shots: %.1f", f.points, f.curve.limit) +
            (f.limit.standard_error ? printed(" +- %.1f", *f.limit.standard_error) : "") +
            printed(" m/s, a %.2f, p %.2f", f.curve.a, f.curve.p) +
            (estimate ? printed(", %+.1f m/s from the bisection", f.curve.limit - estimate->limit) : "");
  }
  if (row.published.test_limit_mps) line += "; test " + ogive::shortest(*row.published.test_limit_mps) + " m/s";
  return line + (row.bracket.consistent ? "" : "; a shot stopped above one that perforated");
}

} // namespace study
