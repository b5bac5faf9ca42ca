// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/table.hpp"
#include "study/finish.hpp"
#include "study/plots.hpp"
#include "study/prediction.hpp"

#include "ogive/fit/repeated_limit.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"

#include <iostream>

namespace commands {

namespace {

struct LimitOptions {
  double width_mps = 5;        ///< of the bracket
  int repeats = 1;             ///< searches, each with an arrangement of its own
  std::filesystem::path check; ///< a record to compare with; empty: none
  bool run = true;
};

/// The searches of one limit differ in it.
const study::Texts own_columns{"seed"};

// clang-format off
options::Table table_of(shot::Options &o, LimitOptions &l) {
  options::Table t = shot::table_of(o);
  t.group = "Search";
  options::add(t, l.run, {.key = "run", .meaning = "run missing shots; without it only existing results are reported",
      .source = "yes: ours", .in_file = false});
  options::add(t, l.width_mps, {.key = "width_mps",
      .meaning = "largest width of the bracket of the limit", .source = "ours",
      .brief = "width of the bracket of the limit", .limits = {0.1, 500, "m/s"}, .in_file = false});
  options::add(t, l.repeats, {.key = "repeats",
      .meaning = "number of searches, each with another arrangement of the particles: --seed, --seed + 1 and so on; "
      "gives mean, standard deviation and 90 % interval", .source = "ours",
      .brief = "searches with different arrangements of the particles",
      .limits = {1, 1000, ""}, .in_file = false});
  options::add(t, l.check, {.key = "check",
      .meaning = "compare the limit with a prediction.json of an earlier search for the same case; status 3 if it is "
      "not confirmed",
      .source = "none", .in_file = false}).placeholder = "FILE.json";
  return t;
}
// clang-format on

std::string with_error(double value, const ogive::ParameterReport<double> &report, int decimals) {
  const std::string text = ogive::with_decimals(value, decimals);
  if (report.standard_error) return text + " +- " + ogive::with_decimals(*report.standard_error, decimals);
  return text + (report.origin == ogive::ParameterOrigin::held ? " (held)" : "");
}

void print_fit(const ogive::BallisticFit<double> &fit) {
  std::printf("  %-22s %s m/s\n", "limit of the fit", with_error(fit.curve.limit, fit.limit, 1).c_str());
  std::printf("  %-22s a %s, p %s, %zu shots, rms %.1f m/s\n", "v_r = a (v^p-v_l^p)^1/p",
              with_error(fit.curve.a, fit.a, 3).c_str(), with_error(fit.curve.p, fit.p, 2).c_str(), fit.points,
              fit.rms);
}

/// The limit that the shots of a series give; nothing while one side is open.
std::optional<ogive::LimitEstimate<double>> limit_of(const study::Series &series, const std::filesystem::path &out) {
  const auto limits = study::limits_in({series}, study::read_all_rows(out, own_columns));
  return limits.empty() ? std::nullopt : ogive::limit_estimate(limits.front().bracket);
}

/// Prints the bracket of the limit and returns its middle; nothing if there is no limit.
std::optional<double> print_bisection(const study::Series &series, const std::filesystem::path &out) {
  const auto limits = study::limits_in({series}, study::read_all_rows(out, own_columns));
  if (limits.empty()) return std::nullopt;
  const auto &bracket = limits.front().bracket;
  const auto estimate = ogive::limit_estimate(bracket);
  if (estimate)
    std::printf("  %-22s %.1f +- %.1f m/s%s\n", "limit by bisection", estimate->limit, estimate->half_width,
                bracket.consistent ? "" : "; a shot stopped above one that perforated");
  else
    std::printf("  %-22s none: %s\n", "limit by bisection",
                bracket.lowest_perforated ? "all shots perforated" : "all shots were stopped");
  std::fflush(stdout);
  return estimate ? std::optional(estimate->limit) : std::nullopt;
}

/// Prints what the limits of all arrangements have in common, of those that are known to `width_mps`, and writes
/// OUT/repeats.csv.
void finish_repeats(const std::vector<study::Series> &series, double width_mps, const std::filesystem::path &out) {
  std::vector<ogive::LimitEstimate<double>> limits;
  std::string each;
  for (const study::Series &one : series)
    if (const auto limit = limit_of(one, out); limit && 2 * limit->half_width <= width_mps * (1 + 1e-9)) {
      limits.push_back(*limit);
      each += (each.empty() ? "" : ", ") + options::printed("%.1f", limit->limit);
    }
  std::error_code ignored;
  std::filesystem::remove(out / "repeats.csv", ignored);
  if (limits.size() < 2) return;
  const auto all = ogive::repeated_limit(limits);
  std::printf("  %-22s %s m/s%s\n", "of each arrangement", each.c_str(),
              limits.size() == series.size()
                  ? ""
                  : options::printed("; %zu of %zu are known", limits.size(), series.size()).c_str());
  std::printf("  %-22s %.1f m/s, standard deviation %.1f m/s\n", "mean limit", all.mean, *all.deviation);
  std::printf("  %-22s %.1f to %.1f m/s\n", "90 % interval", all.mean - *all.half_interval,
              all.mean + *all.half_interval);
  std::printf("  %-22s %s\n", "file", (out / "repeats.csv").c_str());
  const auto text = [](double value) { return ogive::with_decimals(value, 2); };
  ogive::write_atomically(
      out / "repeats.csv",
      "repeats,mean_mps,standard_deviation_mps,interval_low_mps,interval_high_mps\n" +
          study::csv_line({std::to_string(all.repeats), text(all.mean), text(*all.deviation),
                           text(all.mean - *all.half_interval), text(all.mean + *all.half_interval)}));
}

/// Prints the fit, writes OUT/limits.csv and draws; with the tests of `tested`.
void finish(const std::vector<study::Series> &series, double width_mps, const study::Series &tested,
            const std::filesystem::path &out) {
  const auto rows = study::read_all_rows(out, own_columns);
  const auto limits = study::limits_in(series, rows), first = study::limits_in({series.front()}, rows);
  if (limits.empty()) return;
  if (!first.empty() && first.front().fit) print_fit(*first.front().fit);
  if (const auto test = tested.published.test_limit_mps) std::printf("  %-22s %.1f m/s\n", "limit of the tests", *test);
  finish_repeats(series, width_mps, out);
  ogive::write_atomically(out / "limits.csv", study::limits_csv(limits, own_columns));
  try {
    std::vector<study::Series> drawn = series;
    drawn.front() = tested;
    study::draw_residuals({"limit", "Residual velocity and ballistic limit"}, drawn, rows, own_columns, out, true);
    std::printf("  %-22s %s\n", "plot", (out / "limit.svg").c_str());
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "ogive limit: left out: %s\n", error.what());
  }
  std::printf("  %-22s %s, %s\n", "files", study::rows_shown(out).c_str(), (out / "limits.csv").c_str());
}

/// Writes OUT/prediction.json, and prints whether it confirms an earlier one. False if it does not.
bool finish_prediction(const study::Study &study, const shot::Options &o, double width_mps,
                       const std::vector<study::Series> &series, const std::optional<study::Prediction> &earlier) {
  const auto file = study.out / "prediction.json";
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  try {
    const study::Prediction now = study::predicted(study, o, width_mps, series);
    ogive::write_atomically(file, now.text);
    std::printf("  %-22s %s\n", "record", file.c_str());
    if (!earlier) return true;
    const study::Comparison comparison = study::compared(now, *earlier);
    std::printf("  %-22s %s\n", "earlier prediction", comparison.text.c_str());
    return comparison.confirmed;
  } catch (const ogive::SetupError &error) {
    std::printf("  %-22s none: %s\n", "record", error.what());
    return !earlier;
  }
}

/// The shots above a limit that show the curve.
std::vector<study::Case> curve_above(const study::Series &series, double limit) {
  std::vector<study::Case> shots;
  for (const double times : {1.1, 1.25, 1.5, 2.0})
    if (limit * times < shot::largest_velocity_mps - 5)
      shots.push_back(study::shot_of(series, 5 * std::ceil(limit * times / 5), own_columns));
  return shots;
}

} // namespace

