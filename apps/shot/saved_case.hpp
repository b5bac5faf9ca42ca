// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

/// \file
/// The part of a checkpoint from which its model is built.

namespace shot {

/// First entries in the notes of a checkpoint.
struct SavedCase {
  std::string program;    ///< "ogive shoot"
  std::string version;    ///< of ogive
  std::string case_toml;  ///< all options
  std::string metal_toml; ///< the plate's metal
  double time_us = 0;
};

/// Calls `f(value)` for each value: the list that writes and reads.
template <class F> void for_each_field(SavedCase &saved, F &&f) {
  f(saved.program), f(saved.version), f(saved.case_toml), f(saved.metal_toml), f(saved.time_us);
}

/// The case in a checkpoint file. Throws SetupError, one line, for a file that cannot be read, is damaged or was not
/// written by ogive shoot.
SavedCase read_saved_case(const std::filesystem::path &file);

} // namespace shot
