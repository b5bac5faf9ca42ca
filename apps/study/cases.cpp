// SPDX-License-Identifier: BSD-3-Clause
#include "cases.hpp"

#include "ogive/io/csv_rows.hpp"
#include "shot/table.hpp"

#include <set>

namespace study {

namespace {

using ogive::SetupError;
using options::Given;

constexpr std::size_t most_cases = 100000;

constexpr char allowed_shard[] = "I/N with whole numbers 1 <= I <= N";

/// The names of the columns that are no options.
bool is_note(const std::string &column) { return column == "name" || column == "text"; }

/// Throws unless this is an option of the case.
void require_known(const options::Table &table, const std::string &key, const std::string &where) {
  Texts known;
  for (const auto &option : table.options)
    if (option.group != shot::run_group || key == "end_us" || key == "settle_us" || key == "output_every_us")
      known.emplace_back(option.key);
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw SetupError(where + ": " + options::printable(key) + ": is not an option of a case" +
                     options::nearest_text(key, known) + "; ogive shoot --help-all lists them");
}

/// "200:400:25" as numbers; nothing unless it is a range.
std::optional<Texts> range_of(const std::string &text) {
  std::vector<double> parts;
  for (const std::string &part : options::split(text, ':')) {
    const auto number = ogive::number_from(part);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    parts.push_back(*number);
  }
  if (parts.size() != 3 || !(parts[2] > 0) || parts[1] < parts[0]) return std::nullopt;
  Texts values;
  const double count = std::floor((parts[1] - parts[0]) / parts[2] + 1e-9);
  for (double k = 0; k <= std::min(count, double(most_cases)); ++k)
    values.push_back(options::shortest(std::round((parts[0] + k * parts[2]) * 1e9) / 1e9));
  return values;
}

/// One --vary: the entries that take turns.
std::vector<Given> varied_values(const options::Table &table, const std::string &text) {
  const std::size_t equals = text.find('=');
  const std::string allowed = "must be NAME=VALUE,VALUE,... or NAME=FIRST:LAST:STEP";
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) options::refuse("--vary", text, allowed);
  std::string key = text.substr(0, equals);
  std::replace(key.begin(), key.end(), '-', '_');
  require_known(table, key, "--vary");
  const Given all{key, "--vary " + key, text.substr(equals + 1)};
  std::vector<Given> values;
  for (const Given &one : entries_given(all)) {
    const auto range = range_of(one.value);
    for (const std::string &value : range ? *range : std::vector{one.value}) values.push_back({key, all.where, value});
  }
  return values;
}

/// A row of a list: what it gives, and its name.
struct ListedCase {
  std::vector<Given> given{};
  std::string name{};
  std::string place = "--vary"; ///< file and line
};

struct List {
  std::vector<ListedCase> cases;
  Texts columns;
};

List read_list(const options::Table &table, const std::string &file) {
  const auto text = options::text_in(file);
  if (!text) throw SetupError(options::printable(file) + ": must be a CSV file of cases that can be read");
  List list;
  ogive::for_each_csv_row(*text, file, 100, [&](const ogive::CsvRow &row) {
    const std::string place = ogive::place(file, row.line);
    if (list.columns.empty()) {
      list.columns = row.fields;
      for (const auto &column : list.columns)
        if (!is_note(column)) require_known(table, column, place);
      if (std::set(list.columns.begin(), list.columns.end()).size() != list.columns.size())
        throw SetupError(place + ": every column must have a name of its own");
      return;
    }
    if (row.fields.size() != list.columns.size())
      throw SetupError(place + ": fields in the row = " + std::to_string(row.fields.size()) + ": must be " +
                       std::to_string(list.columns.size()) +
                       (row.fields.size() > list.columns.size() ? "; decimals have points, not commas" : ""));
    ListedCase &one = list.cases.emplace_back();
    one.place = place;
    for (std::size_t k = 0; k < row.fields.size(); ++k) {
      const std::string &column = list.columns[k];
      if (column == "name") one.name = row.fields[k];
      if (!is_note(column) && !row.fields[k].empty())
        one.given.push_back({column, place + ": " + column, row.fields[k]});
    }
    if (one.name.find('/') != std::string::npos || one.name.starts_with("."))
      throw SetupError(place + ": name = " + options::printable(one.name) + ": must be the name of a folder");
  });
  if (list.cases.empty()) throw SetupError(options::printable(file) + ": has no cases");
  return list;
}

} // namespace

