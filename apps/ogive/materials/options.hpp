// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cards/units.hpp"
#include "materials/material_file.hpp"
#include "options/command_line.hpp"

/// \file
/// The options of `ogive materials`.

namespace metals {

/// Actions of the command.
enum class Action { list, show, check, import, from_tensile };

/// The law of a mill certificate.
enum class Hardening { power_law, voce };
constexpr auto choices(Hardening) {
  return options::named<Hardening>({{Hardening::power_law, "power_law"}, {Hardening::voce, "voce"}});
}

/// One call, in the units of the names. What is unset has no default, or one that follows from the rest.
struct Options {
  Action action = Action::list;
  std::vector<std::string> names; ///< metals or files that the action is for

  materials::Model model = materials::Model::mjc;
  std::filesystem::path plot;

  std::optional<cards::Units> units;
  std::filesystem::path out;
  std::string name;

  std::optional<double> yield_mpa, uts_mpa, young_gpa;
  std::optional<double> elongation_pct, uniform_elongation_pct, reduction_of_area_pct;
  Hardening law = Hardening::power_law;
  std::string like;
};

/// Reads the arguments of the command. Nothing after --help, whose text has been written. Throws SetupError.
std::optional<Options> parse(const options::Arguments &arguments);

/// The options of the command; `words` gets the action and its names.
options::Table table_of(Options &options, std::vector<std::string> &words);

/// Draws flow curves and the failure strain of a metal, and writes their points to two tables beside the picture.
/// Throws ogive::WriteError.
void draw_metal(const materials::AnyMetal &metal, const std::string &title, const std::filesystem::path &picture);

} // namespace metals
