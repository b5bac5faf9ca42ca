// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "ogive/core/spinning.hpp"
#include "ogive/version.hpp"
#include "options/exit_status.hpp"
#include "options/text.hpp"

#include <iostream>

namespace commands {

const std::vector<Subcommand> &subcommands() {
  static const std::vector<Subcommand> all{
      {"shoot", "compute a shot: residual velocity, pictures, files for ParaView", shoot, shoot_table},
      {"limit", "find a ballistic limit and the curve of the residual velocity", limit, limit_table},
      {"sweep", "run a list of shots or limits, resumable, several at a time", sweep, sweep_table},
      {"mesh", "write the model of a shot for ParaView, print its mesh quality", mesh, mesh_table},
      {"calibrate", "fit a metal's flow law to tensile curves", calibrate, calibrate_table},
      {"draw", "draw sections and curves of results", draw, draw_table, false},
      {"view", "write a result as an interactive page for the browser", view, view_table, false},
      {"materials", "list, show, check, import or make metals", materials, materials_table, false},
      {"projectiles", "list the projectiles with their sizes and sources", projectiles, projectiles_table, false}};
  return all;
}

namespace {

std::string help() {
  std::string text = "ogive COMMAND [options]: perforation of metal plates\n\nCommands:\n";
  for (const Subcommand &one : subcommands()) text += options::help_item(one.name, one.purpose);
  text += options::help_item("completion", "print completion for bash: source <(ogive completion)");
  return text + "\nExamples:\n"
                "  ogive shoot\n"
                "  ogive limit --material aa5083_h116 --nose conical --thickness-mm 15\n"
                "  ogive sweep --vary thickness_mm=6,8,10 --limit --out thickness\n\n"
                "ogive COMMAND --help lists the options that most users need, --help-all all of them.\n";
}

int run(const options::Arguments &arguments, std::string &name) {
  const std::string first = arguments.empty() ? "--help" : arguments[0];
  const bool helps = first == "--help" || first == "-h", completes = first == "completion";
  if (helps || completes || first == "--version") {
    std::cout << (helps ? help() : completes ? bash_completion() : std::string("ogive ") + ogive::version + "\n");
    return options::only_printed;
  }
  std::vector<std::string> names{"completion"};
  for (const Subcommand &one : subcommands()) {
    names.emplace_back(one.name);
    if (first != one.name) continue;
    name += std::string(" ") + one.name;
    return one.run({arguments.begin() + 1, arguments.end()});
  }
  throw ogive::SetupError(options::printable(first) + ": unknown command" + options::nearest_text(first, names) +
                          "; ogive --help lists all");
}

} // namespace

} // namespace commands

int main(int argc, char **argv) {
  ogive::limit_spinning(argv);
  std::string name = "ogive";
  return options::run_main(name, [&] { return commands::run({argv + 1, argv + argc}, name); });
}
