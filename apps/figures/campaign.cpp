// SPDX-License-Identifier: BSD-3-Clause
#include "campaign.hpp"

#include "plots.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"
#include "shared/command_line.hpp"
#include "shared/exit_status.hpp"
#include "shared/experiment.hpp"
#include "shared/out_folder.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <set>

namespace figures {

namespace {

namespace fs = std::filesystem;
using input::Given;
using input::refuse;
using input::success;

constexpr input::Limits spacing_limits{0.05, 5, "mm"};

/// Those that this process may use: on a cluster, few of many.
int cores() { return std::max(1, omp_get_num_procs()); }

std::string figures_of(const Campaign &campaign) {
  std::string text;
  for (const int figure : campaign.figures) text += (text.empty() ? "" : ", ") + std::to_string(figure);
  return text;
}

std::vector<input::Flag> flags(const Campaign &campaign) {
  using input::Flag;
  return {{"figure", "one of " + figures_of(campaign)},
          {"quick", "", Flag::none},
          {"method", "sfm, stabilised or adaptive"},
          {"model", "mjc, jc or both"},
          {"spacing_mm", "a number between " + text_of(spacing_limits)},
          {"jobs", "a whole number from 1"},
          {"shard", "I/N"},
          {"run", "", Flag::none},
          {"limits", "", Flag::none},
          {"pictures", "", Flag::none},
          {"out", "the name of a folder"},
          {"perforate", "the name of a program"}};
}

std::string help(const Campaign &campaign) {
  const auto item = [](const char *key, const std::string &text) {
    return input::help_item(input::flag_of(key), text);
  };
  return campaign.name + ": " + campaign.purpose +
         "\nShots that have a row in OUT/shots*.csv are not run again; one that was stopped "
         "goes on from its checkpoint.\n\n" +
         item("figure N", "this one alone, of " + figures_of(campaign)) +
         item("quick", "coarse: particles 1.5 mm apart, in vtk_out/figures_quick") +
         item("method sfm|stabilised|adaptive",
              "of perforate; adds its curves to the plots, with mjc only [sfm: the paper's]") +
         item("model mjc|jc|both", "flow stress; pictures have mjc only [both]") +
         item("spacing_mm NUMBER",
              "particle distance, " + text_of(spacing_limits, " to ") + " [0.6, as in the paper]") +
         item("jobs NUMBER", "shots at a time; they share the cores [as many as cores]") +
         item("shard I/N",
              "run only the I-th of N parts, for several machines: the shots of a plate, nose and law stay "
              "together; draws nothing") +
         item("no_run", "only draw what is known") + item("no_limits", "without bisection of the ballistic limits") +
         item("no_pictures", "without the shots that are for pictures alone, and without frames") +
         item("out FOLDER", "for rows, shots and pictures; programs and shards may share it [vtk_out/figures]") +
         item("perforate PROGRAM", "that runs a shot [the one beside this program]");
}

int whole_number(const Given &given, int low, int high) {
  const auto number = input::number_given(given);
  if (!number || *number != std::floor(*number) || *number < low || *number > high)
    refuse(given, "must be a whole number between " + std::to_string(low) + " and " + std::to_string(high));
  return static_cast<int>(*number);
}

void apply(Options &o, const Campaign &campaign, const Given &given) {
  if (given.key == "figure") {
    o.figure = whole_number(given, 1, 99);
    if (std::find(campaign.figures.begin(), campaign.figures.end(), *o.figure) == campaign.figures.end())
      refuse(given, "must be one of " + figures_of(campaign));
  }
  if (given.key == "quick") o.quick = input::truth_given(given);
  if (given.key == "run") o.run = input::truth_given(given);
  if (given.key == "limits") o.limits = input::truth_given(given);
  if (given.key == "pictures") o.pictures = input::truth_given(given);
  if (given.key == "spacing_mm") o.spacing_mm = input::number_within(given, spacing_limits);
  if (given.key == "jobs") o.jobs = whole_number(given, 1, 1000);
  if (given.key == "out") o.out = input::line_given(given, "the name of a folder");
  if (given.key == "perforate") o.perforate = input::line_given(given, "the name of a program");
  if (given.key == "method") {
    o.method = given.value;
    if (std::find(methods.begin(), methods.end(), o.method) == methods.end())
      refuse(given, "must be one of sfm, stabilised, adaptive");
  }
  if (given.key == "model") {
    o.model = given.value;
    if (o.model != "mjc" && o.model != "jc" && o.model != "both") refuse(given, "must be mjc, jc or both");
  }
  if (given.key == "shard") {
    const std::size_t slash = given.value.find('/');
    const auto part = ogive::number_from(given.value.substr(0, slash));
    const auto parts = slash == std::string::npos ? std::nullopt : ogive::number_from(given.value.substr(slash + 1));
    if (!part || !parts || *part != std::floor(*part) || *parts != std::floor(*parts) || *part < 1 || *part > *parts ||
        *parts > 10000)
      refuse(given, "must be I/N with whole numbers 1 <= I <= N");
    o.shard = static_cast<int>(*part), o.shards = static_cast<int>(*parts);
  }
}

/// Nothing if --help or --version was asked for and has been printed.
std::optional<Options> parse(const Campaign &campaign, int argc, const char *const *argv) {
  const auto line = input::read_command_line(campaign.name, flags(campaign), argc, argv);
  if (line.help) std::cout << help(campaign);
  if (line.version) std::cout << campaign.name << " " << ogive::version << "\n";
  if (line.help || line.version) return std::nullopt;
  if (line.config) refuse("--config", *line.config, "is not known here");
  Options o;
  o.jobs = cores();
  std::set<std::string> seen;
  for (const Given &given : line.given) apply(o, campaign, given), seen.insert(given.key);
  if (o.quick && !seen.contains("spacing_mm")) o.spacing_mm = 1.5;
  if (o.quick && !seen.contains("out")) o.out = "vtk_out/figures_quick";
  if (o.perforate.empty()) o.perforate = fs::read_symlink("/proc/self/exe").parent_path() / "perforate";
  std::error_code none;
  if (o.run && (!fs::is_regular_file(o.perforate, none) || ::access(o.perforate.c_str(), X_OK) != 0))
    refuse("--perforate", o.perforate.string(), "must be a program");
  return o;
}

/// Adds what is not yet in a list.
template <class T> void add_once(std::vector<T> &list, const T &value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

/// Runs tasks and adds what came of them to `all`.
void work(const Workshop &workshop, const std::vector<Task> &tasks, Outcome &all) {
  const Outcome now = run_shots(workshop, tasks, [](const std::string &line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  });
  all.run += now.run, all.known += now.known, all.stopped_by = now.stopped_by;
  all.failed.insert(all.failed.end(), now.failed.begin(), now.failed.end());
}

/// Runs what is missing, first the list and then round by round what bisection asks for.
Outcome run_all(const Campaign &campaign, const Options &o, const std::vector<ListedShot> &shots) {
  input::prepare_out(o.out, 64e6, "");
  const std::string part = o.shards > 1 ? "." + std::to_string(o.shard) + "-of-" + std::to_string(o.shards) : "";
  const Workshop workshop{o.out, o.out / ("shots" + part + ".csv"), fs::absolute(o.perforate), o.jobs,
                          std::max(1, cores() / o.jobs)};
  Outcome all;
  work(workshop, tasks_of(shots), all);
  for (auto series = series_in(shots); o.limits && all.stopped_by == 0;) {
    const auto round = next_round(series, read_all_rows(o.out), FIGURES_DATA_FOLDER);
    if (round.empty()) break;
    work(workshop, round, all);
    // A series whose shot failed has come to its end. In all others a row more is known: the rounds end.
    const auto rows = read_all_rows(o.out);
    for (const Task &task : round)
      if (find_row(rows, task.key) == nullptr) std::erase(series, series_of(task.key));
  }
  std::printf("%d shots run, %d known before, %zu failed\n", all.run, all.known, all.failed.size());
  std::fflush(stdout);
  for (const std::string &line : all.failed)
    std::fprintf(stderr, "%s: failed: %s\n", campaign.name.c_str(), line.c_str());
  return all;
}

/// Draws what is known.
void draw(const Campaign &campaign, const Options &o, const std::vector<SeriesKey> &series) {
  const fs::path data = FIGURES_DATA_FOLDER;
  const auto rows = read_all_rows(o.out);
  if (!o.run && rows.empty()) refuse("--out", o.out.string(), "must be a folder with shots*.csv where nothing is run");
  const auto limits = find_limits(series, rows, data);
  for (const LimitRow &row : limits) std::printf("%s\n", described(row).c_str());
  if (!limits.empty()) ogive::write_atomically(o.out / (campaign.name + "_limits.csv"), limits_csv(limits));
  for (const Plot &plot : campaign.plots) {
    if (o.figure && *o.figure != plot.figure) continue;
    if (draw_plot(plot, series, rows, limits, data, o.out))
      std::printf("figure %d: %s\n", plot.figure, (o.out / ("figure_" + std::to_string(plot.figure))).c_str());
  }
}

/// The series of the options' method, and those of other methods that have rows.
std::vector<SeriesKey> series_known(const Campaign &campaign, Options o) {
  const std::string run_method = o.method;
  const auto rows = read_all_rows(o.out);
  std::vector<SeriesKey> series;
  for (const char *method : methods) {
    o.method = method;
    if (o.method != run_method &&
        std::none_of(rows.begin(), rows.end(), [&](const ShotRow &row) { return row.key.method == o.method; }))
      continue;
    for (const SeriesKey &key : series_in(listed_shots(campaign, o, FIGURES_DATA_FOLDER))) series.push_back(key);
  }
  return series;
}

int run(const Campaign &campaign, const Options &o) {
  const auto shots = share_of(listed_shots(campaign, o, FIGURES_DATA_FOLDER), o);
  const Outcome outcome = o.run ? run_all(campaign, o, shots) : Outcome{};
  if (const int signal = outcome.stopped_by; signal != 0) {
    std::fprintf(stderr, "%s: stopped by signal %d (%s); the same command goes on with what is missing\n",
                 campaign.name.c_str(), signal, ::strsignal(signal));
    // Whoever started this, a shell or a script, is to see that it was the signal.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (o.shards == 1) draw(campaign, o, series_known(campaign, o));
  return outcome.failed.empty() ? success : input::not_finished;
}

} // namespace

std::vector<ListedShot> listed_shots(const Campaign &campaign, const Options &o, const fs::path &data) {
  const fs::path file = data / "figure_shots.csv";
  std::vector<ListedShot> shots;
  for (const char *model : {"mjc", "jc"}) {
    if (o.method != methods[0] ? model != std::string_view("mjc") : o.model != "both" && o.model != model) continue;
    for (const auto &row : experiment::read_rows(file)) {
      if (row.size() != 9) throw ogive::SetupError(file.string() + ": fields in a row: must be 9");
      const auto figure = ogive::number_from(row[0]), thickness = ogive::number_from(row[6]),
                 velocity = ogive::number_from(row[7]);
      if (!figure || !thickness || !velocity)
        throw ogive::SetupError(file.string() + ": figure, thickness_mm and initial_velocity_mps must be numbers");
      if (row[1] != campaign.name || (row[3] != "both" && row[3] != model)) continue;
      ListedShot shot{static_cast<int>(*figure), row[2] == "picture", {}};
      if (shot.picture && !o.pictures) continue;
      shot.task.key = {o.method, model, row[4], row[5], *thickness, *velocity, o.spacing_mm};
      if (o.pictures) shot.task.frames_us = ogive::number_from(row[8]).value_or(0);
      // Fig. 9 and 13 are the limits of the plates of Fig. 6 and 12.
      const bool limits_too = !shot.picture && o.figure &&
                              *o.figure == (shot.figure == 6    ? 9
                                            : shot.figure == 12 ? 13
                                                                : 0);
      if (!o.figure || *o.figure == shot.figure || limits_too) shots.push_back(shot);
    }
  }
  if (shots.empty()) throw ogive::SetupError(file.string() + ": has no shots for " + campaign.name);
  return shots;
}

std::vector<ListedShot> share_of(const std::vector<ListedShot> &shots, const Options &o) {
  std::vector<SeriesKey> series;
  for (const ListedShot &shot : shots) add_once(series, series_of(shot.task.key));
  std::vector<ListedShot> mine;
  for (const ListedShot &shot : shots) {
    const auto place = std::find(series.begin(), series.end(), series_of(shot.task.key)) - series.begin();
    if (place % o.shards == o.shard - 1) mine.push_back(shot);
  }
  return mine;
}

std::vector<Task> tasks_of(const std::vector<ListedShot> &shots) {
  std::vector<Task> tasks;
  for (const ListedShot &shot : shots) {
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const Task &task) { return task.key == shot.task.key; });
    if (found == tasks.end())
      tasks.push_back(shot.task);
    else if (shot.task.frames_us > 0)
      found->frames_us = found->frames_us > 0 ? std::min(found->frames_us, shot.task.frames_us) : shot.task.frames_us;
  }
  return tasks;
}

std::vector<SeriesKey> series_in(const std::vector<ListedShot> &shots) {
  std::vector<SeriesKey> series;
  for (const ListedShot &shot : shots)
    if (!shot.picture) add_once(series, series_of(shot.task.key));
  return series;
}

int run_campaign(const Campaign &campaign, int argc, const char *const *argv) {
  return input::run_main(campaign.name.c_str(), [&]() -> int {
    const auto options = parse(campaign, argc, argv);
    return options ? run(campaign, *options) : success;
  });
}

} // namespace figures
