// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

namespace commands::drawing {

/// Draws the sections of --series.
void draw_sections(const Options &options);

/// Draws the film of --animate.
void draw_film(const Options &options);

} // namespace commands::drawing
