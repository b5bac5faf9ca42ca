// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "row.hpp"

/// \file
/// Runs the shots of a study on threads of this process, several at a time, and keeps a row of each.

namespace study {

/// A shot to be run.
struct Case {
  shot::Options options;
  std::string name; ///< of its folder in <out>/shots
  Key key;
};

/// Folder, columns and resources of a study.
struct Study {
  std::filesystem::path out;    ///< folder of the study: shots/ and the rows
  Texts own_columns{};          ///< of the key, besides key_columns()
  int jobs = 1;                 ///< shots at a time
  std::optional<int> threads{}; ///< of each shot; unset: the shots share the cores
  std::optional<int> cores{};   ///< that they share; unset: all that this process may use
  int shard = 1;                ///< this process runs part `shard` of `shards`
  int shards = 1;
};

/// Counts and failures of the shots.
struct Outcome {
  int run = 0;                       ///< shots run now
  int known = 0;                     ///< shots that had been run before
  std::vector<std::string> failed{}; ///< a line for each shot that failed
  int stopped_by = 0;                ///< the signal that ended the work; 0: none did
};

/// True if a row is final for a case; an undecided shot may be decided by a later end.
bool is_final(const Row &row, const Case &shot);

/// Adds the shots that were run, and failed, in further work.
void add(Outcome &all, const Outcome &more);

/// Receives a line for each shot that ends.
using Report = std::function<void(const std::string &line)>;

/// Chooses the next case by the rows that are known; nothing if there is none until a running shot ends. Is called by
/// one thread at a time.
using NextCase = std::function<std::optional<Case>(const std::vector<Row> &rows)>;

/// Threads of each shot where `workers` shots are run at a time.
int threads_of(const Study &study, int workers);

/// A case of a study: its key and the name of its folder by the columns.
Case case_of(const shot::Options &options, const Texts &own_columns, const std::string &name);

/// "mjc_weldox_460e_blunt_12mm_303.5mps_0.6mm", "_column=value" for each column of the study's own, and in front the
/// method unless it is the paper's.
std::string folder_name(const Key &key, const Texts &own_columns);

/// The folder of a shot.
std::filesystem::path folder_of(const Study &study, const Case &shot);

/// Cores that this process may use: in a job of a cluster, some of a machine's.
int cores();

/// First difference between the results in the folder of a shot and its case, one line; empty if they agree or there
/// are no results.
std::string conflict(const Study &study, const Case &shot);

/// The file that takes the rows of this process.
std::filesystem::path rows_file(const Study &study);

/// Reports what is doubtful about the metals of cases, each line once. Throws SetupError as plates_of() does.
void report_doubts(const std::vector<shot::Options> &cases, const Report &report);

/// Runs those cases of which no row is known (or no frames, where the case writes them), `study.jobs` at a time. A case
/// that was stopped resumes from its checkpoint; the row of a case is on the disk when its shot ends. A shot that fails
/// leaves the others alone. The first SIGINT, SIGTERM or SIGHUP lets running shots write their checkpoints and ends the
/// work. Throws WriteError if the folder cannot be used and SetupError for damaged rows, before any shot is run.
Outcome run_cases(const Study &study, const std::vector<Case> &cases, const Report &report);

/// Runs cases as run_cases() does, each chosen when a thread is free for it, at most `at_once` at a time.
Outcome run_chosen(const Study &study, std::size_t at_once, const NextCase &next, const Report &report);

} // namespace study
