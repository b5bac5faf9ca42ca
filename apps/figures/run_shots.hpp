// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shot_row.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// \file
/// Runs the shots of a campaign with perforate, several at a time.

namespace figures {

/// A shot to be run.
struct Task {
  ShotKey key;
  double frames_us = 0; ///< time between frames for pictures; 0: none
};

/// Where and how shots are run.
struct Workshop {
  std::filesystem::path out;       ///< folder of the campaign: shots/ and the rows
  std::filesystem::path rows;      ///< file in it that takes the rows of this process
  std::filesystem::path perforate; ///< the program
  int jobs = 1;                    ///< shots at a time
  int threads = 1;                 ///< of each
};

/// What came of the tasks.
struct Outcome {
  int run = 0;                     ///< shots run now
  int known = 0;                   ///< shots that had been run before
  std::vector<std::string> failed; ///< a line for each shot that failed
  int stopped_by = 0;              ///< the signal that ended the work; 0: it is done
};

/// The folder of a shot.
std::filesystem::path folder_of(const Workshop &workshop, const ShotKey &key);

/// Runs those tasks of which no row is known yet (or no frames, where they are wanted), `workshop.jobs` at a time; each
/// row is on the disk when its shot ends. A shot that another process is running is waited for. `say` is told of each
/// shot that ends, in one line. A shot that fails leaves the others alone; SIGINT, SIGTERM and SIGHUP end them all.
/// Throws WriteError if the folder cannot be used and SetupError for damaged rows; no shot goes on then.
Outcome run_shots(const Workshop &workshop, const std::vector<Task> &tasks,
                  const std::function<void(const std::string &)> &say);

} // namespace figures
