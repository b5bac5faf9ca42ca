// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "course.hpp"

#include "ogive/io/checkpoint_file.hpp"
#include "ogive/io/csv.hpp"
#include "ogive/io/frame.hpp"
#include "ogive/io/vtk.hpp"

namespace shot {

/// The files that grow during a run.
struct Files {
  ogive::CsvWriter history;
  ogive::VtkSeries series;
};

/// Writes material.toml (material_1.toml and so on for plates of several metals) and case.toml and removes the results
/// of an earlier run from the folder; its checkpoint gets another name, unless this run resumes from it. A material
/// file that the user has there under that name is not changed. Throws WriteError.
void start_results(const Options &options, const Plates &plates);

/// True if the run resumes in the folder of its checkpoint.
bool is_in_place(const Options &options);

/// Text of the file case.toml that start_results() writes.
std::string case_text(const Options &options);

/// Starts the files of a run, or resumes them at the place in `course`: later rows and frames are dropped. Throws
/// WriteError.
Files open_files(const Options &options, const Course &course);

/// Writes a frame and notes its files in the course. Throws WriteError.
void add_frame(Files &files, Course &course, const ogive::Frame &frame);

/// Restores a shot and its course from the notes of a checkpoint. Throws SetupError if they are damaged.
void read_notes(const ogive::Checkpoint &checkpoint, Result &shot, Course &course);

/// The notes of a checkpoint at `time_us`.
std::string notes_of(const Options &options, const Plates &plates, Result &shot, Course &course, double time_us);

} // namespace shot
