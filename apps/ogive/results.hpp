// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "draw/frame_facts.hpp"
#include "options/table.hpp"

#include "ogive/core/symmetry.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// \file
/// Results of shots as users name them: folders, or the files in them.

namespace commands {

/// The name of the folder that holds a file.
std::string folder_name(const std::filesystem::path &file);

/// The .pvd file that is meant: the one in a folder, or the file itself. Throws SetupError, which names `flag`.
std::filesystem::path find_pvd(const std::filesystem::path &given, const char *flag);

/// Adds the option --extent: the part that is computed, of results whose files do not hold it.
void add_extent(options::Table &table, std::optional<ogive::Extent> &extent);

/// The symmetry of results whose files do not hold it.
std::optional<ogive::SymmetryPlanes> symmetry_of(const std::optional<ogive::Extent> &extent);

/// The case of a folder with a summary.json, see shot::title_of(); otherwise the folder's name.
std::string case_title(const std::filesystem::path &folder);

/// The motion of the projectile of a folder with a history.csv; empty without. A summary.json gives the part that it is
/// of. Throws SetupError for a history that cannot be read.
draw::Motion motion_of(const std::filesystem::path &folder);

} // namespace commands
