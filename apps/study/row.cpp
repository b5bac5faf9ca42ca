// SPDX-License-Identifier: BSD-3-Clause
#include "row.hpp"

#include "ogive/io/csv_rows.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"
#include "shot/table.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

namespace study {

namespace {

namespace fs = std::filesystem;
using ogive::SetupError;

/// The results that are text come last.
constexpr std::size_t text_results = 2;

std::vector<std::string> all_columns(const std::vector<std::string> &own) {
  std::vector<std::string> columns = key_columns();
  columns.insert(columns.end(), own.begin(), own.end());
  columns.insert(columns.end(), result_columns().begin(), result_columns().end());
  return columns;
}

std::string line_of(const std::vector<std::string> &fields) {
  std::string line;
  for (const std::string &field : fields) line += (&field == &fields.front() ? "" : ",") + csv_field(field);
  return line + "\n";
}

/// All of a file. Throws SetupError.
std::string read_text(const fs::path &name) {
  std::error_code none;
  std::ifstream file(name, std::ios::binary);
  if (!file || !fs::is_regular_file(name, none)) throw SetupError(name.string() + ": must be a file that can be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Writes all of the text at the end of an open file; returns errno or 0.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 ? 0 : errno;
}

/// Where the last whole line of a file ends: a process that was killed may have left part of one behind it.
off_t end_of_lines(int file) {
  off_t end = ::lseek(file, 0, SEEK_END);
  for (char c = 0; end > 0; --end)
    if (::pread(file, &c, 1, end - 1) == 1 && c == '\n') break;
  return end;
}

/// True for the results of one plate's shape: of several plates a summary has none.
bool is_of_shape(const std::string &column) {
  constexpr std::array shape{"plug_thickness_mm",  "dishing_mm",         "kept_fraction",     "petal_height_mm",
                             "band_temperature_K", "core_temperature_K", "most_temperature_K"};
  return std::find(shape.begin(), shape.end(), column) != shape.end();
}

/// The results that an undecided shot has not.
bool is_of_verdict(const std::string &column) { return column == "residual_velocity_mps" || column == "perforated"; }

/// Numbers by their value, other texts by their letters.
bool comes_before(const Row &a, const Row &b) {
  for (std::size_t k = 0; k < a.key.values.size(); ++k) {
    const double x = number(a.key, k), y = number(b.key, k);
    if (x != y && std::isfinite(x) && std::isfinite(y)) return x < y;
    if (a.key.values[k] != b.key.values[k]) return a.key.values[k] < b.key.values[k];
  }
  // A shot that was decided at last has two rows.
  if (is_undecided(a) != is_undecided(b)) return is_undecided(b);
  if (is_undecided(a) && number(a, "simulated_us") != number(b, "simulated_us"))
    return number(a, "simulated_us") > number(b, "simulated_us");
  // The hash breaks ties, so that the result does not depend on the order of the files.
  return a.results < b.results;
}

} // namespace

const std::vector<std::string> &key_columns() {
  static const std::vector<std::string> columns{
      "method", "model", "material", "nose", "thickness_mm", "initial_velocity_mps", "spacing_mm"};
  return columns;
}

const std::vector<std::string> &result_columns() {
  static const std::vector<std::string> columns{"residual_velocity_mps",
                                                "perforated",
                                                "plug_mass_g",
                                                "plug_thickness_mm",
                                                "dishing_mm",
                                                "kept_fraction",
                                                "petal_height_mm",
                                                "band_temperature_K",
                                                "core_temperature_K",
                                                "most_temperature_K",
                                                "hourglass_fraction",
                                                "energy_error",
                                                "momentum_error",
                                                "largest_intrusion_mm",
                                                "particles",
                                                "simulated_us",
                                                "steps",
                                                "wall_s",
                                                "cpu_s",
                                                "threads",
                                                "state_hash",
                                                "version"};
  return columns;
}

std::string csv_field(const std::string &text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

double number(const Row &row, const char *column) {
  const auto &columns = result_columns();
  const auto k = std::find(columns.begin(), columns.end(), column) - columns.begin();
  return ogive::number_from(row.results[static_cast<std::size_t>(k)])
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

bool is_undecided(const Row &row) { return std::isnan(number(row, "perforated")); }

double number(const Key &key, std::size_t column) {
  return ogive::number_from(key.values[column]).value_or(std::numeric_limits<double>::quiet_NaN());
}

Key key_of(const shot::Options &options, const std::vector<std::string> &own_columns) {
  shot::Options copy = options;
  const options::Table table = shot::table_of(copy);
  Key key;
  std::vector<std::string> columns = key_columns();
  columns.insert(columns.end(), own_columns.begin(), own_columns.end());
  for (const std::string &column : columns) {
    const auto *option = options::find(table, column == "initial_velocity_mps" ? "velocity_mps" : column);
    key.values.push_back(option == nullptr ? "" : shown(*option));
  }
  return key;
}

Row row_of(const Key &key, const nlohmann::ordered_json &json, const std::string &name) {
  Row row{key, {}};
  try {
    if (!json.at("fault").is_null())
      throw SetupError(name + ": the run stopped: " + ogive::printable(json["fault"].at("what").get<std::string>()));
    for (const std::string &column : result_columns()) {
      const bool is_left_out = is_of_shape(column) && !json.contains(column);
      const auto value = is_left_out ? nlohmann::ordered_json(0.0) : json.at(column);
      if (row.results.size() + text_results >= result_columns().size())
        row.results.push_back(value.get<std::string>());
      else if (value.is_null() && is_of_verdict(column))
        row.results.push_back("");
      else
        row.results.push_back(value.is_boolean() ? (value.get<bool>() ? "1" : "0")
                                                 : ogive::shortest(value.get<double>()));
    }
  } catch (const nlohmann::json::exception &error) {
    throw SetupError(name + ": " + ogive::printable(error.what()));
  }
  return row;
}

nlohmann::ordered_json read_summary(const fs::path &folder) {
  const auto file = folder / "summary.json";
  auto json = nlohmann::ordered_json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw SetupError(file.string() + ": is no summary of a shot");
  return json;
}

std::vector<Row> read_rows(const fs::path &file, const std::vector<std::string> &own_columns) {
  std::vector<Row> rows;
  if (!fs::exists(file)) return rows;
  std::string text = read_text(file);
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  const auto columns = all_columns(own_columns);
  const std::size_t keys = key_columns().size() + own_columns.size();
  bool first = true;
  ogive::for_each_csv_row(text, file.string(), columns.size(), [&](const ogive::CsvRow &csv) {
    const std::string place = ogive::place(file.string(), csv.line);
    if (csv.fields.size() != columns.size())
      throw SetupError(place + ": fields in the row = " + std::to_string(csv.fields.size()) + ": must be " +
                       std::to_string(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string where = place + ": " + columns[k] + " = " + ogive::printable(csv.fields[k]);
      if (first && csv.fields[k] != columns[k]) throw SetupError(where + ": must be the column " + columns[k]);
      const bool is_number =
          (k >= thickness_column && k <= spacing_column) || (k >= keys && k + text_results < columns.size());
      const bool may_be_empty = is_of_verdict(columns[k]) && csv.fields[k].empty();
      if (!first && is_number && !may_be_empty && !std::isfinite(ogive::number_from(csv.fields[k]).value_or(NAN)))
        throw SetupError(where + ": must be a finite number");
    }
    const auto middle = csv.fields.begin() + static_cast<std::ptrdiff_t>(keys);
    if (!first) rows.push_back({{{csv.fields.begin(), middle}}, {middle, csv.fields.end()}});
    first = false;
  });
  return rows;
}

std::vector<Row> read_all_rows(const fs::path &folder, const std::vector<std::string> &own_columns) {
  std::vector<Row> rows;
  std::error_code none;
  for (const auto &entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("shots") || !name.ends_with(".csv")) continue;
    const auto more = read_rows(entry.path(), own_columns);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  std::sort(rows.begin(), rows.end(), comes_before);
  rows.erase(std::unique(rows.begin(), rows.end(), [](const auto &a, const auto &b) { return a.key == b.key; }),
             rows.end());
  return rows;
}

void append_row(const fs::path &file, const Row &row, const std::vector<std::string> &own_columns) {
  const auto fail = [&](int error) { return ogive::write_error(file, std::generic_category().message(error)); };
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) throw fail(errno);
  std::vector<std::string> fields = row.key.values;
  fields.insert(fields.end(), row.results.begin(), row.results.end());
  int error = ::ftruncate(descriptor, end_of_lines(descriptor)) == 0 ? 0 : errno;
  const bool is_new = ::lseek(descriptor, 0, SEEK_END) == 0;
  if (error == 0) error = write_all(descriptor, (is_new ? line_of(all_columns(own_columns)) : "") + line_of(fields));
  ::close(descriptor);
  if (error != 0) throw fail(error);
}

const Row *find_row(const std::vector<Row> &rows, const Key &key) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row &row) { return row.key == key; });
  return found == rows.end() ? nullptr : &*found;
}

} // namespace study
