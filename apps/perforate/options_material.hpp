#pragma once

#include "options.hpp"

#include <string>
#include <string_view>

/// \file
/// The metal of the plate: from the library or from a file.

namespace perforate {

/// A metal of the library.
struct LibraryMetal {
  std::string_view name;      ///< as the user writes it
  std::string_view test_name; ///< in the tables of tests
  double sharp_friction = 0;  ///< Coulomb, for noses that are not blunt
  material_file::AnyMetal (*make)(FlowModel model);
};

/// The metal of the library with this name; null if there is none.
const LibraryMetal *find_library_metal(std::string_view name);

/// True if the user means a file: its name ends in .toml.
bool is_material_file(std::string_view material);

/// "one of <names>, or a file that ends in .toml"
std::string allowed_materials();

/// Name of the material in the name of a folder: of a file its stem.
std::string label_of(const std::string &material);

/// The metal of the options as its constants are, with nothing chosen. Throws SetupError; `origin` is the flag, or
/// file, line and key, that names the file.
material_file::AnyMetal read_metal(const Options &options, const std::string &origin);

/// The metal of the plate with the pressure law, damage and failure that the options choose. Throws SetupError.
material_file::AnyMetal plate_of(const Options &options);

/// The text of --material list: all metals of the library with their constants and sources.
std::string library_list();

} // namespace perforate
