// SPDX-License-Identifier: BSD-3-Clause
#include "shot_row.hpp"

#include "ogive/io/csv_rows.hpp"
#include "ogive/io/write_error.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

namespace figures {

namespace {

using ogive::SetupError;

std::string text_of(const std::string &value) { return value; }
std::string text_of(double value) { return ogive::shortest(value); }

/// The line of a row, or of the header.
std::string line_of(const ShotRow &row, bool header) {
  std::string line;
  for_each_column(row, [&](const char *name, const auto &value) {
    line += (line.empty() ? "" : ",") + (header ? std::string(name) : text_of(value));
  });
  return line + "\n";
}

void assign(std::string &value, const std::string &text, const std::string &) { value = text; }
void assign(double &value, const std::string &text, const std::string &where) {
  const auto number = ogive::number_from(text);
  if (!number || !std::isfinite(*number))
    throw SetupError(where + " = " + ogive::printable(text) + ": must be a finite number");
  value = *number;
}

/// All of a file. Throws SetupError.
std::string read_text(const std::filesystem::path &name) {
  std::error_code none;
  std::ifstream file(name, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(name, none))
    throw SetupError(name.string() + ": must be a file that can be read");
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

} // namespace

std::string folder_name(const ShotKey &key) {
  return (key.method == "sfm" ? "" : key.method + "_") + key.model + "_" + key.material + "_" + key.nose + "_" +
         ogive::shortest(key.thickness_mm) + "mm_" + ogive::shortest(key.initial_velocity_mps) + "mps_" +
         ogive::shortest(key.spacing_mm) + "mm";
}

ShotRow read_summary(const ShotKey &key, const std::filesystem::path &folder) {
  const auto file = folder / "summary.json";
  const auto json = nlohmann::json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw SetupError(file.string() + ": is no summary of perforate");
  ShotRow row;
  row.key = key;
  try {
    if (!json.at("fault").is_null())
      throw SetupError(file.string() +
                       ": the run stopped: " + ogive::printable(json["fault"].at("what").get<std::string>()));
    for_each_column(row, [&]<class V>(const std::string &name, V &value) {
      if (name == "perforated")
        row.perforated = json.at(name).get<bool>() ? 1 : 0;
      else if (name != "method" && name != "spacing_mm")
        value = json.at(name).get<V>();
    });
  } catch (const nlohmann::json::exception &error) {
    throw SetupError(file.string() + ": " + ogive::printable(error.what()));
  }
  if (!(row.key == key)) throw SetupError(file.string() + ": is the summary of another shot");
  return row;
}

std::vector<ShotRow> read_rows(const std::filesystem::path &file) {
  std::vector<ShotRow> rows;
  if (!std::filesystem::exists(file)) return rows;
  std::string text = read_text(file);
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  const std::string header = line_of({}, true);
  std::size_t columns = 1 + static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
  bool first = true;
  ogive::for_each_csv_row(text, file.string(), columns, [&](const ogive::CsvRow &csv) {
    if (csv.fields.size() != columns)
      throw SetupError(ogive::place(file.string(), csv.line) + ": fields in the row = " +
                       std::to_string(csv.fields.size()) + ": must be " + std::to_string(columns));
    std::size_t k = 0;
    ShotRow row;
    for_each_column(row, [&](const char *name, auto &value) {
      const std::string &field = csv.fields[k++];
      const std::string where = ogive::place(file.string(), csv.line) + ": " + name;
      if (!first)
        assign(value, field, where);
      else if (field != name)
        throw SetupError(where + " = " + ogive::printable(field) + ": must be the column " + name);
    });
    if (!first) rows.push_back(row);
    first = false;
  });
  return rows;
}

std::vector<ShotRow> read_all_rows(const std::filesystem::path &folder) {
  std::vector<ShotRow> rows;
  std::error_code none;
  for (const auto &entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("shots") || !name.ends_with(".csv")) continue;
    const auto more = read_rows(entry.path());
    rows.insert(rows.end(), more.begin(), more.end());
  }
  // The hash breaks ties, so that the result does not depend on the order of the files.
  const auto order = [](const ShotRow &a, const ShotRow &b) {
    return a.key != b.key ? a.key < b.key : a.state_hash < b.state_hash;
  };
  std::sort(rows.begin(), rows.end(), order);
  rows.erase(std::unique(rows.begin(), rows.end(), [](const auto &a, const auto &b) { return a.key == b.key; }),
             rows.end());
  return rows;
}

void append_row(const std::filesystem::path &file, const ShotRow &row) {
  const auto fail = [&](int error) { return ogive::write_error(file, std::generic_category().message(error)); };
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) throw fail(errno);
  // Where the file system has no locks each process must have a file of its own, as shards do.
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
  int error = ::ftruncate(descriptor, end_of_lines(descriptor)) == 0 ? 0 : errno;
  const bool is_new = ::lseek(descriptor, 0, SEEK_END) == 0;
  if (error == 0) error = write_all(descriptor, (is_new ? line_of({}, true) : "") + line_of(row, false));
  ::close(descriptor);
  if (error != 0) throw fail(error);
}

const ShotRow *find_row(const std::vector<ShotRow> &rows, const ShotKey &key) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const ShotRow &row) { return row.key == key; });
  return found == rows.end() ? nullptr : &*found;
}

} // namespace figures
