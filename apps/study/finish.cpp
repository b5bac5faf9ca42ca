// SPDX-License-Identifier: BSD-3-Clause
#include "finish.hpp"

#include "lock.hpp"
#include "options/exit_status.hpp"
#include "options/out_folder.hpp"
#include "shot/run.hpp"
#include "shot/signals.hpp"

#include "ogive/io/atomic_file.hpp"

#include <cstdio>

namespace study {

namespace {

void say(const std::string &line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

} // namespace

int run_study(const char *program, const Study &study, bool runs, const std::vector<Case> &cases,
              const std::vector<Series> &series, double width_mps, const std::function<void()> &draw,
              const std::string &title) {
  Outcome all;
  if (runs) {
    constexpr double bytes = 64e6; // of a shot with frames or of a checkpoint
    options::prepare_out(study.out, bytes, "");
    const StudyLock lock(study);
    if (!title.empty()) say(title);
    const shot::SignalCatcher catcher;
    all = run_cases(study, cases, say);
    if (all.stopped_by == 0 && !series.empty()) {
      const Outcome limits = find_limits(study, series, width_mps, say);
      all.run += limits.run, all.stopped_by = limits.stopped_by;
      all.failed.insert(all.failed.end(), limits.failed.begin(), limits.failed.end());
    }
    std::printf("%d shots run, %d known before, %zu failed\n", all.run, all.known, all.failed.size());
    std::fflush(stdout);
    for (const std::string &line : all.failed) std::fprintf(stderr, "%s: failed: %s\n", program, line.c_str());
  }
  if (all.stopped_by != 0) {
    std::fprintf(stderr, "%s: stopped by %s; the same command resumes\n", program,
                 shot::signal_name(all.stopped_by).c_str());
    return shot::interrupted + all.stopped_by;
  }
  if (study.shards == 1) draw();
  return all.failed.empty() ? options::success : options::not_finished;
}

std::vector<LimitRow> write_limits(const std::filesystem::path &file, const std::vector<Series> &series,
                                   const std::vector<Row> &rows, const std::vector<std::string> &own_columns) {
  auto limits = limits_in(series, rows);
  for (const LimitRow &row : limits) say(described(row));
  if (!limits.empty()) ogive::write_atomically(file, limits_csv(limits, own_columns));
  return limits;
}

} // namespace study
