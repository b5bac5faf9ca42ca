// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"

#include "shot/defaults.hpp"
#include "shot/table.hpp"
#include "study/cases.hpp"
#include "study/finish.hpp"
#include "study/plots.hpp"

#include "ogive/io/write_error.hpp"

#include <iostream>

namespace commands {

namespace {

struct SweepOptions {
  std::optional<std::string> cases;
  std::vector<std::string> vary;
  bool limit = false;
  double width_mps = 5;
  study::StudyOptions study;
};

// clang-format off
options::Table table_of(shot::Options &o, SweepOptions &s) {
  options::Table t;
  t.group = "Study";
  options::add(t, s.cases, {.key = "cases",
      .meaning = "a list: columns are names of options (thickness_mm), each row is a case; columns name and text "
      "are notes", .source = "none: one case", .brief = "a list of cases: columns are names of options",
      .allowed = "the name of a CSV file", .in_file = false}).placeholder = "CASES.csv";
  options::add(t, s.vary, {.key = "vary",
      .meaning = "NAME=VALUE,VALUE,... or NAME=FIRST:LAST:STEP: every case with each of these values; several "
      "--vary give all combinations", .source = "none: ours",
      .brief = "NAME=VALUE,VALUE,... or NAME=FIRST:LAST:STEP, may be repeated",
      .allowed = "NAME=VALUE,VALUE,... or NAME=FIRST:LAST:STEP", .in_file = false}).placeholder = "NAME=LIST...";
  options::add(t, s.limit, {.key = "limit", .meaning = "find the ballistic limit of each case instead of one shot",
      .source = "no: ours", .brief = "find the ballistic limit of each case instead of one shot", .in_file = false});
  options::add(t, s.width_mps, {.key = "width_mps",
      .meaning = "largest width of the bracket of a limit", .source = "ours",
      .limits = {0.1, 500, "m/s"}, .in_file = false});
  study::add_study_options(t, s.study);
  for (options::Option option : shot::table_of(o).options) {
    if (option.key != std::string_view("out") && option.key != std::string_view("material")) option.brief = "";
    t.options.push_back(option);
  }
  return t;
}
// clang-format on

/// Columns of the list that differ between cases: what a reader wants to see beside the result.
std::vector<std::size_t> varied_columns(const std::vector<study::Case> &cases) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < cases.front().key.values.size(); ++k)
    if (k >= study::key_columns().size() || std::any_of(cases.begin(), cases.end(), [&](const study::Case &c) {
          return c.key.values[k] != cases.front().key.values[k];
        }))
      columns.push_back(k);
  return columns;
}

void print_shots(const study::CaseList &list, const std::vector<study::Row> &rows) {
  const auto columns = varied_columns(list.cases);
  std::printf("\n");
  for (const std::size_t k : columns) std::printf("  %-20s", study::column_name(k, list.own_columns).c_str());
  std::printf("  %-12s  %-14s  %s\n", "perforated", "residual, m/s", "energy error, %");
  for (const study::Case &one : list.cases) {
    const study::Row *row = study::find_row(rows, one.key);
    if (row == nullptr) continue;
    for (const std::size_t k : columns) std::printf("  %-20s", one.key.values[k].c_str());
    const double error = 100 * study::number(*row, "energy_error");
    if (study::is_undecided(*row))
      std::printf("  %-12s  %-14s  %.4f\n", "undecided", "", error);
    else
      std::printf("  %-12s  %-14.1f  %.4f\n", study::number(*row, "perforated") != 0 ? "yes" : "no",
                  study::number(*row, "residual_velocity_mps"), error);
  }
}

void draw(const study::CaseList &list, const std::vector<study::Series> &series, bool limit,
          const std::filesystem::path &out) {
  const auto rows = study::read_all_rows(out, list.own_columns);
  bool drawn = false;
  try {
    if (limit) {
      const auto limits = study::write_limits(out / "limits.csv", series, rows, list.own_columns);
      drawn = study::draw_limits({"sweep", "Ballistic limits"}, limits, list.own_columns, out);
    } else {
      print_shots(list, rows);
      drawn = study::draw_residuals({"sweep", "Residual velocities"}, study::series_in(list.cases), rows,
                                    list.own_columns, out);
    }
  } catch (const ogive::WriteError &error) {
    std::fprintf(stderr, "ogive sweep: left out: %s\n", error.what());
  }
  std::printf("\n  %-22s %s\n", "rows", study::rows_shown(out).c_str());
  if (limit) std::printf("  %-22s %s\n", "limits", (out / "limits.csv").c_str());
  if (drawn) std::printf("  %-22s %s\n", "plot", (out / "sweep.svg").c_str());
}

} // namespace

options::Table sweep_table() { return unbound(table_of); }

int sweep(const options::Arguments &arguments) {
  shot::Options defaults;
  SweepOptions s;
  const options::Table table = table_of(defaults, s);
  const options::Command command{
      .name = "ogive sweep",
      .purpose = "Runs the cases of a list, or every combination of varied options, several at a time; with --limit\n"
                 "their ballistic limits. Ends with a table, OUT/shots.csv and a plot. Cases that have a row are not\n"
                 "run again; the same command resumes. Options of ogive shoot apply to all cases.\n",
      .usage = "[CASES.csv] [--vary NAME=LIST]... --out FOLDER [options]",
      .examples = "  ogive sweep --vary thickness_mm=6,8,10 --vary velocity_mps=200:400:25 --out thickness\n"
                  "  ogive sweep my_cases.csv --spacing-mm 1 --out my_study\n"
                  "  ogive sweep --vary nose=blunt,conical --limit --shard 2/4 --out noses\n",
      .more = exit_statuses,
      .config = true,
      .positional = "cases"};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return options::only_printed;
  if (line->find("out") == nullptr) throw ogive::SetupError("--out: is required: the folder of the study");
  if (!s.cases && s.vary.empty()) throw ogive::SetupError("CASES.csv, --vary: one of them is required");

  auto levels = shot::levels_of(*line);
  // Results of one shot hold no other files unless the user wants them.
  if (line->find("vtk") == nullptr && line->find("output_every_us") == nullptr)
    levels.front().given.insert(levels.front().given.begin(), {"vtk", "ogive sweep", "false"});
  const study::CaseList list = study::cases_of(levels, s.cases, s.vary);
  study::Study study = study::study_of(s.study, defaults.out);
  study.own_columns = list.own_columns;
  study.threads = defaults.threads;
  const auto series = s.limit ? study::series_in(list.cases) : std::vector<study::Series>{};
  const auto run = [&](const study::Report &report) {
    std::vector<shot::Options> cases;
    for (const study::Case &one : list.cases) cases.push_back(one.options);
    study::report_doubts(cases, report);
    return s.limit ? study::find_limits(study, study::share_of(series, study), s.width_mps, report)
                   : study::run_cases(study, study::share_of(list.cases, study), report);
  };
  return study::run_study("ogive sweep", study, s.study.run, run, [&] { draw(list, series, s.limit, defaults.out); });
}

} // namespace commands
