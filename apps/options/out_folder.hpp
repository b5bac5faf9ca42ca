// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace options {

/// Creates the folder `out` and proves with a small file of its own, removed at once, that it can be written to and has
/// room for `bytes`. Leaves what is there untouched. Throws ogive::SetupError, one line that begins with --out, and
/// then leaves no new folder behind. `hint` names options that need less space. Returns the new folders, the outermost
/// first.
std::vector<std::filesystem::path> prepare_out(const std::filesystem::path &out, double bytes, const char *hint = "");

/// Removes those of the folders that are empty.
void remove_empty(const std::vector<std::filesystem::path> &folders);

/// Renames a folder with results that another run would overwrite to the first free of OUT_before_1, OUT_before_2, ...
/// and returns that name. Throws SetupError "--out = OUT: <reason>; give another --out, or remove them" if it cannot.
std::filesystem::path set_aside(const std::filesystem::path &out, const std::string &reason);

} // namespace options
