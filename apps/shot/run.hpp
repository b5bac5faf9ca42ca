// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "result.hpp"

#include "options/exit_status.hpp"

/// \file
/// One case from its options to its results, as the program runs it.

namespace shot {

using options::not_finished;
using options::success;

/// The exit status of a run that a signal interrupted, less the number of the signal.
constexpr int interrupted = 128;

/// Extent of the output of a run.
enum class Output {
  all, ///< the case, the closing table, pictures, and the reason for an early end
  none
};

/// End of a case.
struct Outcome {
  int status = success;
  Result shot;
  std::string problem{}; ///< reason for an early end, one line
};

/// Runs a case and writes its results. Throws SetupError, and then nothing was run or overwritten.
Outcome run(const Options &options, Output output);

/// Gives OpenMP the threads of the options. Throws SetupError where so many cannot be started.
void use_threads(const Options &options);

/// Creates the folder `options.out` and proves with a small file of its own, removed at once, that it can be written to
/// and has room for the run. Leaves what is there untouched. Throws SetupError, one line, and then leaves no new folder
/// behind.
void prepare_out(const Options &options);

/// Why a result is doubtful, a line for each reason: much of the projectile has been removed, or particles are in it.
std::vector<std::string> doubts_of(const Result &shot);

/// The command that resumes a run, as a shell takes it.
std::string restart_command(const std::filesystem::path &checkpoint);

} // namespace shot
