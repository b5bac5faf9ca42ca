// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/stress_curve.hpp"
#include "ogive/fit/test_series.hpp"
#include "ogive/io/csv_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

/// \file
/// Tensile curves from tables in CSV.

namespace ogive {

/// The meaning of the numbers of a table.
struct CurveTableFormat {
  bool engineering = false; ///< engineering instead of true stress and plastic strain
  double young{};           ///< Pa, for engineering curves
  double melting{};         ///< K; tests must be colder
  bool unusual = false;     ///< take tests below 150 K and yield stresses outside 10 MPa to 5 GPa, not wrong units
};

/// A table: its name for errors, and its text.
struct CurveTable {
  std::string name;      ///< for errors
  std::string_view text; ///< all of it
};

namespace curve_table_detail {

enum Column { rate, temperature, strain, stress, specimen, plate, column_count };
using Columns = std::array<std::string, column_count>;

inline Columns columns(const CurveTableFormat &format) {
  return {"strain_rate_per_s",
          "temperature_K",
          format.engineering ? "engineering_strain" : "plastic_strain",
          format.engineering ? "engineering_stress_MPa" : "stress_MPa",
          "specimen",
          "plate"};
}

inline std::string list_of(const Columns &c) {
  return c[rate] + ", " + c[temperature] + ", " + c[strain] + ", " + c[stress] + ", and where wanted " + c[specimen] +
         ", " + c[plate];
}

/// A point of a table.
struct Entry {
  double strain{}, stress{};
  std::size_t table{};
  long line{};
};
struct Entries {
  StressCurve curve;
  std::vector<Entry> points;
};

/// For each field of a row its column. Throws SetupError for a name that is unknown, missing or there twice.
inline std::vector<Column> read_header(const CsvRow &row, const std::string &name, const Columns &names) {
  std::vector<Column> order;
  for (const auto &field : row.fields) {
    const auto found = std::find(names.begin(), names.end(), field);
    require(found != names.end(), place(name, row.line) + ": column", printable(field),
            "is unknown; allowed are " + list_of(names));
    order.push_back(static_cast<Column>(found - names.begin()));
    require(std::count(order.begin(), order.end(), order.back()) == 1, place(name, row.line) + ": column",
            printable(field), "must be given once");
  }
  for (const Column needed : {rate, temperature, strain, stress})
    require(std::find(order.begin(), order.end(), needed) != order.end(), place(name, row.line) + ": column",
            names[needed], "is missing; needed are " + list_of(names));
  return order;
}

/// The limits of the numbers of a column. They are far beyond any test and keep squares finite.
struct Allowed {
  double low, high;
  bool low_itself;
  const char *text;
};
inline Allowed allowed(Column column, const CurveTableFormat &format) {
  if (column == rate) return {0, 1e12, false, "must be positive and at most 1e12 1/s"};
  if (column == temperature) return {0, 1e5, false, "must be positive, in kelvin"};
  if (column == strain)
    return format.engineering ? Allowed{-0.5, 10, true, "must lie between -0.5 and 10"}
                              : Allowed{0, 10, true, "must lie between 0 and 10"};
  return format.engineering ? Allowed{-1e6, 1e6, true, "must lie between -1e6 and 1e6 MPa"}
                            : Allowed{0, 1e6, false, "must be positive and at most 1e6 MPa"};
}

inline double read_number(const std::string &field, Column column, const std::string &where, const Columns &names,
                          const CurveTableFormat &format) {
  const auto number = number_from(field);
  const std::string thing = where + ": " + names[column];
  require(number && std::isfinite(*number), thing, field.empty() ? "nothing" : printable(field),
          "must be a finite number");
  const Allowed range = allowed(column, format);
  const bool ok = (range.low_itself ? *number >= range.low : *number > range.low) && *number <= range.high;
  require(ok, thing, printable(field), range.text);
  if (column == temperature)
    require(*number < format.melting, thing, printable(field),
            "must lie below the melting temperature, " + shortest(format.melting) + " K");
  return *number;
}

/// Names one of a curve, so that points of all tables with the same key are one curve.
using Key = std::tuple<std::string, std::string, double, double>;

inline void read_table(const CurveTable &table, std::size_t index, const CurveTableFormat &format,
                       std::map<Key, std::size_t> &known, std::vector<Entries> &curves) {
  const Columns names = columns(format);
  std::vector<Column> order;
  bool any = false;
  for_each_csv_row(table.text, table.name, 1000, [&](const CsvRow &row) {
    if (order.empty()) {
      order = read_header(row, table.name, names);
      return;
    }
    any = true;
    const std::string where = place(table.name, row.line);
    require(row.fields.size() == order.size(), where + ": fields", row.fields.size(),
            "must be as many as there are columns, " + std::to_string(order.size()) +
                (row.fields.size() > order.size() ? "; decimals have points, not commas" : ""));
    std::array<double, column_count> number{};
    std::array<std::string, column_count> text{};
    for (std::size_t i = 0; i < order.size(); ++i)
      if (order[i] == specimen || order[i] == plate)
        text[order[i]] = printable(row.fields[i]);
      else
        number[order[i]] = read_number(row.fields[i], order[i], where, names, format);
    const auto [found, is_new] =
        known.try_emplace({text[plate], text[specimen], number[rate], number[temperature]}, curves.size());
    if (is_new) curves.push_back({{text[plate], text[specimen], number[rate], number[temperature], {}, {}}, {}});
    curves[found->second].points.push_back({number[strain], number[stress] * 1e6, index, row.line});
  });
  require(any, table.name + ": rows", 0, "must be one or more below a header with " + list_of(names));
}

/// Turns an engineering curve into a true one, and reports what was left out.
inline void convert(Entries &e, const CurveTableFormat &format, const std::vector<CurveTable> &tables,
                    std::vector<std::string> &messages) {
  std::vector<double> strain, stress;
  for (const auto &p : e.points) strain.push_back(p.strain), stress.push_back(p.stress);
  const TrueCurve converted = true_curve(strain, stress, format.young);
  const auto note = [&](const std::string &text) { messages.push_back(description(e.curve) + ": " + text); };
  if (converted.necked > 0)
    note("cut at necking, plastic strain " + shortest(std::round(1e4 * converted.necking_strain) / 1e4) + ": " +
         std::to_string(converted.necked) + " points behind the largest engineering stress left out");
  if (converted.elastic > 0)
    note(std::to_string(converted.elastic) + " points below plastic strain " + shortest(least_plastic_strain) +
         " left out");
  std::vector<Entry> points;
  for (std::size_t i = 0; i < converted.from.size(); ++i) {
    const Entry &from = e.points[converted.from[i]];
    require(from.stress > 0, place(tables[from.table].name, from.line) + ": engineering_stress_MPa",
            shortest(from.stress / 1e6), "must be positive where the curve is plastic");
    points.push_back({converted.strain[i], converted.stress[i], from.table, from.line});
  }
  // Scatter of the measured strain may turn plastic strains about.
  std::stable_sort(points.begin(), points.end(), [](const auto &a, const auto &b) { return a.strain < b.strain; });
  if (points.size() < 2)
    throw SetupError(place(tables[e.points.front().table].name, e.points.front().line) + ": curve " +
                     description(e.curve) + " = " + std::to_string(points.size()) +
                     " points between plastic strain 0.002 and necking: must be two or more");
  e.points = std::move(points);
}

/// Throws SetupError for a curve whose numbers are probably degrees Celsius, pascals or gigapascals.
inline void require_usual_units(const Entries &e, const CurveTableFormat &format,
                                const std::vector<CurveTable> &tables) {
  if (format.unusual) return;
  const Columns names = columns(format);
  const Entry &first = e.points.front();
  const std::string where = place(tables[first.table].name, first.line) + ": ";
  constexpr const char *unless = "; tests that are meant so need unusual = true";
  require(e.curve.temperature >= 150, where + names[temperature], shortest(e.curve.temperature),
          std::string("is unlikely: kelvin are needed, not degrees Celsius") + unless);
  require(first.stress >= 10e6 && first.stress <= 5e9, where + names[stress], shortest(first.stress / 1e6),
          std::string("is unlikely for the yield stress, which is between 10 and 5000 MPa in metals") + unless);
}

/// Leaves each point once: one that was pasted twice would count as two measurements.
inline void drop_repeated(Entries &e, std::vector<std::string> &messages) {
  std::vector<Entry> points;
  for (const Entry &p : e.points) {
    bool repeated = false; // they are sorted by strain
    for (auto other = points.rbegin(); other != points.rend() && other->strain == p.strain; ++other)
      repeated = repeated || other->stress == p.stress;
    if (!repeated) points.push_back(p);
  }
  if (points.size() < e.points.size())
    messages.push_back(description(e.curve) + ": " + std::to_string(e.points.size() - points.size()) +
                       " points that are there more than once count once");
  e.points = std::move(points);
}

} // namespace curve_table_detail

/// Reads curves from tables with the columns strain_rate_per_s, temperature_K, plastic_strain and stress_MPa in any
/// order, and where wanted specimen and plate; engineering_strain and engineering_stress_MPa for engineering curves.
/// Rows of the same plate, specimen, rate and temperature are one curve, sorted by strain. What is left out of
/// engineering curves or counts once is added to `messages`. Throws SetupError, one line with table and line.
inline std::vector<StressCurve> read_curves(const std::vector<CurveTable> &tables, const CurveTableFormat &format,
                                            std::vector<std::string> &messages) {
  using namespace curve_table_detail;
  std::map<Key, std::size_t> known;
  std::vector<Entries> all;
  for (std::size_t i = 0; i < tables.size(); ++i) read_table(tables[i], i, format, known, all);
  std::vector<StressCurve> curves;
  for (auto &e : all) {
    const Entry first = e.points.front();
    std::stable_sort(e.points.begin(), e.points.end(),
                     [](const auto &a, const auto &b) { return a.strain < b.strain; });
    drop_repeated(e, messages);
    if (e.points.size() < 2)
      throw SetupError(place(tables[first.table].name, first.line) + ": curve " + description(e.curve) +
                       " = 1 point: must have two or more");
    if (format.engineering) convert(e, format, tables, messages);
    require_usual_units(e, format, tables);
    for (const auto &p : e.points) e.curve.strain.push_back(p.strain), e.curve.stress.push_back(p.stress);
    curves.push_back(std::move(e.curve));
  }
  return curves;
}

} // namespace ogive
