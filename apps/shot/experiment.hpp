// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// The tests that computed shots are compared with, read from the tables in apps/data.

namespace experiment {

/// Rows of a table without its header; empty if the file cannot be read.
std::vector<std::vector<std::string>> read_rows(const std::filesystem::path &file);

/// A plate and a nose.
struct Specimen {
  std::string metal, nose; ///< "Weldox 460 E", "blunt"
  double thickness_mm = 0;

  auto operator<=>(const Specimen &) const = default;
};

/// A measured shot.
struct Shot {
  double initial_mps = 0, residual_mps = 0;
  std::string source;
};

std::vector<Shot> find_shots(const Specimen &specimen);

/// A measured ballistic limit, and Recht and Ipson's curve through it: a (v^p - limit^p)^(1/p).
struct Limit {
  double limit_mps = 0, a = 1, p = 2;
  std::string source{};
};

std::optional<Limit> find_limit(const Specimen &specimen);

/// Half of the gap between stopped and perforating shots of a measured limit (apps/data/README.md).
inline constexpr double limit_half_width_mps = 5;

/// The paper's strike velocity close to its own limit, Fig. 10.
std::optional<double> find_paper_velocity(const Specimen &specimen);

/// A residual velocity to compare with and its source.
struct Residual {
  double residual_mps = 0;
  std::string origin;
};

/// The measured shot of this metal, nose, thickness and velocity (to 0.5 m/s), else the Recht-Ipson curve through the
/// measured ballistic limit, else nothing.
std::optional<Residual> find_residual(const std::string &metal, const std::string &nose, double thickness_mm,
                                      double velocity_mps);

} // namespace experiment
