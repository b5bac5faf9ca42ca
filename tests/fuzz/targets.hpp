// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// \file
/// The readers that are tried. Each function has a source of its name; `fuzz.cpp` makes it a target of libFuzzer,
/// `replay.cpp` tries files with it.

namespace fuzz {

/// Gives the bytes to a reader. SetupError is how readers refuse what they cannot take; anything else that they throw
/// leaves this function, and what must not be ends the program.
using TryInput = void(std::string_view bytes);

TryInput try_curve_table, try_mesh_inp, try_mesh_k, try_profile;
// Readers of the programs.
TryInput try_card, try_case_file, try_checkpoint_file, try_checkpoint_notes, try_checkpoint_state, try_material_file,
    try_prediction;

} // namespace fuzz
