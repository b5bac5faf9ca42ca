// SPDX-License-Identifier: BSD-3-Clause
#include "experiment.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/csv_rows.hpp"
#include "ogive/io/text.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

namespace experiment {

std::filesystem::path data_folder() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto installed = program.parent_path().parent_path() / "share/ogive/data";
  return std::filesystem::exists(installed / "experiment_shots.csv", none) ? installed : OGIVE_DATA_FOLDER;
}

std::vector<std::vector<std::string>> read_rows(const std::filesystem::path &file) {
  constexpr std::size_t most_fields = 50;
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::vector<std::vector<std::string>> rows;
  ogive::for_each_csv_row(text, file.string(), most_fields,
                          [&](const ogive::CsvRow &row) { rows.push_back(row.fields); });
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

namespace {

/// The number in a field of a table.
double number_in(const std::string &field) {
  if (const auto number = ogive::number_from(field)) return *number;
  throw ogive::SetupError("number in the tables of tests = " + ogive::printable(field) + ": must be a number");
}

} // namespace

double plug_mass_kg(double thickness_mm) { return 7850 * std::numbers::pi * 0.01 * 0.01 * thickness_mm * 1e-3; }

std::optional<Residual> find_residual(const std::string &material, const std::string &nose, double thickness_mm,
                                      double velocity_mps) {
  const std::filesystem::path folder = data_folder();
  const auto same = [&](const std::vector<std::string> &row) {
    return row.size() > 7 && row[1] == material && row[2] == nose && std::abs(number_in(row[3]) - thickness_mm) < 0.01;
  };
  std::optional<Residual> shot;
  double nearest = 0.5;
  for (const auto &row : read_rows(folder / "experiment_shots.csv"))
    if (const double gap = same(row) ? std::abs(number_in(row[4]) - velocity_mps) : 1; gap < nearest) {
      nearest = gap;
      shot = Residual{number_in(row[5]), "measured, " + row[6]};
    }
  if (shot) return shot;
  for (const auto &row : read_rows(folder / "experiment_limits.csv"))
    if (same(row)) {
      const double limit = number_in(row[4]);
      const double plug_kg = nose == "blunt" ? plug_mass_kg(thickness_mm) : 0.0;
      const double a = row[5].empty() ? projectile_mass_kg / (projectile_mass_kg + plug_kg) : number_in(row[5]);
      const double p = row[6].empty() ? 2.0 : number_in(row[6]);
      const double residual =
          velocity_mps > limit ? a * std::pow(std::pow(velocity_mps, p) - std::pow(limit, p), 1 / p) : 0.0;
      return Residual{residual, "Recht-Ipson curve through the measured limit, " + row[7]};
    }
  return std::nullopt;
}

} // namespace experiment
