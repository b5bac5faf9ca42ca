// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

/// \file
/// The parts of a projectile and their metals.

namespace shot {

/// A metal of a part: "core=lead" in the options.
struct PartMetal {
  std::string part;
  std::string metal; ///< a name of the library, or a file that ends in .toml
};

/// The part and the metal of an entry of Options::part_metals.
PartMetal part_metal_of(const std::string &entry);

/// An entry of Options::part_metals.
std::string entry_of(const PartMetal &part);

/// Adds the options of the parts to the table, bound to `o`.
void add_parts(options::Table &table, Options &o);

/// The tables [part.NAME] of a projectile's file as the entries of part_metals. Throws SetupError.
options::Given part_metals_given(const options::Given &tables);

/// Names of the parts of the projectile, from the outside in, or in the order of the mesh's file.
std::vector<std::string> parts_of(const Options &options);

/// Names of the metals of the parts, in the order of parts_of().
std::vector<std::string> part_materials(const Options &options);

/// The names of the metals of all parts for people: "gilding_metal+lead+apm2_core_steel".
std::string part_metals_label(const Options &options);

/// Throws SetupError unless every entry of part_metals is of a part that the projectile has. Forgets the file of a
/// metal that no part is made of.
void settle_parts(Options &options, const options::Origins &origins);

/// Names of the files of the parts' metals in the folder of the results, in the order of parts_of().
std::vector<std::string> part_metal_files(const Options &options);

} // namespace shot
