// SPDX-License-Identifier: BSD-3-Clause
#include "row.hpp"

#include "shot/table.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/csv_rows.hpp"

#include <nlohmann/json.hpp>

namespace study {

namespace {

namespace fs = std::filesystem;
using ogive::SetupError;

/// The results that are text come last.
constexpr std::size_t text_results = 2;

/// Results of one plate's shape, from plug_thickness_mm to most_temperature_K: a summary of several plates has none.
constexpr std::size_t first_of_shape = 3, last_of_shape = 10;

Texts operator+(Texts a, const Texts &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Contents of a file. Throws SetupError.
std::string read_text(const fs::path &name) {
  auto text = options::text_in(name);
  if (!text) throw SetupError(name.string() + ": must be a file that can be read");
  return *text;
}

/// The whole lines of a text: a process that was killed may have left part of one behind them.
void drop_half_line(std::string &text) { text.resize(text.rfind('\n') + 1); }

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

const Texts &key_columns() {
  static const Texts columns =
      options::split("method,model,material,nose,thickness_mm,initial_velocity_mps,spacing_mm", ',');
  return columns;
}

const Texts &result_columns() {
  static const Texts columns = options::split(
      "residual_velocity_mps,perforated,plug_mass_g,plug_thickness_mm,dishing_mm,kept_fraction,petal_height_mm,petals,"
      "band_temperature_K,core_temperature_K,most_temperature_K,hourglass_fraction,energy_error,momentum_error,"
      "largest_intrusion_mm,particles,simulated_us,steps,wall_s,cpu_s,threads,state_hash,version",
      ',');
  return columns;
}

std::string csv_line(const Texts &fields) {
  Texts quoted;
  for (std::string field : fields) {
    const bool plain = field.find_first_of(",\"\r\n") == std::string::npos;
    for (std::size_t at = 0; (at = field.find('"', at)) != std::string::npos; at += 2) field.insert(at, 1, '"');
    quoted.push_back(plain ? field : '"' + field + '"');
  }
  return options::joined(quoted, ",") + "\n";
}

const std::string &text_of(const Row &row, const char *column) {
  const auto &columns = result_columns();
  const auto k = std::find(columns.begin(), columns.end(), column) - columns.begin();
  return row.results[static_cast<std::size_t>(k)];
}

double number(const Row &row, const char *column) {
  return ogive::number_from(text_of(row, column)).value_or(std::numeric_limits<double>::quiet_NaN());
}

bool is_undecided(const Row &row) { return std::isnan(number(row, "perforated")); }

double number(const Key &key, std::size_t column) { return ogive::number_from(key.values[column]).value_or(NAN); }

const std::string &column_name(std::size_t column, const Texts &own_columns) {
  const Texts &keys = key_columns();
  return column < keys.size() ? keys[column] : own_columns[column - keys.size()];
}

Key key_of(const shot::Options &options, const Texts &own_columns) {
  shot::Options copy = options;
  const options::Table table = shot::table_of(copy);
  Key key;
  for (const std::string &column : key_columns() + own_columns) {
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
      const std::size_t k = row.results.size();
      const bool left_out = k >= first_of_shape && k <= last_of_shape && !json.contains(column);
      const auto value = left_out ? nlohmann::ordered_json(0.0) : json.at(column);
      const bool is_text = k + text_results >= result_columns().size();
      const bool undecided = is_of_verdict(column) && value.is_null();
      row.results.push_back(undecided            ? ""
                            : is_text            ? value.get<std::string>()
                            : value.is_boolean() ? (value.get<bool>() ? "1" : "0")
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
  if (!json.is_object()) throw SetupError(file.string() + ": is not the summary of a shot");
  return json;
}

std::vector<Row> read_rows(const fs::path &file, const Texts &own_columns) {
  std::vector<Row> rows;
  if (!fs::exists(file)) return rows;
  std::string text = read_text(file);
  drop_half_line(text);
  const Texts columns = key_columns() + own_columns + result_columns();
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
      // Rows of versions that did not count petals have an empty field there.
      const bool may_be_empty = (is_of_verdict(columns[k]) || columns[k] == "petals") && csv.fields[k].empty();
      if (!first && is_number && !may_be_empty && !std::isfinite(ogive::number_from(csv.fields[k]).value_or(NAN)))
        throw SetupError(where + ": must be a finite number");
    }
    const auto middle = csv.fields.begin() + static_cast<std::ptrdiff_t>(keys);
    if (!first) rows.push_back({{{csv.fields.begin(), middle}}, {middle, csv.fields.end()}});
    first = false;
  });
  return rows;
}

std::vector<Row> read_all_rows(const fs::path &folder, const Texts &own_columns) {
  std::vector<Row> rows;
  std::error_code none;
  for (const auto &entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("shots") || !name.ends_with(".csv")) continue;
    const auto more = read_rows(entry.path(), own_columns);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  std::sort(rows.begin(), rows.end(), comes_before);
  const auto same = [](const Row &a, const Row &b) { return a.key == b.key; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  return rows;
}

void append_row(const fs::path &file, const Row &row, const Texts &own_columns) {
  ogive::require_replaceable(file);
  std::string text = fs::exists(file) ? read_text(file) : "";
  drop_half_line(text);
  if (text.empty()) text = csv_line(key_columns() + own_columns + result_columns());
  ogive::write_atomically(file, text + csv_line(row.key.values + row.results));
}

const Row *find_row(const std::vector<Row> &rows, const Key &key) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row &row) { return row.key == key; });
  return found == rows.end() ? nullptr : &*found;
}

} // namespace study
