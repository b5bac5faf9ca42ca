#include "options.hpp"
#include "options_table.hpp"

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace perforate {

namespace {

/// Larger files are no list of options; a device such as /dev/zero has no end.
constexpr std::size_t largest_file = 1 << 20;

std::string text_of_file(const std::string &name) {
  const std::string allowed = "must be a TOML file that can be read: ";
  const auto refuse_with = [&](int error) {
    refuse("--config", name, allowed + std::generic_category().message(error));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) refuse_with(errno);
  std::string text(largest_file + 1, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  if (std::ferror(file.get())) refuse_with(errno);
  if (text.size() > largest_file) refuse("--config", name, "must be a TOML file of at most 1 MiB");
  return text;
}

std::string place(const std::string &file, const toml::source_region &source) {
  return file + ":" + std::to_string(source.begin.line);
}

Given given_from(const std::string &key, const toml::node &node, const std::string &where) {
  Given given{key, where, "", Given::other};
  if (const auto *text = node.as_string()) {
    given.value = text->get();
    given.kind = Given::text;
  } else if (const auto *number = node.as_floating_point()) {
    given.value = std::isfinite(number->get()) ? shortest(number->get()) : std::to_string(number->get());
    given.kind = Given::number;
  } else if (const auto *integer = node.as_integer()) {
    given.value = std::to_string(integer->get());
    given.kind = Given::integer;
  } else if (const auto *boolean = node.as_boolean()) {
    given.value = boolean->get() ? "true" : "false";
    given.kind = Given::boolean;
  } else {
    given.value = node.is_table() ? "a table" : node.is_array() ? "an array" : "a date or time";
  }
  return given;
}

std::string quoted(const std::string &text) {
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped + '"';
}

std::string toml_value(double value) { return shortest(value); }
std::string toml_value(bool value) { return value ? "true" : "false"; }
std::string toml_value(const std::optional<int> &value) { return std::to_string(*value); }
std::string toml_value(const std::filesystem::path &value) { return quoted(value.string()); }
template <class E> std::string toml_value(E value) { return quoted(choice_name(value)); }

/// Values that a reader of the file should choose anew: a folder named after the case, the threads of this machine.
bool left_to_reader(const Options &options, const std::filesystem::path &out) { return out == default_out(options); }
bool left_to_reader(const Options &, const std::optional<int> &threads) { return !threads; }
template <class V> bool left_to_reader(const Options &, const V &) { return false; }

} // namespace

std::vector<Given> read_toml(const std::string &file) {
  toml::table table;
  try {
    table = toml::parse(text_of_file(file), file);
  } catch (const toml::parse_error &error) {
    throw ogive::SetupError(printable(place(file, error.source())) + ": " + printable(error.description()) +
                            "; a line of TOML reads key = value, for example thickness_mm = 12.0");
  }

  std::string keys;
  Options any;
  for_each_option(any,
                  [&](const Entry &entry, auto &) { keys += (keys.empty() ? "" : ", ") + std::string(entry.key); });

  std::vector<Given> entries;
  for (const auto &[name, node] : table) {
    const std::string key(name.str());
    bool known = false;
    for_each_option(any, [&](const Entry &entry, auto &) { known = known || key == entry.key; });
    const Given given = given_from(key, node, place(file, name.source()) + ": " + key);
    if (!known) refuse(given.where, given.value, "unknown key; allowed are " + keys);
    entries.push_back(given);
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

} // namespace perforate
