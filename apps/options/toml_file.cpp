// SPDX-License-Identifier: BSD-3-Clause
#include "toml_file.hpp"

// Errors are caught here, whatever the flags of a project say.
#undef TOML_EXCEPTIONS
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace options {

namespace {

std::string place(const std::string &file, const toml::source_region &source) {
  return file + ":" + std::to_string(source.begin.line);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// The text of a number as it stands in the file: a double of it is rounded before its unit is converted. `parsed`
/// instead where that cannot be found or is not plain decimal.
std::string written(const std::vector<std::string_view> &lines, const toml::source_region &source, double number,
                    const std::string &parsed) {
  const auto &[begin, end, file] = source;
  if (begin.line == 0 || begin.line > lines.size() || begin.line != end.line || begin.column == 0 ||
      end.column < begin.column || begin.column > lines[begin.line - 1].size())
    return parsed;
  std::string found(lines[begin.line - 1].substr(begin.column - 1, end.column - begin.column));
  std::erase_if(found, [](char c) { return c == '_' || c == ' ' || c == '\t' || c == '\r'; });
  return number_from(found) == number ? found : parsed;
}

Given given_from(const std::vector<std::string_view> &lines, const std::string &key, const toml::node &node,
                 const std::string &where) {
  Given given{key, where, "", Given::other};
  if (const auto *text = node.as_string()) {
    given.value = text->get();
    given.kind = Given::text;
  } else if (const auto *number = node.as_floating_point()) {
    given.value = written(lines, node.source(), number->get(), shortest(number->get()));
    given.kind = Given::number;
  } else if (const auto *integer = node.as_integer()) {
    given.value = std::to_string(integer->get());
    given.kind = Given::integer;
  } else if (const auto *boolean = node.as_boolean()) {
    given.value = boolean->get() ? "true" : "false";
    given.kind = Given::boolean;
  } else if (const auto *array = node.as_array()) {
    given.value = "an array";
    given.kind = Given::list;
    for (const auto &entry : *array) given.entries.push_back(given_from(lines, key, entry, where));
  } else {
    given.value = node.is_table() ? "a table" : "a date or time";
  }
  return given;
}

} // namespace

std::string text_of_file(const std::filesystem::path &name, const std::string &what, const std::string &kind,
                         std::size_t most_mebibytes) {
  const std::string allowed = "must be a " + kind + " file ";
  const auto refuse_with = [&](int error) {
    refuse(what, name.string(), allowed + "that can be read: " + std::generic_category().message(error));
  };
  const std::size_t largest_file = most_mebibytes << 20;
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) refuse_with(errno);
  std::string text;
  std::array<char, 1 << 14> block;
  for (std::size_t got = block.size(); got == block.size() && text.size() <= largest_file;) {
    got = std::fread(block.data(), 1, block.size(), file.get());
    text.append(block.data(), got);
  }
  if (std::ferror(file.get())) refuse_with(errno);
  if (text.size() > largest_file)
    refuse(what, name.string(), allowed + "of at most " + std::to_string(most_mebibytes) + " MiB");
  return text;
}

std::vector<Given> toml_entries(std::string_view text, const std::string &file, const std::string &example) {
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error &error) {
    throw ogive::SetupError(printable(place(file, error.source())) + ": " + printable(error.description()) +
                            "; a line of TOML reads key = value, for example " + example);
  }
  const auto lines = lines_of(text);
  std::vector<Given> entries;
  for (const auto &[name, node] : table) {
    const std::string key(name.str());
    entries.push_back(given_from(lines, key, node, place(file, name.source()) + ": " + key));
  }
  return entries;
}

std::string toml_string(std::string_view text) {
  std::string escaped = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(c));
    if (c == '"' || c == '\\')
      (escaped += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      escaped += code;
    else
      escaped += c;
  }
  return escaped + '"';
}

} // namespace options
