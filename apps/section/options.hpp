// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/mesh/projectile_shape.hpp"

#include <filesystem>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// \file
/// What a user can choose for `section`, from the command line.

namespace section {

/// Which picture is drawn; the options that choose it must not stand together.
enum class Figure {
  any,         ///< of an option: belongs to all
  panel,       ///< --series
  projectiles, ///< --projectiles
  mesh         ///< --mesh
};

/// What gives the colours of a panel.
enum class Colour { plastic_strain, temperature };

/// The values of the first and of the last colour.
struct Range {
  double low = 0, high = 0;
};

/// What is seen of each section.
struct View {
  double low_mm = 0, high_mm = 0, radius_mm = 0;
};

/// The time of a series' last frame, whenever that is.
inline constexpr double last_time = std::numeric_limits<double>::infinity();

/// One picture, in the units that the names say. What is unset follows from the results that are drawn.
struct Options {
  Figure figure = Figure::panel;
  std::vector<std::filesystem::path> series; ///< .pvd files, or the folders that they lie in
  std::vector<double> times_us{last_time};
  std::vector<std::string> label;
  std::optional<int> columns;
  Colour colour = Colour::plastic_strain;
  std::optional<Range> range;
  std::optional<View> view_mm;
  bool mesh_edges = false;
  std::optional<ogive::Extent> extent; ///< of results that do not tell

  bool projectiles = false;

  bool mesh = false;
  double thickness_mm = 12, spacing_mm = 0.6;
  ogive::Nose nose = ogive::Nose::blunt;

  std::string title;
  std::filesystem::path out;
};

/// Reads the command line (argv[0] is skipped). Returns nothing if --help or --version was asked for and has been
/// written to `text`. Throws ogive::SetupError, one line that names the option, the value and what is allowed. Touches
/// no file.
std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text);

} // namespace section
