// SPDX-License-Identifier: BSD-3-Clause
#include "finish.hpp"

#include "options/exit_status.hpp"
#include "options/out_folder.hpp"
#include "options/threads.hpp"
#include "shot/run.hpp"
#include "shot/signals.hpp"

#include "ogive/io/atomic_file.hpp"

namespace study {

namespace {

void say(const std::string &line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

} // namespace

StudyLock lock_study(const Study &study) {
  using options::FolderLock;
  const auto locked = [&](const std::string &name, FolderLock::Kind kind, const std::string &part) {
    return std::make_unique<FolderLock>(study.out / name, kind,
                                        "another process works on this study" + part +
                                            "; wait for its end, or give another folder");
  };
  StudyLock lock;
  if (study.shards == 1) {
    lock.push_back(locked(".lock", FolderLock::exclusive, ""));
    return lock;
  }
  lock.push_back(locked(".lock", FolderLock::shared, ", without --shard"));
  const std::string parts = ".lock_of_", own = parts + std::to_string(study.shards), shard = "_shard_";
  const std::string other_number = ", in another number of shards";
  lock.push_back(locked(own, FolderLock::shared, other_number));
  // Shards of another number overlap with this one.
  for (const auto &entry : std::filesystem::directory_iterator(study.out)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(parts) && name != own && name.find(shard) == std::string::npos)
      locked(name, FolderLock::exclusive, other_number);
  }
  lock.push_back(locked(own + shard + std::to_string(study.shard), FolderLock::exclusive, ", on the same shard"));
  return lock;
}

int run_study(const char *program, const Study &study, bool runs, const std::function<Outcome(const Report &)> &run,
              const std::function<void()> &draw) {
  if (!runs && read_all_rows(study.out, study.own_columns).empty())
    options::refuse("--out", study.out.string(), "must be a folder with shots*.csv where nothing is run");
  Outcome all;
  if (runs) {
    constexpr double bytes = 64e6; // of a shot with frames or of a checkpoint
    // Beside the threads of the shots, this one waits.
    options::require_threads(1 + study.jobs * threads_of(study, study.jobs), "threads of all --jobs",
                             "fewer --jobs or --threads");
    options::prepare_out(study.out, bytes, "");
    const StudyLock lock = lock_study(study);
    const shot::SignalCatcher catcher;
    all = run(say);
    const std::string known = all.known == 0 ? "" : options::printed("%d known before, ", all.known);
    say(options::printed("%d shot%s run, %s%zu failed", all.run, all.run == 1 ? "" : "s", known.c_str(),
                         all.failed.size()));
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

std::string rows_shown(const std::filesystem::path &out) {
  std::error_code none;
  return (out / (std::filesystem::exists(out / "shots.csv", none) ? "shots.csv" : "shots*.csv")).string();
}

std::vector<LimitRow> write_limits(const std::filesystem::path &file, const std::vector<Series> &series,
                                   const std::vector<Row> &rows, const Texts &own_columns) {
  auto limits = limits_in(series, rows);
  for (const LimitRow &row : limits) say(described(row, own_columns));
  if (!limits.empty()) ogive::write_atomically(file, limits_csv(limits, own_columns));
  return limits;
}

} // namespace study