CaseList cases_of(const std::vector<shot::Level> &common, const std::optional<std::string> &csv, const Texts &varied) {
  shot::Options any;
  const options::Table table = shot::table_of(any);
  List list;
  if (csv)
    list = read_list(table, *csv);
  else
    list.cases.emplace_back();
  std::size_t total = list.cases.size();
  std::vector<std::vector<Given>> variations;
  for (const std::string &text : varied) {
    variations.push_back(varied_values(table, text));
    list.columns.push_back(variations.back().front().key);
    total *= variations.back().size();
    if (total > most_cases) options::refuse("--vary", text, "gives more than " + std::to_string(most_cases) + " cases");
  }

  CaseList all;
  std::set<std::string> known(key_columns().begin(), key_columns().end());
  for (const std::string &column : list.columns)
    if (!is_note(column) && column != "velocity_mps" && known.insert(column).second) all.own_columns.push_back(column);
  std::set<std::string> names;
  std::set<Key> keys;
  for (const ListedCase &one : list.cases)
    for (std::size_t k = 0; k < total / list.cases.size(); ++k) {
      std::vector<shot::Level> levels = common;
      levels.push_back({one.given, csv ? std::filesystem::path(*csv).parent_path() : std::filesystem::path()});
      shot::Level turn;
      std::string suffix;
      // The last variation changes fastest.
      std::size_t left = k;
      for (auto values = variations.rbegin(); values != variations.rend(); ++values) {
        turn.given.insert(turn.given.begin(), (*values)[left % values->size()]);
        suffix = "_" + turn.given.front().key + "=" + turn.given.front().value + suffix;
        left /= values->size();
      }
      levels.push_back(turn);
      Case shot = case_of(shot::settled(levels), all.own_columns, one.name.empty() ? "" : one.name + suffix);
      if (!keys.insert(shot.key).second) continue; // the same case twice
      if (!names.insert(shot.name).second)
        throw SetupError(one.place + ": name = " + options::printable(shot.name) +
                         ": is also the name of another case");
      all.cases.push_back(std::move(shot));
    }
  return all;
}

// clang-format off
void add_study_options(options::Table &t, StudyOptions &o) {
  t.group = "Study";
  options::add(t, o.jobs, {.key = "jobs", .meaning = "number of shots at a time; they share the cores",
      .source = "as many as cores: one core a shot is the best use of a machine", .brief = "shots at a time",
      .limits = {1, 1000, ""}, .in_file = false});
  options::add(t, o.shard, {.key = "shard",
      .meaning = "run only the I-th of N parts of the study, for several machines; the shots of one limit stay "
      "together; draws nothing", .source = "1/1: all", .brief = "run only the I-th of N parts",
      .allowed = allowed_shard, .in_file = false}).placeholder = "I/N";
  options::add(t, o.run, {.key = "run", .meaning = "run missing shots; without it only existing results are drawn",
      .source = "yes: ours", .in_file = false});
}
// clang-format on

Study study_of(const StudyOptions &o, const std::filesystem::path &out) {
  Study study{.out = out};
  study.jobs = o.jobs > 0 ? o.jobs : cores();
  std::vector<double> parts;
  for (const std::string &part : options::split(o.shard, '/')) parts.push_back(ogive::number_from(part).value_or(0));
  if (parts.size() != 2 || parts[0] != std::floor(parts[0]) || parts[1] != std::floor(parts[1]) || parts[0] < 1 ||
      !(parts[0] <= parts[1]) || parts[1] > 10000)
    options::refuse("--shard", o.shard, std::string("must be ") + allowed_shard);
  study.shard = static_cast<int>(parts[0]), study.shards = static_cast<int>(parts[1]);
  return study;
}

} // namespace study
