// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// perforate mesh: the model of a case without running it.

namespace perforate {

/// Writes the bodies of the case of a command line whose first argument is "mesh" for ParaView, and prints their sizes
/// and the quality of the hexes. Returns the exit status. Throws ogive::SetupError, ogive::WriteError.
int write_mesh(int argc, const char *const *argv);

} // namespace perforate
