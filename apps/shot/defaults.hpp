// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

namespace shot {

/// Sets the values that were not given, by method, nose and material: damage and its parameters, bonds, failure,
/// friction, end of the run.
void take_defaults(Options &options, const options::Origins &given);

/// The default of --damage: that of the method, none where a metal has no failure strain.
DamageLaw default_damage(const Options &options);

/// The default of --failure: no tension where damage grows. Our choice.
FailureEffect default_failure(DamageLaw damage);

/// vtk_out/<case_label>
std::filesystem::path default_out(const Options &options);

/// <material, or the stem of its file>_<model>_<nose>_<thickness>mm_<velocity>mps, with diameter, obliquity and method
/// where they are not the default, and "_key=value" of every other option that makes the case another one. A
/// velocity below 0 is left out.
std::string case_label(const Options &options);

/// The thicknesses of the plates and the gaps between them, for titles and folders: "12mm"; "6+6mm",
/// "4+8mm_10mm_apart".
std::string thickness_label(const Options &options);

/// End of a run that decides nothing before, us: the time in which the projectile passes the plates three times at its
/// initial velocity, six times where its tail must leave them; at least 500 or 1500 us for 20 mm, in which all but the
/// slowest shots are decided.
double default_end_us(const Options &options);

} // namespace shot
