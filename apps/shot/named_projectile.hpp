// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

/// \file
/// Projectiles by name or from a file: what they give of the options of a projectile.

namespace shot {

/// Options of the group "Projectile" that describe the projectile itself, not its flight.
bool is_of_projectile(std::string_view key);

/// True unless the value of `projectile` is one of the older "deformable" and "rigid".
bool names_projectile(std::string_view value);

/// Names of the library's projectiles.
std::vector<std::string> projectile_names();

/// Title of a projectile of the library, "20 mm fragment simulator"; `name` itself for others.
std::string projectile_title(const std::string &name);

/// True for a projectile of the library that is more than a nose.
bool is_library_projectile(std::string_view name);

/// "one of <names>, or a file that ends in .toml"
std::string allowed_projectiles();

/// The value of `projectile` that was given: a name of the library, a file, "deformable" or "rigid". Throws SetupError.
std::string projectile_given(const options::Given &given);

/// Options that a projectile of the library, or a file, gives; names of files in it are relative to its folder. The
/// name of the file itself is relative to `folder`. Throws SetupError.
Level level_of_projectile(const options::Given &given, const std::filesystem::path &folder);

/// Copies all options that describe the projectile itself.
void copy_projectile(const Options &from, Options &to);

/// Takes back what earlier levels gave of the projectile.
void forget_projectile(Options &options, options::Origins &origins);

/// The library's projectiles with mass, dimensions and source, for the terminal.
std::string projectile_list();

} // namespace shot
