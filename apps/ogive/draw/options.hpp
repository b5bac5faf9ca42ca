// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "draw/scene.hpp"
#include "options/table.hpp"

#include "ogive/core/symmetry.hpp"

#include <array>
#include <limits>

/// \file
/// The options of `ogive draw`.

namespace draw {

/// The names of the directions of view.
inline auto choices(Seen) {
  return options::named<Seen>({{Seen::section, "section"}, {Seen::oblique, "oblique"}, {Seen::behind, "behind"}});
}

} // namespace draw

namespace commands::drawing {

namespace fs = std::filesystem;

/// Denotes the time of a series' last frame.
inline constexpr double last_time = std::numeric_limits<double>::infinity();

/// Quantities that colour the sections.
enum class Colour { plastic_strain, temperature };
/// The names of the quantities.
inline auto choices(Colour) {
  return options::named<Colour>({{Colour::plastic_strain, "plastic_strain"}, {Colour::temperature, "temperature"}});
}

/// One picture, in the units of the names. What is unset follows from the results that are drawn.
struct Options {
  std::vector<fs::path> series; ///< .pvd files, or the folders that they lie in
  std::vector<double> times_us{last_time};
  std::optional<int> columns;
  Colour colour = Colour::plastic_strain;
  std::optional<std::array<double, 2>> range;   ///< values of the first and of the last colour
  std::optional<std::array<double, 3>> view_mm; ///< lowest and highest z, radius
  bool mesh_edges = false;
  draw::Seen from = draw::Seen::section;
  std::optional<int> pixels; ///< width of the page at most
  fs::path animate;          ///< a film in the place of a picture
  int frames = 50;
  double frames_per_second = 8;
  std::optional<ogive::Extent> extent; ///< of results whose files do not hold it

  std::vector<fs::path> velocity; ///< history.csv files, or the folders that they lie in
  std::optional<double> measured_mps;

  std::vector<fs::path> compare; ///< two folders of results

  bool projectiles = false;

  fs::path mesh; ///< as series; its first frame

  std::vector<std::string> label;
  std::string title;
  fs::path out;
};

/// The table of the options.
options::Table table_of(Options &options);

/// Throws SetupError for options that do not go together.
void check(const Options &options);

} // namespace commands::drawing
