// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

/// \file
/// Programs that run beside this one, and the signals that end them with it.

namespace figures {

/// As long as it lives, SIGINT, SIGTERM and SIGHUP do not end this process but are told by wait(), so that it can end
/// its children first. Those that were ignored stay ignored.
struct HeldSignals {
  sigset_t held{};
  sigset_t before{}; ///< mask that children start with
  struct sigaction child_before {};

  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals &) = delete;
  HeldSignals &operator=(const HeldSignals &) = delete;

  /// Sleeps until a child ends, a signal comes or the time (s, if any) is up. Returns the signal, else 0. What happened
  /// before the call ends it at once.
  int wait(std::optional<long> seconds) const;
};

/// Starts a program with its output in `log`; returns its process, -1 if there can be none. A program that cannot be
/// started says so in the log and ends with status 127. The kernel kills it if this process ends without having done
/// so. To be called from the main thread.
pid_t start(std::vector<std::string> arguments, const std::filesystem::path &log, const HeldSignals &signals);

/// The status of a child (as waitpid tells it) once it has ended.
std::optional<int> status_of(pid_t child);

/// How a process ended, in words.
std::string ending(int status);

} // namespace figures
