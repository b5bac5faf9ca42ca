// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "shared/command_line.hpp"

#include <algorithm>
#include <array>

/// \file
/// The one table of the options: names, limits, units, meaning and default. The command line, --help and the checks
/// read it.

namespace section {

using input::Limits;

/// One option. Its flag is `key` with hyphens and two in front.
struct Entry {
  Figure figure; ///< to which it belongs
  const char *key;
  const char *value;    ///< what --help calls its value; empty if it takes none
  const char *allowed;  ///< to complete "must be" or "needs a value:"
  const char *meaning;  ///< for --help
  const char *fallback; ///< the default
  Limits limits{};      ///< of numbers only
};

inline constexpr auto colours = std::to_array<input::Choice<Colour>>(
    {{Colour::plastic_strain, "plastic_strain"}, {Colour::temperature, "temperature"}});
inline constexpr auto extents = std::to_array<input::Choice<ogive::Extent>>(
    {{ogive::Extent::quarter, "quarter"}, {ogive::Extent::half, "half"}, {ogive::Extent::full, "full"}});

inline auto noses() {
  std::array<input::Choice<ogive::Nose>, ogive::all_noses.size()> list;
  std::transform(ogive::all_noses.begin(), ogive::all_noses.end(), list.begin(), [](ogive::Nose nose) {
    return input::Choice<ogive::Nose>{nose, ogive::name(nose)};
  });
  return list;
}

/// Calls `f(entry, value)` for each option, in the order of --help.
template <class O, class F> void for_each_option(O &o, F &&f) {
  constexpr auto panel = Figure::panel, projectiles = Figure::projectiles, mesh = Figure::mesh, any = Figure::any;
  f(Entry{panel, "series", "FOLDER|FILE.pvd...", "folders with a .pvd file, or .pvd files",
          "results of perforate; all times of the first, then of the next", "required"},
    o.series);
  f(Entry{panel,
          "times_us",
          "T,T,...",
          "times in us or last, separated by commas",
          "times in us, or last; the frames nearest to them are drawn",
          "last",
          {0, 1e6, "us"}},
    o.times_us);
  f(Entry{panel, "label", "TEXT...", "a text for each section", "below the sections, one for each",
          "(a) time and velocity, or the folder of each of several series"},
    o.label);
  f(Entry{panel, "columns", "N", "a whole number between 1 and 20", "of sections", "up to 4", {1, 20, ""}}, o.columns);
  f(Entry{panel, "colour", "NAME", "", "what gives the colour: plastic_strain or temperature", "plastic_strain"},
    o.colour);
  f(Entry{panel,
          "range",
          "LOW,HIGH",
          "two numbers separated by a comma, the lower first",
          "values of the first and of the last colour",
          "0,1.5 or 300,900 K",
          {-1e6, 1e6, ""}},
    o.range);
  f(Entry{panel,
          "view_mm",
          "ZMIN,ZMAX,RADIUS",
          "three numbers separated by commas, the second above the first",
          "what is seen; z = 0 is the plate's front face, the projectile flies towards -z",
          "22 mm in front of the plate, and down to the plug; 28 mm on either side",
          {-5000, 5000, "mm"}},
    o.view_mm);
  f(Entry{panel, "mesh_edges", "", "true or false", "thin lines between the hexes", "no"}, o.mesh_edges);
  f(Entry{panel, "extent", "NAME", "", "of results that do not tell it themselves: quarter, half or full", "none"},
    o.extent);

  f(Entry{projectiles, "projectiles", "", "true or false", "draw the paper's projectiles with their dimensions", "no"},
    o.projectiles);

  f(Entry{mesh, "mesh", "", "true or false", "draw the quarter model as it is before the shot", "no"}, o.mesh);
  f(Entry{mesh, "thickness_mm", "X", "", "of the plate", "12", {0.5, 100, "mm"}}, o.thickness_mm);
  f(Entry{mesh, "spacing_mm", "X", "", "particle distance, at most half the thickness", "0.6", {0.05, 5, "mm"}},
    o.spacing_mm);
  f(Entry{mesh, "nose", "NAME", "", "of the projectile", "blunt"}, o.nose);

  f(Entry{any, "title", "TEXT", "a text", "above the picture", "none"}, o.title);
  f(Entry{any, "out", "FILE.png", "the name of a .png file", "the picture", "required"}, o.out);
}

} // namespace section
