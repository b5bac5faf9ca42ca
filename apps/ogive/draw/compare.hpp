// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

/// \file
/// Two results beside each other.

namespace commands::drawing {

/// A key of case.toml or summary.json whose values differ; a value that a result lacks is empty.
struct Difference {
  std::string key; ///< of what is nested with points between: "layers.0.plug_mass_g"
  std::string first, second;
  std::optional<double> change;  ///< second less first, where both are numbers
  std::optional<double> percent; ///< of the first, where that is not 0
};

/// Differences between the results in two folders, options of the case first. Cost, threads, places of files and
/// differences below 1e-9 of a value are left out. Throws SetupError if a summary.json cannot be read.
std::vector<Difference> differences(const fs::path &first, const fs::path &second);

/// Prints the differences of --compare and writes differences.csv, velocity.svg and sections.png into the folder --out.
/// Pictures that cannot be drawn are reported and left out. Throws SetupError and WriteError.
void compare(const Options &options);

} // namespace commands::drawing
