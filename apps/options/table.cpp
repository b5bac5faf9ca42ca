// SPDX-License-Identifier: BSD-3-Clause
#include "table.hpp"

namespace options {

namespace {

std::string toml_text(double value) { return shortest(value); }
std::string toml_text(int value) { return std::to_string(value); }
std::string toml_text(bool value) { return value ? "true" : "false"; }
std::string toml_text(const std::string &value) { return toml_string(value); }
std::string toml_text(const std::filesystem::path &value) { return toml_string(value.string()); }
template <class V> std::string toml_text(const std::optional<V> &value) { return value ? toml_text(*value) : ""; }
template <class V> std::string toml_text(const std::vector<V> &values) {
  std::vector<std::string> texts;
  for (const V &value : values) texts.push_back(toml_text(value));
  return texts.empty() ? "" : "[" + joined(texts) + "]";
}

/// An option of this kind; `read` gets the value, what was given, and what is allowed.
template <class V, class Read>
Option &add_bound(Table &table, const Entry &entry, V &value, Kind kind, const char *placeholder,
                  const std::string &allowed, Read &&read) {
  Option &option = add_option(table, entry, kind, placeholder);
  if (option.allowed_text.empty()) option.allowed_text = allowed;
  option.assign = [&value, read, allowed = option.allowed_text](const Given &given) { read(value, given, allowed); };
  option.toml = [&value] { return toml_text(value); };
  return option;
}

template <class V> Option &add_number(Table &table, V &value, const Entry &entry) {
  const auto read = [limits = entry.limits](V &number, const Given &given, const std::string &) {
    number = number_within(given, limits);
  };
  Option &option = add_bound(table, entry, value, Kind::number, "X", "a number between " + text_of(entry.limits), read);
  option.range = "; " + text_of(entry.limits, " to ");
  return option;
}

template <class V> Option &add_whole(Table &table, V &value, const Entry &entry) {
  const auto read = [limits = entry.limits](V &whole, const Given &given, const std::string &allowed) {
    const auto number = number_given(given);
    if (!number || *number != std::floor(*number) || !within(limits, *number)) refuse(given, "must be " + allowed);
    whole = static_cast<int>(*number);
  };
  Option &option =
      add_bound(table, entry, value, Kind::whole, "N", "a whole number between " + text_of(entry.limits), read);
  option.range = "; " + text_of(entry.limits, " to ");
  return option;
}

template <class V>
Option &add_line(Table &table, V &value, const Entry &entry, Kind kind, const char *placeholder, const char *allowed) {
  return add_bound(table, entry, value, kind, placeholder, allowed,
                   [](V &line, const Given &given, const std::string &text) { line = line_given(given, text); });
}

/// Several words of the command line, or an array of a file. Each call adds one.
template <class V>
Option &add_words(Table &table, V &values, const Entry &entry, const char *placeholder, const char *allowed) {
  const auto read = [](V &words, const Given &given, const std::string &text) {
    const bool list = given.kind == Given::list;
    if (list) words.clear();
    for (const Given &one : list ? given.entries : std::vector{given}) words.emplace_back(line_given(one, text));
  };
  Option &option = add_bound(table, entry, values, Kind::texts, placeholder, allowed, read);
  option.values = Values::several;
  return option;
}

} // namespace

std::string flag_of(std::string_view key) {
  std::string flag = "--" + std::string(key);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string no_flag_of(std::string_view key) { return "--no-" + flag_of(key).substr(2); }

std::string origin_of(const Origins &origins, const std::string &key) {
  const auto found = origins.find(key);
  return found == origins.end() ? flag_of(key) : found->second;
}

Option &add_option(Table &table, const Entry &entry, Kind kind, const char *placeholder) {
  Option &option = table.options.emplace_back();
  static_cast<Entry &>(option) = entry;
  option.group = table.group;
  option.kind = kind;
  option.placeholder = placeholder;
  option.allowed_text = entry.allowed;
  return option;
}

Option &add(Table &t, double &value, const Entry &e) { return add_number(t, value, e); }
Option &add(Table &t, std::optional<double> &value, const Entry &e) { return add_number(t, value, e); }
Option &add(Table &t, int &value, const Entry &e) { return add_whole(t, value, e); }
Option &add(Table &t, std::optional<int> &value, const Entry &e) { return add_whole(t, value, e); }
Option &add(Table &t, std::string &value, const Entry &e) {
  return add_line(t, value, e, Kind::text, "TEXT", "a text");
}
Option &add(Table &t, std::optional<std::string> &value, const Entry &e) {
  return add_line(t, value, e, Kind::text, "TEXT", "a text");
}
Option &add(Table &t, std::filesystem::path &value, const Entry &e) {
  return add_line(t, value, e, Kind::file, "FOLDER", "the name of a folder");
}
Option &add(Table &t, std::vector<std::string> &values, const Entry &e) {
  return add_words(t, values, e, "TEXT...", "a text");
}
Option &add(Table &t, std::vector<std::filesystem::path> &values, const Entry &e) {
  return add_words(t, values, e, "FILE...", "the name of a file");
}

Option &add(Table &table, bool &value, const Entry &entry) {
  Option &option = add_bound(table, entry, value, Kind::truth, "", "true or false",
                             [](bool &truth, const Given &given, const std::string &) { truth = truth_given(given); });
  option.values = Values::none;
  option.range = "; " + no_flag_of(entry.key) + " turns it off";
  return option;
}

Option &add(Table &table, std::vector<double> &values, const Entry &entry) {
  const auto read = [limits = entry.limits](std::vector<double> &numbers, const Given &given, const std::string &) {
    numbers.clear();
    for (const Given &one : entries_given(given)) numbers.push_back(number_within(one, limits));
  };
  Option &option = add_bound(table, entry, values, Kind::numbers, "X,X,...", "", read);
  option.range = "; numbers " + text_of(entry.limits, " to ") + ", separated by commas";
  option.allowed_text = "numbers between " + text_of(entry.limits) + " with commas between them";
  return option;
}

const Option *find(const Table &table, std::string_view key) {
  for (const Option &option : table.options)
    if (key == option.key || (*option.alias != 0 && key == option.alias)) return &option;
  return nullptr;
}

std::vector<std::string> keys_of(const Table &table) {
  std::vector<std::string> keys;
  for (const Option &option : table.options)
    if (option.in_file) keys.emplace_back(option.key);
  return keys;
}

void apply(const Table &table, Origins &origins, const Given &given) {
  find(table, given.key)->assign(given);
  origins[given.key] = given.where;
}

std::vector<Given> entries_of(const Table &table, std::string_view text, const std::string &file,
                              const std::string &example) {
  std::vector<Given> entries = toml_entries(text, file, example);
  const std::vector<std::string> known = keys_of(table);
  for (const Given &given : entries)
    if (std::find(known.begin(), known.end(), given.key) == known.end())
      refuse(given.where, given.value,
             "unknown key" + nearest_text(given.key, known) + "; allowed are " + joined(known));
  return entries;
}

std::string to_toml(const Table &table, const std::function<bool(const Option &)> &left_out, bool with_groups) {
  std::string text, group;
  for (const Option &option : table.options) {
    if (!option.in_file) continue;
    if (with_groups && group != option.group) text += "\n# " + option.group + "\n";
    group = option.group;
    const std::string value = option.toml();
    if (!value.empty() && !left_out(option)) text += std::string(option.key) + " = " + value + "\n";
  }
  return text;
}

std::string shown(const Option &option) {
  std::string text = option.toml ? option.toml() : "";
  if (option.kind == Kind::truth) return text == "true" ? "yes" : "no";
  if (text.empty()) return "none";
  if (text.size() > 1 && text.front() == '"') return text.substr(1, text.size() - 2);
  return text;
}

} // namespace options
