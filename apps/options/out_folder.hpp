// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace options {

/// Creates the folder `out` and proves with a small file of its own, removed at once, that it can be written to and has
/// room for `bytes`. Leaves what is there untouched. Throws ogive::SetupError, one line that begins with --out, and
/// then leaves no new folder behind. `hint` says what needs less room. Returns the new folders, the outermost first.
std::vector<std::filesystem::path> prepare_out(const std::filesystem::path &out, double bytes, const char *hint = "");

/// Removes those of the folders that are empty.
void remove_empty(const std::vector<std::filesystem::path> &folders);

} // namespace options
