// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/command_line.hpp"

/// \file
/// The subcommands of ogive. Each takes the arguments after its name, returns the exit status and throws
/// ogive::SetupError or ogive::WriteError.

namespace commands {

int calibrate(const options::Arguments &arguments);
int draw(const options::Arguments &arguments);

} // namespace commands
