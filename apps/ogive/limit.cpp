// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/table.hpp"
#include "study/finish.hpp"
#include "study/plots.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"

#include <iostream>

namespace commands {

namespace {

struct LimitOptions {
  double width_mps = 5; ///< of the bracket
  bool run = true;
};

// clang-format off
options::Table table_of(shot::Options &o, LimitOptions &l) {
  options::Table t = shot::table_of(o);
  t.group = "Search";
  options::add(t, l.run, {.key = "run", .meaning = "run what is missing; --no-run reports only what is known",
      .source = "yes: ours", .in_file = false});
  options::add(t, l.width_mps, {.key = "width_mps",
      .meaning = "difference of the velocities between which the limit is to lie", .source = "ours",
      .brief = "width of the bracket of the limit", .limits = {0.1, 500, "m/s"}, .in_file = false});
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

/// Prints the bracket of the limit and returns its middle; nothing if there is no limit.
std::optional<double> print_bisection(const study::Series &series, const std::filesystem::path &out) {
  const auto limits = study::limits_in({series}, study::read_all_rows(out, {}));
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

/// Prints the fit, writes OUT/limits.csv and draws; with the tests of `tested`.
void finish(const study::Series &series, const study::Series &tested, const std::filesystem::path &out) {
  const auto rows = study::read_all_rows(out, {});
  const auto limits = study::limits_in({series}, rows);
  if (limits.empty()) return;
  if (limits.front().fit) print_fit(*limits.front().fit);
  if (const auto test = tested.published.test_limit_mps) std::printf("  %-22s %.1f m/s\n", "limit of the tests", *test);
  ogive::write_atomically(out / "limits.csv", study::limits_csv(limits, {}));
  try {
    study::draw_residuals({"limit", "Residual velocity and ballistic limit"}, {tested}, rows, {}, out, true);
    std::printf("  %-22s %s\n", "plot", (out / "limit.svg").c_str());
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "ogive limit: left out: %s\n", error.what());
  }
  std::printf("  %-22s %s, %s\n", "files", study::rows_shown(out).c_str(), (out / "limits.csv").c_str());
}

/// The shots above a limit that show the curve.
std::vector<study::Case> curve_above(const study::Series &series, double limit) {
  std::vector<study::Case> shots;
  for (const double times : {1.1, 1.25, 1.5, 2.0})
    if (limit * times < shot::largest_velocity_mps - 5)
      shots.push_back(study::shot_of(series, 5 * std::ceil(limit * times / 5), {}));
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
      .purpose =
          "Finds the ballistic limit of a case by bisection, fires further shots above it, prints and draws the\n"
          "fitted curve of the residual velocity. The same command resumes. It begins at --velocity-mps.\n",
      .usage = "[options]",
      .examples = "  ogive limit --thickness-mm 8 --spacing-mm 1\n"
                  "  ogive limit --material aa5083_h116 --nose conical --thickness-mm 15 --width-mps 2\n",
      .more = exit_statuses,
      .config = true};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return options::success;

  shot::Options o = shot::settled(shot::levels_of(*line));
  if (o.out == shot::default_out(o)) {
    shot::Options any = o;
    any.velocity_mps = -1;
    o.out = shot::default_out(any).string() + "_limit";
  }
  // Two shots on a core each take less time than one after the other on both.
  const int threads = o.threads.value_or(study::cores());
  const study::Study study{.out = o.out, .jobs = std::min(4, threads), .cores = threads};
  const study::Series tested = study::series_of(study::case_of(o, {}, ""));
  study::Series series = tested;
  series.published = {};
  series.guess_mps = line->find("velocity_mps") != nullptr ? o.velocity_mps : study::guess_mps(o);
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
    const auto known = study::read_all_rows(o.out, {});
    const auto coarse = study::coarser(series);
    if (coarse && (study::limits_in({series}, known).empty() || !study::limits_in({*coarse}, known).empty())) {
      report("First with twice the particle distance: the limit that is expected");
      study::Outcome first = study::find_limits(study, {*coarse}, l.width_mps, report);
      first.failed.clear(); // The search has its way without it.
      if (!may_continue(first)) return all;
      const auto rows = study::read_all_rows(o.out, {});
      series = study::guided_by(series, *coarse, rows, l.width_mps);
      if (!may_continue(study::run_cases(study, study::first_pair(series, rows, l.width_mps), report))) return all;
    }
    if (!may_continue(study::find_limits(study, {series}, l.width_mps, report))) return all;
    if (const auto limit = print_bisection(series, o.out))
      add(all, study::run_cases(study, curve_above(series, *limit), report));
    return all;
  };
  return study::run_study("ogive limit", study, l.run, run, [&] {
    if (!complete) return;
    if (!l.run) print_bisection(series, o.out);
    finish(series, tested, o.out);
  });
}

} // namespace commands
