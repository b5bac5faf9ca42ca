// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/command_line.hpp"
#include "shot/options.hpp"

#include <tuple>

/// \file
/// The subcommands of ogive. Each returns its exit status, options::only_printed after help. Each throws SetupError for
/// wrong input, before anything is run or overwritten, and WriteError.

namespace commands {

/// A subcommand: its name, one line of purpose, its main function, and its table for completion.
struct Subcommand {
  const char *name;
  const char *purpose;
  int (*run)(const options::Arguments &arguments);
  options::Table (*table)();
  bool config = true; ///< takes --config FILE.toml
};

/// All subcommands in the order of the help.
const std::vector<Subcommand> &subcommands();

/// A script with which bash completes subcommands, their options and the names that an option may have.
std::string bash_completion();

int shoot(const options::Arguments &arguments);
int limit(const options::Arguments &arguments);
int sweep(const options::Arguments &arguments);
int mesh(const options::Arguments &arguments);
int materials(const options::Arguments &arguments);
int projectiles(const options::Arguments &arguments);
int draw(const options::Arguments &arguments);
int view(const options::Arguments &arguments);
int calibrate(const options::Arguments &arguments);

/// A table by its names alone: there are no values behind it.
template <class... Values> options::Table unbound(options::Table (*table_of)(Values &...)) {
  std::tuple<Values...> values;
  return std::apply(table_of, values);
}

options::Table shoot_table();
options::Table limit_table();
options::Table sweep_table();
options::Table mesh_table();
options::Table materials_table();
options::Table projectiles_table();
options::Table draw_table();
options::Table view_table();
options::Table calibrate_table();

/// The command line of `ogive shoot`.
struct ShootCommand {
  shot::Options shot;
  std::filesystem::path film; ///< of --animate; empty: none
};

/// Reads the options of `ogive shoot`; nothing for --help and --version, whose answer has been written to `text`.
/// Throws SetupError.
std::optional<ShootCommand> parse_shoot(const options::Arguments &arguments, std::ostream &text);

/// Exit statuses, for --help-all.
extern const char *const exit_statuses;

} // namespace commands
