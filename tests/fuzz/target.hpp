// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// \file
/// What a reader is tried with. Each target is one source that defines `try_input`; `fuzz.cpp` makes it a target of
/// libFuzzer, `replay.cpp` a program that tries files.

namespace fuzz {

/// Gives the bytes to a reader. SetupError is how readers refuse what they cannot take; anything else that they throw
/// leaves this function, and what must not be ends the program.
void try_input(std::string_view bytes);

} // namespace fuzz
