// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shot.hpp"

#include "shared/exit_status.hpp"

/// \file
/// One case from its options to its results, as the program runs it.

namespace perforate {

using input::not_finished;
using input::success;

/// The exit status of a run that a signal interrupted, less the number of the signal.
constexpr int interrupted = 128;

/// How much of a run is printed and drawn.
enum class Telling {
  all,     ///< what is about to be run, the closing table, the section picture
  problems ///< only why it did not come to its end
};

/// How a case ended.
struct Outcome {
  int status = success;
  Shot shot;
};

/// Runs a case and writes its results. `program` is its name in the command that goes on with an interrupted run.
/// Throws SetupError, and then nothing was run or overwritten.
Outcome run_case(const Options &options, const char *program, Telling telling);

} // namespace perforate
