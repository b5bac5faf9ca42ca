// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace draw {

/// Draws the projectiles of the paper to scale, with their dimensions and masses, as a PNG or SVG. Throws
/// ogive::WriteError.
void render_projectiles(const std::string &title, const std::filesystem::path &path);

} // namespace draw
