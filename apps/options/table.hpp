// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toml_file.hpp"

#include <functional>
#include <map>

/// \file
/// The table of a program's options. Command line, TOML files, help and completion all read it.

namespace options {

/// Number of values that follow a flag: `none` is --flag, --no-flag or --flag=true.
enum class Values { none, one, several };

/// Types of values.
enum class Kind { number, whole, truth, choice, text, file, numbers, texts, other };

/// The texts about one option. The flag is `key` with hyphens and two in front.
struct Entry {
  const char *key = "";
  const char *meaning = ""; ///< for --help-all
  const char *source = "";  ///< of the default; with a colon in it, it states the default too
  const char *brief = "";   ///< one line for --help; empty: in --help-all only
  Limits limits{};          ///< of numbers only
  const char *alias = "";   ///< another key on the command line
  const char *allowed = ""; ///< completes "must be"; empty: by limits or names
  bool in_file = true;      ///< also a key of TOML files and a column of cases
};

/// One option, bound to the value that it sets.
struct Option : Entry {
  std::string group;
  Kind kind = Kind::other;
  Values values = Values::one;
  std::string placeholder;                   ///< "X", "NAME"; empty for a flag
  std::string allowed_text;                  ///< completes "must be" and "needs a value:"
  std::string range;                         ///< of help: "; 0.5 to 100 mm"
  std::vector<std::string> names{};          ///< of a choice
  std::function<void(const Given &)> assign; ///< throws SetupError
  std::function<std::string()> toml;         ///< the value as TOML; empty where unset
};

/// All options in the order of the help.
struct Table {
  std::vector<Option> options{};
  std::string group{}; ///< of those added next
};

/// Origin of each value by its key: the flag, or file, line and key.
using Origins = std::map<std::string, std::string>;

/// The flag of a key: thickness_mm is --thickness-mm.
std::string flag_of(std::string_view key);

/// The flag that turns an option without a value off: vtk is --no-vtk.
std::string no_flag_of(std::string_view key);

/// Origin of the value of a key; its flag if the value was not given.
std::string origin_of(const Origins &origins, const std::string &key);

/// Adds an option of `kind`; the caller sets what depends on the type.
Option &add_option(Table &table, const Entry &entry, Kind kind, const char *placeholder);

Option &add(Table &table, double &value, const Entry &entry);
Option &add(Table &table, int &value, const Entry &entry);
Option &add(Table &table, bool &value, const Entry &entry);
Option &add(Table &table, std::string &value, const Entry &entry);
Option &add(Table &table, std::filesystem::path &value, const Entry &entry);
Option &add(Table &table, std::optional<double> &value, const Entry &entry);
Option &add(Table &table, std::optional<int> &value, const Entry &entry);
Option &add(Table &table, std::optional<std::string> &value, const Entry &entry);
Option &add(Table &table, std::vector<double> &value, const Entry &entry);
Option &add(Table &table, std::vector<std::string> &value, const Entry &entry);
Option &add(Table &table, std::vector<std::filesystem::path> &value, const Entry &entry);

/// An option with names: `choices(value)` is the list of them, found by the type's namespace.
template <class E>
requires std::is_enum_v<E> Option &add(Table &table, E &value, const Entry &entry) {
  Option &option = add_option(table, entry, Kind::choice, "NAME");
  const auto list = choices(value);
  for (const auto &choice : list) option.names.emplace_back(choice.name);
  option.range = ": " + names_in(list);
  option.allowed_text = "one of " + names_in(list);
  option.assign = [&value, list](const Given &given) { value = choice_given(given, list); };
  option.toml = [&value, list] { return toml_string(name_in(list, value)); };
  return option;
}

/// The option with this key or alias; null if there is none.
const Option *find(const Table &table, std::string_view key);

/// The keys that files may have.
std::vector<std::string> keys_of(const Table &table);

/// Sets the option that was given and notes its origin. The option must be in the table. Throws SetupError.
void apply(const Table &table, Origins &origins, const Given &given);

/// The entries of TOML text. Throws SetupError if it is damaged or has keys that the table lacks; `file` is its name in
/// errors, `example` a line that would be right.
std::vector<Given> entries_of(const Table &table, std::string_view text, const std::string &file,
                              const std::string &example);

/// The options as TOML, grouped by comments, without those for which `left_out` is true.
std::string to_toml(const Table &table, const std::function<bool(const Option &)> &left_out, bool with_groups = true);

/// The value as a person reads it.
std::string shown(const Option &option);

} // namespace options
