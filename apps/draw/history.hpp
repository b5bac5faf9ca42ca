// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

/// \file
/// The projectile's velocity against time, from the history.csv of a shot.

namespace draw {

/// Velocity along the initial line of flight, of the projectile or, if its parts touch, of the part that the verdict is
/// of.
struct History {
  std::vector<double> time_us;
  std::vector<double> velocity_mps;
};

/// The columns time_us and velocity_m_per_s of a history.csv. Throws ogive::SetupError if the file cannot be read,
/// lacks a column or holds something else than numbers there.
History read_history(const std::filesystem::path &file);

/// Velocity at a time (us), m/s, interpolated between rows; before the first and after the last row that of the row.
/// Nothing if there are no rows.
std::optional<double> velocity_at(const History &history, double time_us);

} // namespace draw
