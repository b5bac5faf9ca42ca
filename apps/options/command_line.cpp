// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include "ogive/version.hpp"

#include <CLI/CLI.hpp>

#include <cstring>
#include <ostream>

namespace options {

namespace {

/// Column in which the texts of a help begin, and width of the help.
constexpr std::size_t text_column = 34, width = 100;

/// Group of what every program has; programs may add to it.
constexpr char general[] = "General";

std::vector<std::string> flags_of(const Option &option) {
  std::vector<std::string> flags{flag_of(option.key)};
  if (*option.alias != 0) flags.push_back(flag_of(option.alias));
  return flags;
}

/// CLI11 would take a following flag as the value.
void require_values(const Table &table, const Arguments &arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (const Option &option : table.options)
      for (const std::string &flag : flags_of(option)) {
        const bool last = i + 1 == arguments.size() || arguments[i + 1].empty() || arguments[i + 1].starts_with("--");
        if (arguments[i] == flag + "=" || (arguments[i] == flag && option.values != Values::none && last))
          throw ogive::SetupError(printable(flag) + ": needs a value: " + option.allowed_text);
      }
}

[[noreturn]] void refuse_extra(const Command &command, const Table &table, const std::string &extra) {
  const std::string help = "; " + command.name + " --help-all lists what is allowed";
  if (!extra.starts_with("-")) throw ogive::SetupError(printable(extra) + ": unexpected argument" + help);
  std::vector<std::string> known{"--help", "--help-all", "--version"};
  if (command.config) known.emplace_back("--config");
  for (const Option &option : table.options) {
    for (const std::string &flag : flags_of(option)) known.push_back(flag);
    if (option.values == Values::none) known.push_back(no_flag_of(option.key));
  }
  const std::string flag = extra.substr(0, extra.find('='));
  throw ogive::SetupError(printable(flag) + ": unknown option" + nearest_text(flag, known) + help);
}

} // namespace

const Given *CommandLine::find(std::string_view key) const {
  const auto found = std::find_if(given.rbegin(), given.rend(), [&](const Given &g) { return g.key == key; });
  return found == given.rend() ? nullptr : &*found;
}

std::optional<CommandLine> read_command_line(const Command &command, const Table &original, const Arguments &all,
                                             std::ostream &text) {
  CommandLine line;
  Table table = original;
  table.group = general;
  if (command.config)
    add(table, line.config,
        {.key = "config",
         .meaning = "a TOML file with options, its keys the flags with underscores; the command line overrides it",
         .allowed = "the name of a TOML file",
         .in_file = false})
        .placeholder = "FILE.toml";

  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  const auto *help_flag = app.add_flag("--help,-h"), *all_flag = app.add_flag("--help-all"),
             *version_flag = app.add_flag("--version");
  // CLI11 takes the command line apart; values are checked later, where the limits are known.
  std::vector<const CLI::Option *> options;
  for (const Option &option : table.options) {
    const std::string names = joined(flags_of(option), ",");
    const bool several = option.values == Values::several;
    if (option.values == Values::none)
      options.push_back(app.add_flag(names + ",!" + no_flag_of(option.key)));
    else
      options.push_back(
          app.add_option(names)
              ->expected(several ? -1 : 1)
              ->multi_option_policy(several ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast));
  }
  require_values(table, all);
  try {
    app.parse(Arguments(all.rbegin(), all.rend()));
  } catch (const CLI::ParseError &error) {
    throw ogive::SetupError(printable(error.what()));
  }

  if (version_flag->count() > 0)
    text << command.name << " " << ogive::version << "\n";
  else if (help_flag->count() + all_flag->count() > 0)
    text << help(command, table, all_flag->count() > 0);
  if (version_flag->count() + help_flag->count() + all_flag->count() > 0) return std::nullopt;

  for (const auto &extra : app.remaining()) {
    if (command.positional.empty() || extra.starts_with("-")) refuse_extra(command, table, extra);
    line.given.push_back({command.positional, command.positional, extra});
  }
  for (std::size_t k = 0; k < table.options.size(); ++k) {
    if (options[k]->count() == 0) continue;
    const Option &option = table.options[k];
    const auto &values = options[k]->results();
    const std::size_t first = option.values == Values::several ? 0 : values.size() - 1;
    for (std::size_t v = first; v < values.size(); ++v) {
      const Given given{option.key, flag_of(option.key), values[v]};
      if (given.key == std::string_view("config") && command.config)
        option.assign(given);
      else
        line.given.push_back(given);
    }
  }
  return line;
}

std::optional<CommandLine> read_values(const Command &command, const Table &table, const Arguments &arguments,
                                       std::ostream &text) {
  auto line = read_command_line(command, table, arguments, text);
  Origins origins;
  if (line)
    for (const Given &given : line->given) apply(table, origins, given);
  return line;
}

std::string help_item(const std::string &flag, const std::string &text) {
  std::string start = "  " + flag;
  if (start.size() >= text_column) start += "\n" + std::string(text_column, ' ');
  start.resize(std::max(start.size(), text_column), ' ');
  return broken(start, text, text_column);
}

std::string help(const Command &command, const Table &table, bool all) {
  std::string text = command.name + (command.usage.empty() ? "" : " " + command.usage) + "\n" + command.purpose;
  if (all) text += "In brackets: the default, and its source.\n";
  std::string group = "\n";
  std::size_t hidden = 0;
  for (const Option &option : table.options) {
    hidden += *option.brief == 0 ? 1 : 0;
    if (!all && *option.brief == 0) continue;
    if (group != option.group)
      text += (all && !option.group.empty()) ? "\n" + option.group + ":\n" : group == "\n" ? "\n" : "";
    group = option.group;
    const std::string placed = flag_of(option.key) + (option.placeholder.empty() ? "" : " " + option.placeholder);
    // The folder of the results follows from the case.
    const std::string source = option.source, value = option.kind == Kind::file ? "" : shown(option);
    const std::string fallback =
        source.find(':') != std::string::npos ? source : value + (value.empty() || source.empty() ? "" : ": ") + source;
    if (all) {
      text += help_item(placed, option.meaning + option.range + (fallback.empty() ? "" : " [" + fallback + "]"));
    } else {
      const std::string first = option.kind == Kind::file ? "" : fallback.substr(0, fallback.find(':')),
                        shown_value = first.empty() || first == "none" ? "" : " [" + first + "]";
      const bool has_room = text_column + std::strlen(option.brief) + shown_value.size() <= width;
      text += help_item(placed, option.brief + (has_room ? shown_value : ""));
    }
  }
  if (all)
    text += (group == general ? "" : "\n" + std::string(general) + ":\n") +
            help_item("--version", "print the version") +
            help_item("--help", "print the options that most users need") + help_item("--help-all", "print this text");
  else if (hidden > 0)
    text += help_item("--help-all", "all options, " + std::to_string(hidden) + " more, with their sources");
  if (!command.examples.empty()) text += "\nExamples:\n" + command.examples;
  if (all && !command.more.empty()) text += "\n" + command.more;
  return text;
}

} // namespace options
