// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

namespace section {

/// Draws sections of stored frames. Throws SetupError for results that are missing, damaged or lack what is asked for,
/// WriteError.
void draw_panel(const Options &options);

/// Draws the projectiles of the paper with their dimensions. Throws WriteError.
void draw_projectiles(const Options &options);

/// Draws the model of a shot before its first step. Throws SetupError for sizes that do not fit together, WriteError.
void draw_mesh(const Options &options);

} // namespace section
