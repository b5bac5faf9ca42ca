// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// The command line of a program, taken apart but not judged.

namespace input {

/// The flag of a key: thickness_mm is --thickness-mm.
inline std::string flag_of(std::string_view key) {
  std::string flag = "--" + std::string(key);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// A flag that a program knows.
struct Flag {
  enum Values {
    none, ///< --flag, --no-flag or --flag=true
    one,
    several
  };
  std::string key;
  std::string allowed; ///< to complete "needs a value:"
  Values values = one;
  std::string alias{}; ///< another name, without hyphens in front; empty if there is none
};

/// What the command line says: the last one of each flag, or all values of a flag that takes several, in the order of
/// the flags.
struct CommandLine {
  bool help = false;
  bool version = false;
  std::optional<std::string> config;
  std::vector<Given> given;
};

/// Reads the command line (argv[0] is skipped) of `program`; --help, -h, --version and --config are known always.
/// Throws SetupError, one line, for unknown flags, superfluous arguments and flags without a value.
CommandLine read_command_line(const std::string &program, std::vector<Flag> flags, int argc, const char *const *argv);

/// A flag and its text for --help, broken at blanks and indented to fit 100 columns.
std::string help_item(const std::string &flag, const std::string &text);

} // namespace input
