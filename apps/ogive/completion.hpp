// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands.hpp"

namespace commands {

/// A script with which bash completes subcommands, their options and the names that an option may have.
std::string bash_completion(const std::vector<Subcommand> &subcommands);

} // namespace commands
