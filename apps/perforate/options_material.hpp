// SPDX-License-Identifier: BSD-3-Clause
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

/// A metal as its constants are, with nothing chosen; one of the library with the flow law of the options. Throws
/// SetupError; `origin` is the flag, or file, line and key, that names the file.
material_file::AnyMetal read_metal(const Options &options, const std::string &material, const std::string &origin);

/// The metal of the plate, or of the first one.
material_file::AnyMetal read_metal(const Options &options, const std::string &origin);

/// The materials of all plates, from front to rear.
std::vector<std::string> materials_of(const Options &options);

/// The metals of all plates with the pressure law, damage and failure that the options choose; all have the same flow
/// law. Throws SetupError.
std::vector<material_file::AnyMetal> plates_of(const Options &options);

/// That of the only plate, or of the first one.
material_file::AnyMetal plate_of(const Options &options);

/// The metals of the plates as text for checkpoints: of one as its file has it, or one behind the other.
std::string metals_text(const Options &options, const std::vector<material_file::AnyMetal> &plates);

/// The text of --material list: all metals of the library with their constants and sources.
std::string library_list();

} // namespace perforate
