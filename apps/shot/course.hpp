// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "result.hpp"

#include "ogive/io/archive.hpp"

#include <string>
#include <vector>

/// \file
/// Findings and files of a run so far. Together with the model they suffice to resume it.

namespace shot {

/// A file of a frame, as the .pvd lists it.
struct FrameFile {
  double time = 0; ///< s
  int part = 0;
  std::string part_name;
  std::string file;
};

/// Files of a run so far, and reference values of its energy and momentum.
struct Course {
  double first_energy = 0;   ///< J
  double first_momentum = 0; ///< N s
  double next_frame_us = 0;
  double last_frame_us = -1;
  double frame_interval_us = 0;
  double wall_s = 0;    ///< of all parts of the run
  double cpu_s = 0;     ///< processor time of all threads and parts
  double writing_s = 0; ///< of that, spent on files
  int frames = 0;
  std::vector<FrameFile> frame_files;
  std::vector<double> history; ///< rows of history.csv, one after another
};

/// Calls `f(value)` for each value of a file of a frame.
template <class F> void for_each_field(FrameFile &file, F &&f) {
  f(file.time), f(file.part), f(file.part_name), f(file.file);
}

/// Calls `f(value)` for each value of a course.
template <class F> void for_each_field(Course &c, F &&f) {
  f(c.first_energy), f(c.first_momentum), f(c.next_frame_us), f(c.last_frame_us), f(c.frame_interval_us);
  f(c.wall_s), f(c.cpu_s), f(c.writing_s), f(c.frames), f(c.frame_files), f(c.history);
}

/// Calls `f(value)` for each value of a swing.
template <class F> void for_each_field(Swing &swing, F &&f) {
  f(swing.begun_us), f(swing.until_us), f(swing.dishing_mm), f(swing.integral_mm_us);
}

/// Calls `f(value)` for each value of a shot that grows during the run. The rest is known at its start or its end.
template <class F> void for_each_field(Result &shot, F &&f) {
  f(shot.flight), f(shot.swing), f(shot.intrusion_mm), f(shot.hourglass_fraction), f(shot.energy_error),
      f(shot.momentum_error);
}

} // namespace shot
