// SPDX-License-Identifier: BSD-3-Clause
#include "study.hpp"

#include "shot/plates.hpp"
#include "shot/report.hpp"
#include "shot/resume.hpp"
#include "shot/run.hpp"
#include "shot/signals.hpp"

#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"

#include <nlohmann/json.hpp>
#include <omp.h>

#include <mutex>
#include <set>
#include <system_error>
#include <thread>

namespace study {

namespace {

namespace fs = std::filesystem;

/// One call of run_chosen(). The mutex guards all below it.
struct Work {
  const Study &study;
  const Report &report;
  int threads = 1; ///< of each shot
  std::mutex mutex{};
  const NextCase &next;
  std::vector<Row> rows{};
  Outcome outcome{};
};

/// Whether the frames that a case writes are there. Their list grows with them, also in a run that is then killed; the
/// summary is written last.
bool has_frames(const Study &study, const Case &shot) {
  const fs::path folder = folder_of(study, shot);
  std::error_code none;
  return !shot.options.vtk ||
         (fs::exists(folder / "summary.json", none) && fs::exists(folder / "perforation.pvd", none));
}

bool is_known(const Study &study, const Case &shot, const std::vector<Row> &rows) {
  const Row *row = find_row(rows, shot.key);
  return row != nullptr && is_final(*row, shot) && has_frames(study, shot);
}

/// Adds the row unless it is there, and reports it.
void keep(Work &w, const Case &shot, const Row &row) {
  const auto same = [&](const Row &other) { return other.key == shot.key; };
  const auto earlier = std::find_if(w.rows.begin(), w.rows.end(), same);
  if (earlier == w.rows.end() || is_undecided(*earlier)) {
    append_row(rows_file(w.study), row, w.study.own_columns);
    if (earlier != w.rows.end()) w.rows.erase(earlier);
    w.rows.push_back(row);
  }
  const std::string residual =
      is_undecided(row) ? "undecided" : options::printed("%.1f m/s", number(row, "residual_velocity_mps"));
  w.report(options::printed("%.180s: %s, %.0f s, energy error %.3f %%", shot.name.c_str(), residual.c_str(),
                            number(row, "wall_s"), 100 * number(row, "energy_error")));
}

/// The row that an earlier run of this very case left without a line in the file.
std::optional<Row> earlier_row(const Study &study, const Case &shot) {
  try {
    const fs::path folder = folder_of(study, shot);
    if (!shot::other_case(shot.options) || !has_frames(study, shot)) return std::nullopt;
    const Row row = row_of(shot.key, read_summary(folder), (folder / "summary.json").string());
    return is_final(row, shot) ? std::optional(row) : std::nullopt;
  } catch (const ogive::SetupError &) {
    return std::nullopt; // no summary, or one of a run that a fault ended
  }
}

/// Runs one case, or finds that it needs no run. Throws where it fails.
void run_case(Work &w, const Case &shot) {
  std::unique_lock lock(w.mutex);
  const bool known = is_known(w.study, shot, w.rows);
  lock.unlock();
  if (const std::string reason = conflict(w.study, shot); !reason.empty()) throw ogive::SetupError(reason);
  std::optional<Row> row = known ? std::nullopt : earlier_row(w.study, shot);
  const bool runs = !known && !row;
  if (runs) {
    const shot::Outcome outcome = shot::run(shot::resumed(shot.options).options, shot::Output::none);
    if (outcome.shot.interrupted_by != 0) return;
    if (outcome.status != options::success) throw ogive::SetupError(outcome.problem);
    row = row_of(shot.key, shot::summary_of(shot.options, outcome.shot), shot.name);
  }
  lock.lock();
  if (row) keep(w, shot, *row);
  ++(runs ? w.outcome.run : w.outcome.known);
}

/// The next case with its folder, to be run without files that a study has no use for.
std::optional<Case> next_case(Work &w) {
  const std::lock_guard lock(w.mutex);
  if (shot::caught_signal() != 0) return std::nullopt;
  auto shot = w.next(w.rows);
  if (shot) {
    shot->options.out = folder_of(w.study, *shot);
    shot->options.threads.reset();
    shot->options.picture = false;
    shot->options.quiet = true;
  }
  return shot;
}

/// Runs one case after another.
void work(Work &w) {
  omp_set_num_threads(w.threads);
  const auto note_failure = [&](const std::string &text) {
    const std::lock_guard lock(w.mutex);
    w.outcome.failed.push_back(text);
    w.report("failed: " + text);
  };
  for (;;) {
    std::optional<Case> shot;
    try {
      shot = next_case(w);
      if (!shot) return;
      run_case(w, *shot);
    } catch (const std::exception &error) {
      note_failure(shot ? shot->name + ": " + error.what() : error.what());
      // Without a next case there is nothing else to do.
      if (!shot) return;
    }
  }
}

} // namespace

bool is_final(const Row &row, const Case &shot) {
  return !is_undecided(row) || number(row, "simulated_us") >= shot.options.end_us * (1 - 1e-9);
}

void add(Outcome &all, const Outcome &more) {
  all.run += more.run;
  all.failed.insert(all.failed.end(), more.failed.begin(), more.failed.end());
  if (all.stopped_by == 0) all.stopped_by = more.stopped_by;
}

int threads_of(const Study &study, int workers) {
  return study.threads.value_or(std::max(1, study.cores.value_or(cores()) / std::max(1, workers)));
}

int cores() { return std::max(1, omp_get_num_procs()); }

std::string folder_name(const Key &key, const Texts &own_columns) {
  const auto &v = key.values;
  std::string name = v[method_column] + "_" + v[model_column] + "_" + fs::path(v[material_column]).stem().string() +
                     "_" + v[nose_column] + "_" + v[thickness_column] + "mm_" + v[velocity_column] + "mps_" +
                     v[spacing_column] + "mm";
  for (std::size_t k = key_columns().size(); k < v.size(); ++k) name += "_" + column_name(k, own_columns) + "=" + v[k];
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

Case case_of(const shot::Options &options, const Texts &own_columns, const std::string &name) {
  Case shot{options, name, key_of(options, own_columns)};
  if (name.empty()) shot.name = folder_name(shot.key, own_columns);
  return shot;
}

fs::path folder_of(const Study &study, const Case &shot) { return study.out / "shots" / shot.name; }

std::string conflict(const Study &study, const Case &shot) {
  shot::Options options = shot.options;
  options.out = folder_of(study, shot);
  const auto other = shot::other_case(options);
  std::error_code none;
  if (!other && fs::exists(options.out / "case.toml", none))
    return (options.out / "case.toml").string() +
           " cannot be read, perhaps it is of another version; give another --out "
           "or remove the folder";
  if (!other || other->empty()) return "";
  return "the results in " + options.out.string() + " are of a case with another " + *other +
         "; give another --out or remove them";
}

fs::path rows_file(const Study &study) {
  const std::string part =
      study.shards > 1 ? "." + std::to_string(study.shard) + "-of-" + std::to_string(study.shards) : "";
  return study.out / ("shots" + part + ".csv");
}

void report_doubts(const std::vector<shot::Options> &cases, const Report &report) {
  std::set<std::string> all;
  for (const shot::Options &options : cases)
    for (const std::string &doubt : shot::doubts_of(options, shot::plates_of(options)))
      if (all.insert(doubt).second) report("warning: " + doubt);
}

Outcome run_cases(const Study &study, const std::vector<Case> &cases, const Report &report) {
  const auto rows = read_all_rows(study.out, study.own_columns);
  const auto missing =
      std::count_if(cases.begin(), cases.end(), [&](const Case &shot) { return !is_known(study, shot, rows); });
  std::size_t next = 0;
  const auto in_order = [&](const std::vector<Row> &) -> std::optional<Case> {
    if (next == cases.size()) return std::nullopt;
    return cases[next++];
  };
  return run_chosen(study, static_cast<std::size_t>(missing), in_order, report);
}

Outcome run_chosen(const Study &study, std::size_t at_once, const NextCase &next, const Report &report) {
  std::error_code code;
  fs::create_directories(study.out / "shots", code);
  if (code) throw ogive::write_error(study.out / "shots", code.message());
  const int workers = static_cast<int>(std::clamp<std::size_t>(at_once, 1, static_cast<std::size_t>(study.jobs)));
  Work w{.study = study, .report = report, .threads = threads_of(study, workers), .next = next};
  w.rows = read_all_rows(study.out, study.own_columns);
  {
    std::vector<std::jthread> threads;
    try {
      for (int k = 0; k < workers; ++k) threads.emplace_back([&w] { work(w); });
    } catch (const std::system_error &error) {
      if (threads.empty())
        options::refuse("--jobs", std::to_string(study.jobs), "no thread can be started: " + error.code().message());
      // Those that could be started do all the work.
    }
  }
  w.outcome.stopped_by = shot::caught_signal();
  return w.outcome;
}

} // namespace study
