// SPDX-License-Identifier: BSD-3-Clause
#include "table.hpp"

#include "nearest.hpp"

#include <algorithm>
#include <cmath>

namespace options {

namespace {

std::string number_text(const Limits &limits) { return "a number between " + text_of(limits); }

int whole_given(const Option &option, const Given &given) {
  const auto number = number_given(given);
  if (!number || *number != std::floor(*number) || !within(option.limits, *number))
    refuse(given, "must be " + option.allowed_text);
  return static_cast<int>(*number);
}

std::string toml_text(double value) { return shortest(value); }
std::string toml_text(int value) { return std::to_string(value); }
std::string toml_text(const std::string &value) { return toml_string(value); }
std::string toml_text(const std::filesystem::path &value) { return toml_string(value.string()); }
template <class V> std::string toml_text(const std::optional<V> &value) { return value ? toml_text(*value) : ""; }
template <class V> std::string toml_text(const std::vector<V> &values) {
  std::string text;
  for (const V &value : values) text += (text.empty() ? "" : ", ") + toml_text(value);
  return text.empty() ? "" : "[" + text + "]";
}

/// An option whose value one piece of text gives.
template <class V, class Read> Option &add_one(Option &option, V &value, Read &&read) {
  option.assign = [&value, option_copy = option, read](const Given &given) { value = read(option_copy, given); };
  option.toml = [&value] { return toml_text(value); };
  return option;
}

Option &number_option(Table &table, const Entry &entry) {
  Option &option = add_option(table, entry, Kind::number, "X");
  option.range = "; " + text_of(entry.limits, " to ");
  option.allowed_text = number_text(entry.limits);
  return option;
}

Option &whole_option(Table &table, const Entry &entry) {
  Option &option = add_option(table, entry, Kind::whole, "N");
  option.range = "; " + text_of(entry.limits, " to ");
  option.allowed_text = "a whole number between " + text_of(entry.limits);
  return option;
}

Option &text_option(Table &table, const Entry &entry, Kind kind, const char *placeholder, const char *allowed) {
  Option &option = add_option(table, entry, kind, placeholder);
  if (option.allowed_text.empty()) option.allowed_text = allowed;
  return option;
}

const auto read_number = [](const Option &option, const Given &given) { return number_within(given, option.limits); };
const auto read_line = [](const Option &option, const Given &given) { return line_given(given, option.allowed_text); };

/// Several words of the command line, or an array of a file. Each call adds one.
template <class V> Option &add_words(Option &option, std::vector<V> &values) {
  option.values = Values::several;
  option.assign = [&values, allowed = option.allowed_text](const Given &given) {
    if (given.kind == Given::list) {
      values.clear();
      for (const Given &one : given.entries) values.emplace_back(line_given(one, allowed));
    } else
      values.emplace_back(line_given(given, allowed));
  };
  option.toml = [&values] { return toml_text(values); };
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

Option &add(Table &table, double &value, const Entry &entry) {
  return add_one(number_option(table, entry), value, read_number);
}

Option &add(Table &table, std::optional<double> &value, const Entry &entry) {
  return add_one(number_option(table, entry), value, read_number);
}

Option &add(Table &table, int &value, const Entry &entry) {
  return add_one(whole_option(table, entry), value, whole_given);
}

Option &add(Table &table, std::optional<int> &value, const Entry &entry) {
  return add_one(whole_option(table, entry), value, whole_given);
}

Option &add(Table &table, bool &value, const Entry &entry) {
  Option &option = add_option(table, entry, Kind::truth, "");
  option.values = Values::none;
  option.range = "; " + no_flag_of(entry.key) + " for not";
  option.allowed_text = "true or false";
  option.assign = [&value](const Given &given) { value = truth_given(given); };
  option.toml = [&value] { return std::string(value ? "true" : "false"); };
  return option;
}

Option &add(Table &table, std::string &value, const Entry &entry) {
  return add_one(text_option(table, entry, Kind::text, "TEXT", "a text"), value, read_line);
}

Option &add(Table &table, std::optional<std::string> &value, const Entry &entry) {
  return add_one(text_option(table, entry, Kind::text, "TEXT", "a text"), value, read_line);
}

Option &add(Table &table, std::filesystem::path &value, const Entry &entry) {
  return add_one(text_option(table, entry, Kind::file, "FOLDER", "the name of a folder"), value, read_line);
}

Option &add(Table &table, std::vector<double> &values, const Entry &entry) {
  Option &option = add_option(table, entry, Kind::numbers, "X,X,...");
  option.range = "; numbers " + text_of(entry.limits, " to ") + " with commas between them";
  option.allowed_text = "numbers between " + text_of(entry.limits) + " with commas between them";
  option.assign = [&values, limits = entry.limits](const Given &given) {
    values.clear();
    for (const Given &one : entries_given(given)) values.push_back(number_within(one, limits));
  };
  option.toml = [&values] { return toml_text(values); };
  return option;
}

Option &add(Table &table, std::vector<std::string> &values, const Entry &entry) {
  return add_words(text_option(table, entry, Kind::texts, "TEXT...", "a text"), values);
}

Option &add(Table &table, std::vector<std::filesystem::path> &values, const Entry &entry) {
  return add_words(text_option(table, entry, Kind::texts, "FILE...", "the name of a file"), values);
}

const Option *find(const Table &table, std::string_view key) {
  for (const Option &option : table.options)
    if (key == option.key || (*option.alias != 0 && key == option.alias)) return &option;
  return nullptr;
}

std::string keys_of(const Table &table) {
  std::string keys;
  for (const Option &option : table.options)
    if (option.in_file) keys += (keys.empty() ? "" : ", ") + std::string(option.key);
  return keys;
}

void apply(const Table &table, Origins &origins, const Given &given) {
  find(table, given.key)->assign(given);
  origins[given.key] = given.where;
}

std::vector<Given> entries_of(const Table &table, std::string_view text, const std::string &file,
                              const std::string &example) {
  std::vector<Given> entries = toml_entries(text, file, example);
  std::vector<std::string> known;
  for (const Option &option : table.options)
    if (option.in_file) known.emplace_back(option.key);
  for (const Given &given : entries)
    if (std::find(known.begin(), known.end(), given.key) == known.end())
      refuse(given.where, given.value,
             "unknown key" + nearest_text(given.key, known) + "; allowed are " + keys_of(table));
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
