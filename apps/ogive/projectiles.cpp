// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "options/exit_status.hpp"
#include "shot/named_projectile.hpp"

#include <iostream>

namespace commands {

options::Table projectiles_table() { return {}; }

int projectiles(const options::Arguments &arguments) {
  const options::Table table = projectiles_table();
  const options::Command command{.name = "ogive projectiles",
                                 .purpose = "Lists the projectiles for --projectile with their sizes and sources.\n",
                                 .usage = "",
                                 .examples = "  ogive projectiles\n"};
  if (!options::read_values(command, table, arguments, std::cout)) return options::only_printed;
  std::cout << shot::projectile_list();
  return options::only_printed;
}

} // namespace commands
