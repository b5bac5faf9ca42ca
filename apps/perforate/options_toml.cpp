// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"
#include "options_table.hpp"

#include "options_material.hpp"
#include "options_projectile.hpp"
#include "shared/toml_file.hpp"

namespace perforate {

namespace {

using input::toml_string;

std::string toml_value(double value) { return shortest(value); }
std::string toml_value(int value) { return std::to_string(value); }
std::string toml_value(bool value) { return value ? "true" : "false"; }
template <class V> std::string toml_value(const std::optional<V> &value) { return toml_value(*value); }
std::string toml_value(const std::filesystem::path &value) { return toml_string(value.string()); }
std::string toml_value(const std::string &value) { return toml_string(value); }
std::string toml_value(const std::vector<double> &values) { return "[" + joined(values, ", ") + "]"; }
std::string toml_value(const std::vector<std::string> &values) {
  std::vector<std::string> quoted;
  for (const std::string &value : values) quoted.push_back(toml_string(value));
  return "[" + joined(quoted, ", ") + "]";
}
template <class E> std::string toml_value(E value) { return toml_string(choice_name(value)); }

/// Values that a reader of the file should choose anew: a folder named after the case, the threads of this machine; and
/// those that follow from others. The copy of a material file has another name, from which no folder can follow.
bool left_to_reader(const Options &options, const std::filesystem::path &out) {
  return !is_material_file(options.material) && out == default_out(options);
}
bool left_to_reader(const Options &options, const FlowModel &) { return is_material_file(options.material); }
bool left_to_reader(const Options &options, const FailureEffect &failure) {
  return failure == default_failure(options.damage);
}
bool left_to_reader(const Options &options, const double &value) {
  return (&value == &options.thickness_mm && !options.layers_mm.empty()) ||
         (&value == &options.nose_length_mm && value == default_nose_length_mm(options)) ||
         (&value == &options.length_mm && value == default_length_mm(options)) ||
         &value == &options.calibre_radius_head;
}
template <class V> bool left_to_reader(const Options &, const std::optional<V> &value) { return !value; }
/// The material follows from those of the plates.
bool left_to_reader(const Options &options, const std::string &) { return !options.layer_materials.empty(); }
template <class V> bool left_to_reader(const Options &, const std::vector<V> &list) { return list.empty(); }
template <class V> bool left_to_reader(const Options &, const V &) { return false; }

} // namespace

std::vector<Given> read_toml(const std::string &file) {
  return entries_of(input::text_of_file(file, "--config"), file);
}

std::vector<Given> entries_of(std::string_view text, const std::string &file) {
  std::vector<Given> entries = input::toml_entries(text, file, "thickness_mm = 12.0");
  std::string keys;
  Options any;
  for_each_option(any,
                  [&](const Entry &entry, auto &) { keys += (keys.empty() ? "" : ", ") + std::string(entry.key); });

  for (const Given &given : entries) {
    bool known = false;
    for_each_option(any, [&](const Entry &entry, auto &) { known = known || given.key == entry.key; });
    if (!known) refuse(given.where, given.value, "unknown key; allowed are " + keys);
  }
  return entries;
}

std::string to_toml(const Options &options) {
  std::string text =
      "# Runs the same case again: perforate --config <this file>\n"
      "# The command line overrides what stands here. Values of friction and end_us stand here as they were\n"
      "# used: with another nose or material give them anew, or delete them to have the defaults.\n";
  const char *group = "";
  for_each_option(options, [&](const Entry &entry, const auto &value) {
    if (group != entry.group) text += std::string("\n# ") + entry.group + "\n";
    group = entry.group;
    if (!left_to_reader(options, value)) text += std::string(entry.key) + " = " + toml_value(value) + "\n";
  });
  return text;
}

std::string to_complete_toml(const Options &options) {
  std::string text;
  for_each_option(options, [&]<class V>(const Entry &entry, const V &value) {
    if constexpr (is_optional<V>)
      if (!value) return;
    if constexpr (is_list<V>)
      if (value.empty()) return;
    // Beyond the limits of one plate, and known from its parts.
    if ((const void *)&value == (const void *)&options.thickness_mm && !options.layers_mm.empty()) return;
    text += std::string(entry.key) + " = " + toml_value(value) + "\n";
  });
  return text;
}

} // namespace perforate
