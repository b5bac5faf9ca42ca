// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shot/options.hpp"

#include <nlohmann/json_fwd.hpp>

/// \file
/// A shot of a study and its results: one row of a CSV file.

namespace study {

/// Texts or names of columns.
using Texts = std::vector<std::string>;

/// Values that identify a shot in a study, as text: those of key_columns() and then of the study's own columns.
struct Key {
  Texts values;

  auto operator<=>(const Key &) const = default;
};

/// The columns of every study: method, model, material, nose, thickness_mm, initial_velocity_mps, spacing_mm.
const Texts &key_columns();

/// Place of a column in Key::values.
inline constexpr std::size_t method_column = 0, model_column = 1, material_column = 2, nose_column = 3,
                             thickness_column = 4, velocity_column = 5, spacing_column = 6;

/// The columns of results, the numbers and then state_hash and version.
const Texts &result_columns();

/// A shot that has been run.
struct Row {
  Key key;
  Texts results; ///< of result_columns()
};

/// A result as text; empty where an undecided shot has none.
const std::string &text_of(const Row &row, const char *column);

/// A result as a number; NaN where an undecided shot has none.
double number(const Row &row, const char *column);

/// A value of the key as a number; NaN if it is none.
double number(const Key &key, std::size_t column);

/// True for a shot that has no verdict: perforated and residual_velocity_mps are empty.
bool is_undecided(const Row &row);

/// The name of a column of the key.
const std::string &column_name(std::size_t column, const Texts &own_columns);

/// The key of a case in a study with these columns of its own.
Key key_of(const shot::Options &options, const Texts &own_columns);

/// The row of a shot from its summary; of several plates the shape is 0. Throws SetupError if the summary reports a
/// fault or lacks a result.
Row row_of(const Key &key, const nlohmann::ordered_json &summary, const std::string &name);

/// The summary that a run left in `folder`. Throws SetupError if it cannot be read.
nlohmann::ordered_json read_summary(const std::filesystem::path &folder);

/// The rows of a file; none if there is no such file. A last line without its end, of a process that was killed, is
/// passed over. Throws SetupError for a file with other columns or damaged numbers.
std::vector<Row> read_rows(const std::filesystem::path &file, const Texts &own_columns);

/// The rows of all files shots*.csv in a folder, shards included, each shot once, sorted by key.
std::vector<Row> read_all_rows(const std::filesystem::path &folder, const Texts &own_columns);

/// Adds a row at the end of a file, with a header if it is new, and has the disk confirm it. Throws WriteError.
void append_row(const std::filesystem::path &file, const Row &row, const Texts &own_columns);

/// The row with this key; null if there is none.
const Row *find_row(const std::vector<Row> &rows, const Key &key);

/// A line of a CSV file, fields in quotation marks where they need them.
std::string csv_line(const Texts &fields);

} // namespace study
