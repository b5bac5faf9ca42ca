// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared/input.hpp"

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

/// \file
/// A shot of a campaign and what is kept of it: one row of a CSV file.

namespace figures {

/// What makes one shot differ from another. Names are those of perforate's options.
struct ShotKey {
  std::string method; ///< "sfm", the paper's
  std::string model;
  std::string material;
  std::string nose;
  double thickness_mm = 0;
  double initial_velocity_mps = 0;
  double spacing_mm = 0; ///< particle distance asked for

  auto operator<=>(const ShotKey &) const = default;
};

/// A shot that has been run.
struct ShotRow {
  ShotKey key;
  double residual_velocity_mps = 0;
  double perforated = 0; ///< 1 or 0
  double plug_mass_g = 0;
  double plug_thickness_mm = 0;
  double dishing_mm = 0;
  double kept_fraction = 0;
  double petal_height_mm = 0;
  double band_temperature_K = 0;
  double core_temperature_K = 0;
  double most_temperature_K = 0;
  double hourglass_fraction = 0; ///< of the initial energy, at the end
  double energy_error = 0;
  double momentum_error = 0;
  double largest_intrusion_mm = 0;
  double particles = 0;
  double simulated_us = 0;
  double steps = 0;
  double wall_s = 0;
  double cpu_s = 0;
  double threads = 0;
  std::string state_hash;
  std::string version;
};

/// Calls `f(name, value)` for each column of a row.
template <class Row, class F> void for_each_column(Row &&row, F &&f) {
  f("method", row.key.method);
  f("model", row.key.model);
  f("material", row.key.material);
  f("nose", row.key.nose);
  f("thickness_mm", row.key.thickness_mm);
  f("initial_velocity_mps", row.key.initial_velocity_mps);
  f("spacing_mm", row.key.spacing_mm);
  f("residual_velocity_mps", row.residual_velocity_mps);
  f("perforated", row.perforated);
  f("plug_mass_g", row.plug_mass_g);
  f("plug_thickness_mm", row.plug_thickness_mm);
  f("dishing_mm", row.dishing_mm);
  f("kept_fraction", row.kept_fraction);
  f("petal_height_mm", row.petal_height_mm);
  f("band_temperature_K", row.band_temperature_K);
  f("core_temperature_K", row.core_temperature_K);
  f("most_temperature_K", row.most_temperature_K);
  f("hourglass_fraction", row.hourglass_fraction);
  f("energy_error", row.energy_error);
  f("momentum_error", row.momentum_error);
  f("largest_intrusion_mm", row.largest_intrusion_mm);
  f("particles", row.particles);
  f("simulated_us", row.simulated_us);
  f("steps", row.steps);
  f("wall_s", row.wall_s);
  f("cpu_s", row.cpu_s);
  f("threads", row.threads);
  f("state_hash", row.state_hash);
  f("version", row.version);
}

/// Name of the shot's folder: "mjc_weldox_460e_blunt_12mm_303.5mps_0.6mm".
std::string folder_name(const ShotKey &key);

/// The shot that perforate left in `folder`. Throws SetupError if its summary.json cannot be read or tells of a fault.
ShotRow read_summary(const ShotKey &key, const std::filesystem::path &folder);

/// The rows of a file; none if there is no such file. A last line without its end, of a process that was killed, is
/// passed over. Throws SetupError for a file with other columns or damaged numbers.
std::vector<ShotRow> read_rows(const std::filesystem::path &file);

/// The rows of all files shots*.csv in a folder, shards included, each shot once, in the order of their keys.
std::vector<ShotRow> read_all_rows(const std::filesystem::path &folder);

/// Adds a row at the end of a file, with a header if it is new, and has the disk confirm it. Other processes may do so
/// at the same time. Throws WriteError.
void append_row(const std::filesystem::path &file, const ShotRow &row);

/// The row with this key; null if there is none.
const ShotRow *find_row(const std::vector<ShotRow> &rows, const ShotKey &key);

} // namespace figures
