// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <CLI/CLI.hpp>

namespace input {

namespace {

/// Throws the error for a flag without a value.
[[noreturn]] void refuse_missing(const std::string &flag, const std::string &allowed) {
  throw ogive::SetupError(printable(flag) + ": needs a value: " + allowed);
}

/// CLI11 would take a following flag as the value.
void require_values(const std::vector<Flag> &flags, const std::vector<std::string> &arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (const Flag &flag : flags)
      for (const std::string &name : {flag_of(flag.key), flag.alias.empty() ? "" : "--" + flag.alias}) {
        const bool last = i + 1 == arguments.size() || arguments[i + 1].empty() || arguments[i + 1].starts_with("--");
        if (!name.empty() &&
            (arguments[i] == name + "=" || (arguments[i] == name && flag.values != Flag::none && last)))
          refuse_missing(name, flag.allowed);
      }
}

} // namespace

CommandLine read_command_line(const std::string &program, std::vector<Flag> flags, int argc, const char *const *argv) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  const auto *help_flag = app.add_flag("--help,-h");
  const auto *version_flag = app.add_flag("--version");

  // CLI11 takes the command line apart; values are checked later, where the limits are known.
  flags.push_back({"config", "the name of a TOML file"});
  std::vector<const CLI::Option *> options;
  for (const Flag &flag : flags) {
    const std::string name = flag_of(flag.key), names = name + (flag.alias.empty() ? "" : ",--" + flag.alias);
    if (flag.values == Flag::none)
      options.push_back(app.add_flag(name + ",!--no-" + name.substr(2)));
    else if (flag.values == Flag::one)
      options.push_back(app.add_option(names)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast));
    else
      options.push_back(app.add_option(names)->expected(-1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
  }
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  require_values(flags, arguments);
  std::reverse(arguments.begin(), arguments.end());
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError &error) {
    throw ogive::SetupError(printable(error.what()));
  }

  CommandLine line;
  line.help = help_flag->count() > 0;
  line.version = version_flag->count() > 0;
  if (line.help || line.version) return line;
  for (const auto &extra : app.remaining())
    throw ogive::SetupError(printable(extra) + (extra.starts_with("-") ? ": unknown option" : ": unexpected argument") +
                            ", " + program + " --help lists what is allowed");
  for (std::size_t k = 0; k < flags.size(); ++k) {
    if (options[k]->count() == 0) continue;
    const auto &values = options[k]->results();
    if (flags[k].key == "config")
      line.config = values.back();
    else if (flags[k].values == Flag::several)
      for (const auto &value : values) line.given.push_back({flags[k].key, flag_of(flags[k].key), value});
    else
      line.given.push_back({flags[k].key, flag_of(flags[k].key), values.back()});
  }
  return line;
}

std::string help_item(const std::string &flag, const std::string &text) {
  constexpr std::size_t text_column = 34;
  std::string start = "  " + flag;
  if (start.size() >= text_column)
    start += "\n" + std::string(text_column, ' ');
  else
    start.resize(text_column, ' ');
  return broken(start, text, text_column);
}

} // namespace input
