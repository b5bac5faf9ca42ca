// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material_file.hpp"

#include <vector>

/// \file
/// The metals of the plates that the programs know by name.

namespace materials {

/// A metal of the library.
struct LibraryMetal {
  std::string_view name;                   ///< as the user writes it
  std::string_view title;                  ///< the name of the trade, also in the tables of tests
  double sharp_friction = 0;               ///< Coulomb, for noses that are not blunt, with the method of the paper
  AnyMetal (*make)(Model model) = nullptr; ///< null: it is in a file of the data folder, which has its model
};

/// The metal of the library with this name; null if there is none.
const LibraryMetal *find_library_metal(std::string_view name);

/// The names of the library.
std::vector<std::string> library_names();

/// True if the user means a file: its name ends in .toml.
bool is_material_file(std::string_view material);

/// True if the material has one flow law, which the user cannot choose: a file, or a metal of the library that is in
/// one.
bool has_own_model(std::string_view material);

/// The file of a metal of the library that is in one.
std::filesystem::path file_of(const LibraryMetal &metal);

/// "a metal that ogive materials lists, or a file that ends in .toml"
std::string allowed_materials();

/// Name of the material in the name of a folder: of a file its stem.
std::string label_of(const std::string &material);

/// The names of the metals of projectiles, which have one flow law each.
std::vector<std::string> projectile_metal_names();

/// True for a file, and for the name of a metal that a plate or a projectile may have.
bool is_known(std::string_view material);

/// "one of <names>, or ..." with allowed_materials(): metals that a projectile may have, its own and those of plates.
std::string allowed_projectile_metals();

/// A metal as its constants are, with nothing chosen; one of the library with this flow law where it can have several,
/// or one of the projectiles. Throws SetupError; `origin` is the flag, or file, line and key, that names the file.
AnyMetal find_metal(const std::string &material, Model model, const std::string &origin);

/// A line for each metal of the library and of the projectiles, at most 100 columns: name, flow laws, constants of
/// damage, confidence.
std::string library_list();

} // namespace materials
