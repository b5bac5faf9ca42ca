// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/signals.hpp"
#include "shot/table.hpp"
#include "study/cases.hpp"
#include "study/finish.hpp"
#include "study/plots.hpp"

#include "ogive/io/write_error.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace commands {

namespace {

/// Velocities above the limit that show the curve, over the limit.
constexpr std::array<double, 4> shown_velocities{1.1, 1.25, 1.5, 2.0};

struct LimitOptions {
  double width_mps = 5; ///< of the bracket
  study::StudyOptions study{.jobs = 1};
};

options::Table table_of(shot::Options &o, LimitOptions &l) {
  options::Table t = shot::table_of(o);
  study::add_study_options(t, l.study);
  options::add(t, l.width_mps,
               {.key = "width_mps",
                .meaning = "difference of the velocities between which the limit is to lie",
                .source = "ours",
                .brief = "width of the bracket of the limit",
                .limits = {0.1, 500, "m/s"},
                .in_file = false});
  return t;
}

std::string with_error(double value, const ogive::ParameterReport<double> &report, const char *form) {
  char text[64], error[64] = "";
  std::snprintf(text, sizeof text, form, value);
  if (report.standard_error) std::snprintf(error, sizeof error, form, *report.standard_error);
  if (*error != 0) return std::string(text) + " +- " + error;
  return std::string(text) + (report.origin == ogive::ParameterOrigin::held ? " (held)" : "");
}

void print_fit(const ogive::BallisticFit<double> &fit) {
  std::printf("  %-22s %s m/s\n", "limit of the fit", with_error(fit.curve.limit, fit.limit, "%.1f").c_str());
  std::printf("  %-22s a %s, p %s, %zu shots, rms %.1f m/s\n", "v_r = a (v^p-v_l^p)^1/p",
              with_error(fit.curve.a, fit.a, "%.3f").c_str(), with_error(fit.curve.p, fit.p, "%.2f").c_str(),
              fit.points, fit.rms);
}

/// The shots above a limit that show the curve.
std::vector<study::Case> curve_above(const study::Series &series, double limit) {
  std::vector<study::Case> shots;
  for (const double times : shown_velocities)
    shots.push_back(study::shot_of(series, 5 * std::ceil(limit * times / 5), {}));
  return shots;
}

} // namespace

options::Table limit_table() {
  shot::Options o;
  LimitOptions l;
  return table_of(o, l);
}

int limit(const options::Arguments &arguments) {
  shot::Options defaults;
  LimitOptions l;
  const options::Table table = table_of(defaults, l);
  const options::Command command{
      .name = "ogive limit",
      .purpose =
          "Finds the ballistic limit of a case by bisection, fires further shots above it, prints and draws the\n"
          "fitted curve of the residual velocity. The same command resumes. --velocity-mps is the first shot.\n",
      .usage = "[options]",
      .examples = "  ogive limit --thickness-mm 8 --spacing-mm 1\n"
                  "  ogive limit --material aa5083_h116 --nose conical --thickness-mm 15 --width-mps 2\n",
      .more = exit_statuses,
      .config = true};
  const auto line = options::read_command_line(command, table, arguments, std::cout);
  if (!line) return options::success;
  options::Origins origins;
  for (const options::Given &given : line->given) options::apply(table, origins, given);

  shot::Options o = shot::settled(shot::levels_of(*line));
  if (o.out == shot::default_out(o)) {
    shot::Options any = o;
    any.velocity_mps = -1;
    o.out = shot::default_out(any).string() + "_limit";
  }
  const study::Study study = study::study_of(l.study, o.out);
  if (study.shards > 1) options::refuse("--shard", l.study.shard, "must be 1/1: one limit has no parts");
  study::Series series = study::series_of(study::case_of(o, {}, ""));
  series.published = {};
  series.guess_mps = line->find("velocity_mps") != nullptr ? o.velocity_mps : study::guess_mps(o);
  int status = study::run_study(
      "ogive limit", study, l.study.run, {}, {series}, l.width_mps, [] {},
      "Ballistic limit within " + options::shortest(l.width_mps / 2) + " m/s, " + o.out.string() + ", method " +
          shot::name_of(o.method));
  const auto rows = [&] { return study::read_all_rows(o.out, {}); };
  auto limits = study::limits_in({series}, rows());
  if (status != options::success || limits.empty()) return status;
  if (const auto estimate = ogive::limit_estimate(limits.front().bracket)) {
    std::printf("\n  %-22s %.1f +- %.1f m/s%s\n\n", "limit by bisection", estimate->limit, estimate->half_width,
                limits.front().bracket.consistent ? "" : "; shots above it were stopped, too");
    std::fflush(stdout);
    status = study::run_study("ogive limit", study, l.study.run, curve_above(series, estimate->limit), {}, 0, [] {});
    if (status != options::success) return status;
  } else {
    std::printf("\n  no limit: %s\n",
                limits.front().bracket.lowest_perforated ? "all shots perforated" : "all shots were stopped");
  }
  limits = study::write_limits(o.out / "limits.csv", {series}, rows(), {});
  if (limits.front().fit) print_fit(*limits.front().fit);
  try {
    study::draw_residuals({"limit", "Residual velocity and ballistic limit"}, {series}, rows(), {}, o.out);
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "ogive limit: left out: %s\n", error.what());
  }
  std::printf("  %-22s %s\n", "files", (o.out / "shots.csv").c_str());
  return status;
}

} // namespace commands