options::Table limit_table() { return unbound(table_of); }

int limit(const options::Arguments &arguments) {
  shot::Options defaults;
  LimitOptions l;
  const options::Table table = table_of(defaults, l);
  const options::Command command{
      .name = "ogive limit",
      .purpose = "Finds the ballistic limit of a case by bisection from --velocity-mps, runs further shots above it,\n"
                 "prints and draws the fitted curve of the residual velocity. The same command resumes.\n",
      .usage = "[options]",
      .examples = "  ogive limit --thickness-mm 8 --spacing-mm 1\n"
                  "  ogive limit --material aa5083_h116 --nose conical --thickness-mm 15 --width-mps 2\n"
                  "  ogive limit --thickness-mm 12 --repeats 3\n",
      .more = exit_statuses,
      .config = true};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return options::only_printed;

  shot::Options o = shot::settled(shot::levels_of(*line));
  if (o.out == shot::default_out(o)) {
    shot::Options any = o;
    any.velocity_mps = -1;
    o.out = shot::default_out(any).string() + "_limit";
  }
  if (o.seed > shot::largest_seed + 1 - l.repeats)
    options::refuse("--repeats", std::to_string(l.repeats),
                    "must be at most " + std::to_string(shot::largest_seed + 1 - o.seed) + " with this --seed");
  std::optional<study::Prediction> earlier;
  if (!l.check.empty()) {
    earlier = study::read_prediction(l.check, "--check");
    study::require_same_case(*earlier, o, l.width_mps, "--check");
  }
  // Two shots on a core each take less time than one after the other on both.
  const int threads = o.threads.value_or(study::cores());
  const study::Study study{.out = o.out, .own_columns = own_columns, .jobs = std::min(4, threads), .cores = threads};
  const study::Series tested = study::series_of(study::case_of(o, own_columns, ""));
  std::vector<study::Series> series;
  for (int k = 0; k < l.repeats; ++k) {
    shot::Options other = o;
    other.seed += k;
    series.push_back(study::series_of(study::case_of(other, own_columns, "")));
    series.back().published = {};
    series.back().guess_mps = line->find("velocity_mps") != nullptr ? o.velocity_mps : study::guess_mps(o);
  }
  bool complete = true;
  const auto run = [&](const study::Report &report) {
    report("Ballistic limit within " + options::shortest(l.width_mps / 2) + " m/s, " + o.out.string() + ", method " +
           shot::name_of(o.method));
    study::report_doubts({o}, report);
    study::Outcome all;
    const auto may_continue = [&](const study::Outcome &part) {
      add(all, part);
      return complete = all.stopped_by == 0 && all.failed.empty();
    };
    study::Series &first = series.front();
    const auto known = study::read_all_rows(o.out, own_columns);
    const auto coarse = study::coarser(first, own_columns);
    if (coarse && (study::limits_in({first}, known).empty() || !study::limits_in({*coarse}, known).empty())) {
      report("First with twice the particle distance: the limit that is expected");
      study::Outcome part = study::find_limits(study, {*coarse}, l.width_mps, report);
      part.failed.clear(); // The search has its way without it.
      if (!may_continue(part)) return all;
      const auto rows = study::read_all_rows(o.out, own_columns);
      if (const auto limit = limit_of(*coarse, o.out)) first = study::guided_by(first, limit->limit, l.width_mps);
      if (!may_continue(study::run_cases(study, study::first_pair(first, rows, l.width_mps, own_columns), report)))
        return all;
    }
    if (!may_continue(study::find_limits(study, {first}, l.width_mps, report))) return all;
    const auto limit = print_bisection(first, o.out);
    if (limit && series.size() > 1) {
      report("Then with other arrangements of the particles");
      std::vector<study::Series> others;
      for (std::size_t k = 1; k < series.size(); ++k)
        others.push_back(study::guided_by(series[k], *limit, l.width_mps));
      if (!may_continue(study::find_limits(study, others, l.width_mps, report))) return all;
    }
    if (limit) add(all, study::run_cases(study, curve_above(first, *limit), report));
    return all;
  };
  bool confirmed = true;
  const int status = study::run_study("ogive limit", study, l.run, run, [&] {
    if (!complete) return;
    if (!l.run) print_bisection(series.front(), o.out);
    finish(series, l.width_mps, tested, o.out);
    confirmed = finish_prediction(study, o, l.width_mps, series, earlier);
  });
  return status == options::success && !confirmed ? options::not_finished : status;
}

} // namespace commands
