// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace ogive {

/// A table of numbers, separated by commas, that grows row by row. Each row is on its way to the disk when `add_row`
/// returns, so a run that is killed leaves whole rows.
struct CsvWriter {
  std::filesystem::path path;       ///< of the file
  std::vector<std::string> columns; ///< names, units included: "time_us"
  std::ofstream file;               ///< open as long as the writer lives
  std::uintmax_t size = 0;          ///< bytes of the rows so far
};

/// Writes `line` and a line end. Throws WriteError with the operating system's reason; the table then ends with the row
/// before.
inline void add_line(CsvWriter &csv, const std::string &line) {
  errno = 0;
  csv.file << line << '\n';
  csv.file.flush();
  if (csv.file) {
    csv.size += line.size() + 1;
    return;
  }
  const std::string reason = errno ? std::generic_category().message(errno) : "the stream has failed";
  // Closed first: what is left in the buffer must not follow.
  csv.file.close();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(csv.path, ignored)) std::filesystem::resize_file(csv.path, csv.size, ignored);
  throw write_error(csv.path, reason);
}

/// The first line of a table. Throws SetupError for a column name that is empty or holds a comma, a quotation mark or a
/// line end.
inline std::string csv_header(const std::filesystem::path &path, const std::vector<std::string> &columns) {
  require(!columns.empty(), path.string() + " columns", columns.size(), "there must be one or more");
  std::string header;
  for (const auto &column : columns) {
    require(!column.empty() && column.find_first_of(",\"\r\n") == std::string::npos, path.string() + " column name",
            column, "must not be empty or hold a comma, a quotation mark or a line end");
    header += (header.empty() ? "" : ",") + column;
  }
  return header;
}

/// Numbers as a line, in the fewest digits that read back as the same ones.
inline std::string csv_line(std::span<const double> values) {
  std::string line;
  char digits[32];
  for (const double value : values) {
    if (!line.empty()) line += ',';
    line.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }
  return line;
}

/// Continues a table whose rows so far are `values`, one row after another, or begins one: replaces whatever is at
/// `path` by header and rows, at once, and adds rows after them. Throws SetupError for a column name that is empty or
/// holds a comma, a quotation mark or a line end, or if the last row is not whole, WriteError if the file cannot be
/// written.
inline CsvWriter continue_csv(const std::filesystem::path &path, std::vector<std::string> columns,
                              std::span<const double> values = {}) {
  std::string text = csv_header(path, columns) + '\n';
  require(values.size() % columns.size() == 0, path.string() + " values so far", values.size(),
          "must be a multiple of the number of columns, " + std::to_string(columns.size()));
  for (; !values.empty(); values = values.subspan(columns.size()))
    text += csv_line(values.first(columns.size())) + '\n';
  write_atomically(path, text);
  errno = 0;
  CsvWriter csv{path, std::move(columns), std::ofstream(path, std::ios::app), text.size()};
  if (!csv.file) throw write_error(path, errno ? std::generic_category().message(errno) : "cannot be opened");
  return csv;
}

/// Adds a row: one value for each column, in the fewest digits that read back as the same number. Throws SetupError for
/// another number of values, WriteError if writing fails.
inline void add_row(CsvWriter &csv, std::span<const double> values) {
  require(values.size() == csv.columns.size(), csv.path.string() + " values in a row", values.size(),
          "must be as many as there are columns, " + std::to_string(csv.columns.size()));
  add_line(csv, csv_line(values));
}

/// `add_row(csv, {1.0, 2.0})`.
inline void add_row(CsvWriter &csv, std::initializer_list<double> values) {
  add_row(csv, std::span<const double>(values.begin(), values.size()));
}

} // namespace ogive
