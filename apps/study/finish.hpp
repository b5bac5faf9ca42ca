// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

#include <functional>
#include <string>

/// \file
/// What all programs that run a study do: run it, report, end.

namespace study {

/// Runs the cases and then the limits of the series, unless `runs` is false, and draws unless the study is a shard.
/// Prints `title`, if any, once the folder can be used, a line for each shot and a sum, and each failure on standard
/// error. Returns the exit status: 0, 3 if a shot failed, 128 + the signal that ended the work. Throws SetupError if
/// another process has the study.
int run_study(const char *program, const Study &study, bool runs, const std::vector<Case> &cases,
              const std::vector<Series> &series, double width_mps, const std::function<void()> &draw,
              const std::string &title = "");

/// Prints the limits that the rows give and writes them to `file`, if there are any. Throws WriteError.
std::vector<LimitRow> write_limits(const std::filesystem::path &file, const std::vector<Series> &series,
                                   const std::vector<Row> &rows, const std::vector<std::string> &own_columns);

} // namespace study
