// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

#include "options/folder_lock.hpp"

#include <memory>

/// \file
/// Steps of all programs that run a study: lock it, run it, report, end.

namespace study {

/// Locks that keep other processes from a study as long as they exist.
using StudyLock = std::vector<std::unique_ptr<options::FolderLock>>;

/// Locks a study, or the study's shard: processes may work on different shards if the number of shards is the same.
/// Throws SetupError if another process is at work, WriteError if there can be no such files.
[[nodiscard]] StudyLock lock_study(const Study &study);

/// Runs the shots of a study, unless `runs` is false, and draws unless the study is a shard. `run` runs the shots and
/// passes the report on. Prints a line for each shot and a sum, and each failure on standard error. Returns the exit
/// status: 0, 3 if a shot failed, 128 + the signal that ended the work. Throws SetupError if another process has the
/// study, or if nothing is run and there are no rows.
int run_study(const char *program, const Study &study, bool runs, const std::function<Outcome(const Report &)> &run,
              const std::function<void()> &draw);

/// The name of the files with rows, for a user.
std::string rows_shown(const std::filesystem::path &out);

/// Prints the limits that the rows give and writes them to `file`, if there are any. Throws WriteError.
std::vector<LimitRow> write_limits(const std::filesystem::path &file, const std::vector<Series> &series,
                                   const std::vector<Row> &rows, const Texts &own_columns);

} // namespace study
