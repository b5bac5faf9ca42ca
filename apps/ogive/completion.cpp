// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

namespace commands {

std::string bash_completion() {
  std::string names, cases;
  for (const Subcommand &one : subcommands()) {
    names += (names.empty() ? "" : " ") + std::string(one.name);
    std::string flags = std::string("--help --help-all --version") + (one.config ? " --config" : ""), values;
    const options::Table table = one.table();
    for (const options::Option &option : table.options) {
      const std::string flag = options::flag_of(option.key);
      flags += " " + flag;
      if (option.values == options::Values::none) flags += " " + options::no_flag_of(option.key);
      if (option.names.empty()) continue;
      values += "      " + flag + ") words='" + options::joined(option.names, " ") + "' ;;\n";
    }
    cases += "  " + std::string(one.name) + ")\n    words='" + flags + "'\n";
    if (!values.empty()) cases += "    case $before in\n" + values + "    esac\n";
    cases += "    ;;\n";
  }
  return "# Completion of ogive for bash; made by `ogive completion`.\n"
         "_ogive() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=''\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    words='" +
         names +
         " completion --help --version'\n"
         "  else\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _ogive ogive\n";
}

} // namespace commands
