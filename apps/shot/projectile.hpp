// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

/// \file
/// The projectile of the options: one of the paper's, or with lengths of its own.

namespace shot {

/// Length of the nose, mm, unless the user gives it: that of the paper's, scaled with the diameter.
double default_nose_length_mm(const Options &options);

/// Length from tip to tail, mm, unless the user gives it: with the shank of the paper's, scaled with the diameter.
double default_length_mm(const Options &options);

/// Diameter of the flat at the tip, mm, or width of that of a chisel, unless the user gives it: that of the paper's,
/// scaled with the diameter.
double default_tip_diameter_mm(const Options &options);

/// Name of the projectile in titles and names of folders: of the library, of its profile, or of its nose.
std::string projectile_label(const Options &options);

/// Takes the points of the profile from its file. `folder` is the one that the name counts from. Throws SetupError.
void read_profile(Options &options, const options::Origins &origins, const std::filesystem::path &folder);

/// The projectile of the options, SI units.
ogive::ProjectileShape<double> shape_of(const Options &options);

/// True if the projectile is the one of the tests and strikes as there.
bool is_of_the_tests(const Options &options);

/// True if the projectile pushes a plug out, see ogive::is_sharp().
bool is_blunt(const Options &options);

/// Takes the nose that a profile gives, or reads a mesh. Throws SetupError.
void settle_nose(Options &options, const options::Origins &origins);

/// Takes the lengths that are not given from the paper's projectile, and the length of an ogive from its radius.
/// Throws SetupError.
void settle_projectile(Options &options, const options::Origins &origins);

} // namespace shot
