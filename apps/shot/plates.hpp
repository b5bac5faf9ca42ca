// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

/// \file
/// The plates of the options, one or several behind each other, and their metals.

namespace shot {

/// The metals of all plates, from front to rear; all have the same flow law.
using Plates = std::vector<materials::AnyMetal>;

using options::joined;

/// Name of the materials of all plates in the name of a folder.
std::string material_label(const Options &options);

/// The materials of all plates, from front to rear.
std::vector<std::string> materials_of(const Options &options);

/// Forgets what an earlier level gives for the plates where a key of a later one contradicts it: one plate or several,
/// and one material or several.
void override_layers(Options &options, options::Origins &origins, const std::string &key);

/// Brings the lists of several plates to one entry for each plate and each gap, and takes a list of one plate for that
/// plate. Throws SetupError for lists that do not fit together.
void settle_layers(Options &options, const options::Origins &origins);

/// Takes the flow law of material files and checks that all materials have the constants that the options need. Throws
/// SetupError.
void settle_materials(Options &options, const options::Origins &origins);

/// False if a plate's metal has no constants of the failure strain; true, too, if it cannot be read, which others
/// report.
bool have_failure_strains(const Options &options);

/// The metals of all plates with the pressure law, damage and failure that the options choose. Throws SetupError.
Plates plates_of(const Options &options);

/// The metals of the projectile's parts, without damage. Throws SetupError.
Plates projectile_metals_of(const Options &options);

/// Warnings about a case, a line for each: the flow stress, bands of shear and constants of damage of its metals, its
/// velocity, and options outside of the tested range.
std::vector<std::string> doubts_of(const Options &options, const Plates &plates);

/// The metals of the plates as text for checkpoints: of one as its file has it, or one behind the other; and those of
/// the projectile's parts if one is of a file.
std::string metals_text(const Options &options, const Plates &plates);

} // namespace shot
