// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/frame.hpp"

#include <filesystem>
#include <string>

namespace draw {

/// Draws a model before its first step as a PNG: the part that is computed, seen from outside, and the section at the
/// impact point. Throws ogive::WriteError.
void render_model(const ogive::Frame &frame, const std::string &title, const std::filesystem::path &path);

} // namespace draw
