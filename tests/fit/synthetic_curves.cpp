// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fit/stress_curve.hpp"
#include "ogive/io/csv_rows.hpp"
#include "ogive/material/library.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// \file
/// How the example curves in apps/data were computed, from published Johnson-Cook fits with scatter: the paper's own
/// test curves are not public.

namespace {

/// One computed curve.
struct Specimen {
  double strength; ///< factor on A and B
  double rate, temperature, last_strain;
};

std::vector<Specimen> weldox_specimens() {
  const double slow = 7.4e-4;
  std::vector<Specimen> all{{1, slow, 293, 0.3}, {1, 2.16, 293, 0.2}, {1, 1522, 293, 0.15}};
  for (const double hot : {373, 473, 573, 673, 773}) all.push_back({1, slow, hot, 0.2});
  return all;
}

std::vector<Specimen> aluminium_specimens() {
  const double slow = 1e-3, weak = 0.85;
  std::vector<Specimen> all;
  for (const double plate_mm : {15, 20, 25, 30}) all.push_back({plate_mm == 25 ? weak : 1.0, slow, 293, 0.3});
  for (const double rate : {3.95, 122.0, 1313.0}) all.push_back({weak, rate, 293, rate > 10 ? 0.15 : 0.2});
  for (const double hot : {473, 573, 673, 773}) all.push_back({weak, slow, hot, 0.2});
  return all;
}

/// Normal scatter that is the same with every standard library (Box & Muller 1958).
struct Scatter {
  std::mt19937_64 engine{1};

  double uniform() { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; }
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
};

/// The rows of a table: strain rate, temperature, plastic strain, stress in MPa.
template <class Law>
std::vector<std::vector<double>> rows_of(const ogive::Metal<double, Law> &metal, const std::vector<Specimen> &all) {
  constexpr double first = 0.002, step = 0.0025, adiabatic_above = 10, noise = 0.01;
  Scatter scatter;
  std::vector<std::vector<double>> rows;
  for (const Specimen &s : all) {
    auto law = metal.flow;
    law.A *= s.strength;
    law.B *= s.strength;
    std::vector<double> strains;
    for (int i = 0; first + i * step <= s.last_strain + 1e-9; ++i)
      strains.push_back(std::round(1e5 * (first + i * step)) / 1e5);
    const double heat = s.rate >= adiabatic_above ? metal.taylor_quinney / (metal.density * metal.specific_heat) : 0.0;
    for (const auto &p : adiabatic_curve(law, {metal.room_temperature, metal.melting_temperature}, s.rate,
                                         s.temperature, heat, strains))
      rows.push_back({s.rate, s.temperature, p.strain, p.stress * (1 + noise * scatter.normal()) / 1e6});
  }
  return rows;
}

/// Whether the table's last four columns hold these rows, the stress to its two decimals.
void check_table(const std::string &name, const std::vector<std::vector<double>> &expected) {
  const std::string text = read_text(std::filesystem::path(OGIVE_DATA_FOLDER) / name);
  std::size_t row = 0, wrong = 0;
  bool header = true;
  ogive::for_each_csv_row(text, name, 5, [&](const ogive::CsvRow &found) {
    if (std::exchange(header, false)) return;
    REQUIRE(row < expected.size());
    for (std::size_t k = 0; k < 4; ++k) {
      const double value = *ogive::number_from(found.fields[found.fields.size() - 4 + k]);
      wrong += std::abs(value - expected[row][k]) > (k == 3 ? 0.006 : 1e-12) ? 1 : 0;
    }
    ++row;
  });
  CHECK(row == expected.size());
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("the example curves are those of the published fits with 1 % scatter") {
  check_table("synthetic_weldox_460e.csv", rows_of(ogive::library::weldox_460e_jc<double>(), weldox_specimens()));
  check_table("synthetic_aa5083_h116.csv", rows_of(ogive::library::aa5083_h116_jc<double>(), aluminium_specimens()));
}
