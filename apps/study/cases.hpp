// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study.hpp"

#include "options/command_line.hpp"

/// \file
/// Lists of cases, and the options that all studies have.

namespace study {

/// The cases of a study and the columns of their key besides key_columns().
struct CaseList {
  std::vector<Case> cases;
  Texts own_columns;
};

/// The cases of a CSV file and of --vary: `common` options, then those of a row, then each combination of the varied
/// ones ("thickness_mm=6,8", "velocity_mps=200:400:25"). Columns are names of options; an empty field leaves the option
/// to `common`; `name` is that of the shot's folder, and it and `text` are kept for the reader. Throws SetupError that
/// names file, line and column.
CaseList cases_of(const std::vector<shot::Level> &common, const std::optional<std::string> &csv, const Texts &varied);

/// Options of every study.
struct StudyOptions {
  int jobs = 0; ///< shots at a time; 0: as many as cores
  std::string shard = "1/1";
  bool run = true; ///< run what is missing
};

/// Adds --jobs, --shard and --no-run to a table.
void add_study_options(options::Table &table, StudyOptions &options);

/// A study in `out` with these choices. Throws SetupError for a shard that is none.
Study study_of(const StudyOptions &options, const std::filesystem::path &out);

/// Every `shards`-th of a list from the `shard`-th on.
template <class V> std::vector<V> share_of(const std::vector<V> &all, const Study &study) {
  std::vector<V> mine;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k % static_cast<std::size_t>(study.shards) == static_cast<std::size_t>(study.shard - 1)) mine.push_back(all[k]);
  return mine;
}

} // namespace study
