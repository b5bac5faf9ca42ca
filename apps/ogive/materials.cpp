// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "materials/library.hpp"
#include "materials/material_keys.hpp"
#include "options/exit_status.hpp"
#include "options/text.hpp"

#include <iostream>

namespace commands {

namespace {

// clang-format off
options::Table table_of(std::vector<std::string> &words, ::materials::Model &model) {
  options::Table t;
  options::add(t, words, {.key = "action", .meaning = "list, show NAME..., or check FILE.toml...",
      .source = "list: ours", .brief = "list, show NAME... or check FILE.toml...",
      .allowed = "list, show or check", .in_file = false});
  options::add(t, model, {.key = "model", .meaning = "flow law of a metal of the library that is shown",
      .source = "paper", .brief = "flow law of a metal that is shown: mjc or jc", .in_file = false});
  return t;
}
// clang-format on

/// Prints a metal as a file for --material.
void show(const std::string &name, ::materials::Model model) {
  using namespace ::materials;
  const auto steels = projectile_metal_names();
  const bool of_projectile = std::find(steels.begin(), steels.end(), name) != steels.end();
  if (!is_material_file(name) && !of_projectile && find_library_metal(name) == nullptr)
    throw ogive::SetupError("show = " + options::printable(name) + ": must be " + allowed_projectile_metals() +
                            options::nearest_text(name, library_names()));
  if (find_library_metal(name) != nullptr && model == Model::bilinear)
    throw ogive::SetupError("model = bilinear: must be mjc or jc for " + name);
  std::cout << to_toml(find_metal(name, model, "show"),
                       name + "\nA copy with other numbers is a metal for --material.");
}

} // namespace

options::Table materials_table() { return unbound(table_of); }

int materials(const options::Arguments &arguments) {
  std::vector<std::string> words;
  ::materials::Model model = ::materials::Model::mjc;
  const options::Table table = table_of(words, model);
  const options::Command command{
      .name = "ogive materials",
      .purpose = "Lists the metals of the library with their constants and sources, prints one as a file to copy, or\n"
                 "checks files of your own.\n",
      .usage = "[list | show NAME... | check FILE.toml...]",
      .examples = "  ogive materials show weldox_460e\n  ogive materials check my_steel.toml\n",
      .positional = "action"};
  const auto line = options::read_values(command, table, arguments, std::cout);
  if (!line) return options::success;
  const std::string action = words.empty() ? "list" : words.front();
  const std::vector<std::string> names(words.begin() + (words.empty() ? 0 : 1), words.end());
  const std::vector<std::string> actions{"list", "show", "check"};
  if (std::find(actions.begin(), actions.end(), action) == actions.end())
    throw ogive::SetupError(options::printable(action) + ": must be list, show or check" +
                            options::nearest_text(action, actions));
  if ((action == "list") != names.empty())
    throw ogive::SetupError(action + (action == "list" ? ": takes no names" : ": needs the names of metals or files"));
  if (action == "list") std::cout << ::materials::library_list();
  if (action == "show")
    for (const std::string &name : names) show(name, model);
  if (action == "check")
    for (const std::string &name : names) {
      const auto metal = ::materials::read(name, "check");
      std::cout << name << ": " << ::materials::name_of(metal) << ", model "
                << ::materials::name_of(::materials::model_of(metal)) << ", is a metal for --material\n";
      for (const std::string &doubt : ::materials::doubts_of(metal)) std::cout << "warning: " << doubt << "\n";
    }
  return options::success;
}

} // namespace commands
