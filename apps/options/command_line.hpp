// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "table.hpp"

#include <iosfwd>

/// \file
/// The command line of a program, taken apart; the table's functions then set the values.

namespace options {

/// The arguments after the program's name.
using Arguments = std::vector<std::string>;

/// The texts of a program's help besides its table.
struct Command {
  std::string name;         ///< "ogive shoot"
  std::string purpose;      ///< lines of text below the name
  std::string usage{};      ///< after the name: "[options]"
  std::string examples{};   ///< lines, each indented by two
  std::string more{};       ///< lines at the end of --help-all
  bool config = false;      ///< --config FILE.toml is known
  std::string positional{}; ///< key of the option that takes an argument without a flag; empty: none does
};

/// The options of a command line: the last one of each flag, or all values of a flag that takes several, in the order
/// of the table.
struct CommandLine {
  std::optional<std::string> config;
  std::vector<Given> given;

  /// The last value given for a key; null if there is none.
  const Given *find(std::string_view key) const;
};

/// Reads a command line. Nothing after --help, --help-all or --version, whose text has been written to `text`.
/// Throws SetupError, one line, for unknown flags, superfluous arguments and flags without a value.
std::optional<CommandLine> read_command_line(const Command &command, const Table &table, const Arguments &arguments,
                                             std::ostream &text);

/// Reads a command line as read_command_line() and sets the values of the table. Throws SetupError also for values that
/// the table refuses.
std::optional<CommandLine> read_values(const Command &command, const Table &table, const Arguments &arguments,
                                       std::ostream &text);

/// The help of a program: the options with a brief text, one line each, or all.
std::string help(const Command &command, const Table &table, bool all);

/// A flag and its text for help, broken at blanks and indented to fit 100 columns.
std::string help_item(const std::string &flag, const std::string &text);

} // namespace options
