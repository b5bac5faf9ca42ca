// SPDX-License-Identifier: BSD-3-Clause
#include "study.hpp"

#include "shot/report.hpp"
#include "shot/resume.hpp"
#include "shot/run.hpp"
#include "shot/signals.hpp"

#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"

#include <nlohmann/json.hpp>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <mutex>
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
  return find_row(rows, shot.key) != nullptr && has_frames(study, shot);
}

void keep(Work &w, const Case &shot, const Row &row) {
  const std::lock_guard lock(w.mutex);
  if (find_row(w.rows, shot.key) == nullptr) {
    append_row(rows_file(w.study), row, w.study.own_columns);
    w.rows.push_back(row);
  }
  using ogive::with_decimals;
  w.report(shot.name.substr(0, 180) + ": " + with_decimals(number(row, "residual_velocity_mps"), 1) + " m/s, " +
           with_decimals(number(row, "wall_s"), 0) + " s, energy error " +
           with_decimals(100 * number(row, "energy_error"), 3) + " %");
}

void note_failure(Work &w, const Case &shot, const std::string &reason) {
  const std::lock_guard lock(w.mutex);
  w.outcome.failed.push_back(shot.name + ": " + reason);
  w.report("failed: " + w.outcome.failed.back());
}

/// The row that an earlier run of this very case left without a line in the file; false if there is none.
bool keeps_earlier_row(Work &w, const Case &shot) {
  try {
    if (!has_frames(w.study, shot)) return false;
    const fs::path folder = folder_of(w.study, shot);
    keep(w, shot, row_of(shot.key, read_summary(folder), (folder / "summary.json").string()));
    return true;
  } catch (const ogive::SetupError &) {
    return false; // no summary, or one of a run that a fault ended
  }
}

/// Runs one case, or finds that it needs no run.
void run_case(Work &w, const Case &shot) {
  const bool known = [&] {
    const std::lock_guard lock(w.mutex);
    return is_known(w.study, shot, w.rows);
  }();
  if (const std::string reason = conflict(w.study, shot); !reason.empty()) return note_failure(w, shot, reason);
  if (known || (shot::other_case(shot.options) && keeps_earlier_row(w, shot))) {
    const std::lock_guard lock(w.mutex);
    ++w.outcome.known;
    return;
  }
  const shot::Outcome outcome = shot::run(shot::resumed(shot.options), shot::Output::none);
  if (outcome.shot.interrupted_by != 0) return;
  if (outcome.status != options::success) return note_failure(w, shot, outcome.problem);
  keep(w, shot, row_of(shot.key, shot::summary_of(shot.options, outcome.shot), shot.name));
  const std::lock_guard lock(w.mutex);
  ++w.outcome.run;
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
  while (const auto shot = next_case(w)) {
    try {
      run_case(w, *shot);
    } catch (const std::exception &error) {
      note_failure(w, *shot, error.what());
    }
  }
}

} // namespace

void add(Outcome &all, const Outcome &more) {
  all.run += more.run;
  all.failed.insert(all.failed.end(), more.failed.begin(), more.failed.end());
  if (all.stopped_by == 0) all.stopped_by = more.stopped_by;
}

int threads_of(const Study &study, int workers) {
  return study.threads.value_or(std::max(1, cores() / std::max(1, workers)));
}

int cores() { return std::max(1, omp_get_num_procs()); }

std::string folder_name(const Key &key, const std::vector<std::string> &own_columns) {
  const auto &v = key.values;
  std::string name = (v[method_column] == "sfm" ? "" : v[method_column] + "_") + v[model_column] + "_" +
                     fs::path(v[material_column]).stem().string() + "_" + v[nose_column] + "_" + v[thickness_column] +
                     "mm_" + v[velocity_column] + "mps_" + v[spacing_column] + "mm";
  for (std::size_t k = 0; k < own_columns.size(); ++k) name += "_" + own_columns[k] + "=" + v[key_columns().size() + k];
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

Case case_of(const shot::Options &options, const std::vector<std::string> &own_columns, const std::string &name) {
  Case shot{options, name, key_of(options, own_columns)};
  if (name.empty()) shot.name = folder_name(shot.key, own_columns);
  return shot;
}

fs::path folder_of(const Study &study, const Case &shot) { return study.out / "shots" / shot.name; }

std::string conflict(const Study &study, const Case &shot) {
  shot::Options options = shot.options;
  options.out = folder_of(study, shot);
  const auto other = shot::other_case(options);
  if (!other || other->empty()) return "";
  return "the results in " + options.out.string() + " are of a case with another " + *other +
         "; give another --out or remove them";
}

fs::path rows_file(const Study &study) {
  const std::string part =
      study.shards > 1 ? "." + std::to_string(study.shard) + "-of-" + std::to_string(study.shards) : "";
  return study.out / ("shots" + part + ".csv");
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
  std::error_code error;
  fs::create_directories(study.out / "shots", error);
  if (error) throw ogive::write_error(study.out / "shots", error.message());
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
