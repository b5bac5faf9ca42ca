#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <charconv>
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
  std::filesystem::path path;
  std::vector<std::string> columns; ///< names, units included: "time_us"
  std::ofstream file;
};

/// Writes `line` and a line end. Throws WriteError with the operating system's reason.
inline void add_line(CsvWriter &csv, const std::string &line) {
  errno = 0;
  csv.file << line << '\n';
  csv.file.flush();
  if (!csv.file) throw write_error(csv.path, errno ? std::generic_category().message(errno) : "the stream has failed");
}

/// Starts a new table at `path`, in place of an old one, with its header. Throws SetupError for a column name that is
/// empty or holds a comma, a quotation mark or a line end, WriteError if the file cannot be written.
inline CsvWriter open_csv(const std::filesystem::path &path, std::vector<std::string> columns) {
  require(!columns.empty(), path.string() + " columns", columns.size(), "there must be one or more");
  std::string header;
  for (const auto &column : columns) {
    require(!column.empty() && column.find_first_of(",\"\r\n") == std::string::npos, path.string() + " column name",
            column, "must not be empty or hold a comma, a quotation mark or a line end");
    header += (header.empty() ? "" : ",") + column;
  }
  errno = 0;
  CsvWriter csv{path, std::move(columns), std::ofstream(path)};
  if (!csv.file) throw write_error(path, errno ? std::generic_category().message(errno) : "cannot be opened");
  add_line(csv, header);
  return csv;
}

/// Adds a row: one value for each column, in the fewest digits that read back as the same number. Throws SetupError for
/// another number of values, WriteError if writing fails.
inline void add_row(CsvWriter &csv, std::span<const double> values) {
  require(values.size() == csv.columns.size(), csv.path.string() + " values in a row", values.size(),
          "must be as many as there are columns, " + std::to_string(csv.columns.size()));
  std::string line;
  char digits[32];
  for (const double value : values) {
    if (!line.empty()) line += ',';
    line.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  }
  add_line(csv, line);
}

/// `add_row(csv, {1.0, 2.0})`.
inline void add_row(CsvWriter &csv, std::initializer_list<double> values) {
  add_row(csv, std::span<const double>(values.begin(), values.size()));
}

} // namespace ogive
