// SPDX-License-Identifier: BSD-3-Clause
#include "experiment.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/csv_rows.hpp"
#include "options/data_folder.hpp"
#include "options/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace experiment {

namespace {

using ogive::number_from;
using Rows = std::vector<std::vector<std::string>>;

/// The rows of a specimen, from the column of the metal on: metal, nose, thickness and two more at least.
Rows find_rows(const char *table, const Specimen &specimen) {
  Rows found;
  for (auto row : read_rows(options::data_folder() / table)) {
    const auto metal = std::find(row.begin(), row.end(), specimen.metal);
    row.erase(row.begin(), metal);
    const auto thickness = row.size() > 4 ? number_from(row[2]) : std::nullopt;
    if (thickness && std::abs(*thickness - specimen.thickness_mm) < 0.01 && row[1] == specimen.nose)
      found.push_back(std::move(row));
  }
  return found;
}

} // namespace

std::vector<std::vector<std::string>> read_rows(const std::filesystem::path &file) {
  constexpr std::size_t most_fields = 50;
  Rows rows;
  ogive::for_each_csv_row(options::text_in(file).value_or(""), file.string(), most_fields,
                          [&](const ogive::CsvRow &row) { rows.push_back(row.fields); });
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

std::vector<Shot> find_shots(const Specimen &specimen) {
  std::vector<Shot> shots;
  for (const auto &row : find_rows("experiment_shots.csv", specimen))
    if (const auto initial = number_from(row[3]), residual = number_from(row[4]); initial && residual && row.size() > 5)
      shots.push_back({*initial, *residual, row[5]});
  return shots;
}

std::optional<Limit> find_limit(const Specimen &specimen) {
  constexpr double projectile_kg = 0.197, steel_kg_per_m3 = 7850, radius_m = 0.01;
  const double plug_kg = specimen.nose == "blunt"
                             ? steel_kg_per_m3 * std::numbers::pi * radius_m * radius_m * specimen.thickness_mm * 1e-3
                             : 0;
  for (const auto &row : find_rows("experiment_limits.csv", specimen))
    if (const auto limit = number_from(row[3]); limit && row.size() > 6)
      return Limit{*limit, number_from(row[4]).value_or(projectile_kg / (projectile_kg + plug_kg)),
                   number_from(row[5]).value_or(2), row[6]};
  return std::nullopt;
}

std::optional<double> find_paper_velocity(const Specimen &specimen) {
  for (const auto &row : find_rows("paper_simulations.csv", specimen))
    if (row[4].starts_with("strike velocity close")) return number_from(row[3]);
  return std::nullopt;
}

std::optional<Residual> find_residual(const std::string &metal, const std::string &nose, double thickness_mm,
                                      double velocity_mps) {
  const Specimen specimen{metal, nose, thickness_mm};
  std::optional<Residual> shot;
  double nearest = 0.5;
  for (const Shot &one : find_shots(specimen))
    if (const double gap = std::abs(one.initial_mps - velocity_mps); gap < nearest) {
      nearest = gap;
      shot = Residual{one.residual_mps, "measured, " + one.source};
    }
  if (shot) return shot;
  const auto limit = find_limit(specimen);
  if (!limit) return std::nullopt;
  const auto &[v, a, p, source] = *limit;
  return Residual{velocity_mps > v ? a * std::pow(std::pow(velocity_mps, p) - std::pow(v, p), 1 / p) : 0,
                  "Recht-Ipson curve through the measured limit, " + source};
}

} // namespace experiment
