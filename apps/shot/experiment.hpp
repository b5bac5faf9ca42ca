// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// The tests that a computed shot is compared with, read from the tables in apps/data.

namespace experiment {

/// Tables of tests: where an installed program has them, else where it was built.
std::filesystem::path data_folder();

/// Rows of a table without its header; empty if the file cannot be read.
std::vector<std::vector<std::string>> read_rows(const std::filesystem::path &file);

/// Mass of the tests' projectiles, kg.
inline constexpr double projectile_mass_kg = 0.197;

/// Mass of a cylinder of the projectile's diameter out of a steel plate, kg.
double plug_mass_kg(double thickness_mm);

/// A residual velocity to compare with and its source.
struct Residual {
  double residual_mps = 0;
  std::string origin;
};

/// The measured shot of this material ("Weldox 460 E"), nose, thickness and velocity (to 0.5 m/s), else the Recht-Ipson
/// curve through the measured ballistic limit, else nothing.
std::optional<Residual> find_residual(const std::string &material, const std::string &nose, double thickness_mm,
                                      double velocity_mps);

} // namespace experiment
