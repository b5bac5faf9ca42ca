// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options_table.hpp"

/// \file
/// Several plates behind each other in the options.

namespace perforate {

/// Name of the materials of all plates in the name of a folder.
std::string material_label(const Options &options);

/// Forgets what a file says of the plates where a key of the command line says otherwise: one plate or several, and one
/// material or several.
void override_layers(Options &options, Origins &origins, const std::string &key);

/// Brings the lists of several plates to one entry for each plate and each gap, and takes a list of one plate for that
/// plate. Throws SetupError for lists that do not fit together.
void settle_layers(Options &options, const Origins &origins);

} // namespace perforate
