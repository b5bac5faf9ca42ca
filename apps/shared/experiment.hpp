// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/csv_rows.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

/// \file
/// The tests that a computed shot is compared with, read from the tables in apps/data.

namespace experiment {

/// Rows of a table without its header; empty if the file cannot be read.
inline std::vector<std::vector<std::string>> read_rows(const std::filesystem::path &file) {
  constexpr std::size_t most_fields = 50;
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::vector<std::vector<std::string>> rows;
  ogive::for_each_csv_row(text, file.string(), most_fields,
                          [&](const ogive::CsvRow &row) { rows.push_back(row.fields); });
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

/// Mass of the tests' projectiles, kg.
inline constexpr double projectile_mass_kg = 0.197;

/// Mass of a cylinder of the projectile's diameter out of a steel plate, kg.
inline double plug_mass_kg(double thickness_mm) { return 7850 * std::numbers::pi * 0.01 * 0.01 * thickness_mm * 1e-3; }

/// A residual velocity to compare with and where it comes from.
struct Residual {
  double residual_mps = 0;
  std::string origin;
};

/// The measured shot of this material ("Weldox 460 E"), nose, thickness and velocity (to 0.5 m/s), else the Recht-Ipson
/// curve through the measured ballistic limit, else nothing.
inline std::optional<Residual> find_residual(const std::filesystem::path &folder, const std::string &material,
                                             const std::string &nose, double thickness_mm, double velocity_mps) {
  const auto same = [&](const std::vector<std::string> &row) {
    return row.size() > 7 && row[1] == material && row[2] == nose && std::abs(std::stod(row[3]) - thickness_mm) < 0.01;
  };
  std::optional<Residual> shot;
  double nearest = 0.5;
  for (const auto &row : read_rows(folder / "experiment_shots.csv"))
    if (const double gap = same(row) ? std::abs(std::stod(row[4]) - velocity_mps) : 1; gap < nearest) {
      nearest = gap;
      shot = Residual{std::stod(row[5]), "measured, " + row[6]};
    }
  if (shot) return shot;
  for (const auto &row : read_rows(folder / "experiment_limits.csv"))
    if (same(row)) {
      const double limit = std::stod(row[4]);
      const double plug_kg = nose == "blunt" ? plug_mass_kg(thickness_mm) : 0.0;
      const double a = row[5].empty() ? projectile_mass_kg / (projectile_mass_kg + plug_kg) : std::stod(row[5]);
      const double p = row[6].empty() ? 2.0 : std::stod(row[6]);
      const double residual =
          velocity_mps > limit ? a * std::pow(std::pow(velocity_mps, p) - std::pow(limit, p), 1 / p) : 0.0;
      return Residual{residual, "Recht-Ipson curve through the measured limit, " + row[7]};
    }
  return std::nullopt;
}

} // namespace experiment
