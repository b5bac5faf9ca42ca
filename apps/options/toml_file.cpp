// SPDX-License-Identifier: BSD-3-Clause
#include "toml_file.hpp"

// Errors are caught here, whatever the flags of a project.
#undef TOML_EXCEPTIONS
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>

namespace options {

namespace {

std::string place(const std::string &file, const toml::source_region &source) {
  return file + ":" + std::to_string(source.begin.line);
}

/// The text of a number as written in the file: a double of it is rounded before its unit is converted. `parsed`
/// instead where that cannot be found or is not plain decimal.
std::string written(const std::vector<std::string> &lines, const toml::source_region &source, double number,
                    const std::string &parsed) {
  const auto &[begin, end, file] = source;
  if (begin.line == 0 || begin.line > lines.size() || begin.line != end.line || begin.column == 0 ||
      end.column < begin.column || begin.column > lines[begin.line - 1].size())
    return parsed;
  std::string found = lines[begin.line - 1].substr(begin.column - 1, end.column - begin.column);
  std::erase_if(found, [](char c) { return c == '_' || c == ' ' || c == '\t' || c == '\r'; });
  return number_from(found) == number ? found : parsed;
}

Given given_from(const std::vector<std::string> &lines, const std::string &key, const toml::node &node,
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
    if (const auto *inner = node.as_table())
      for (const auto &[name, entry] : *inner) {
        const std::string own(name.str());
        given.entries.push_back(given_from(lines, own, entry, where + "." + own));
      }
  }
  return given;
}

/// Most parts of a key and most brackets around a value: the parser goes deeper by a call for each, until its stack
/// overflows. Files of ogive have keys of one part, and lists.
constexpr int most_parts = 16, most_brackets = 16;

/// Place behind the quoted text that begins at `at`; without an end on its line, or at all, the parser refuses it.
std::size_t behind_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool long_text = text.substr(at, 3) == three;
  for (std::size_t k = at + (long_text ? 3 : 1); k < text.size(); ++k) {
    if (text[k] == '\\' && quote == '"') {
      ++k;
    } else if (long_text && text.substr(k, 3) == three) {
      // Two more may belong to the text.
      for (at = k + 3; at < std::min(k + 5, text.size()) && text[at] == quote;) ++at;
      return at;
    } else if (!long_text && text[k] == quote) {
      return k + 1;
    } else if (!long_text && text[k] == '\n') {
      return k;
    }
  }
  return text.size();
}

/// Throws SetupError for keys of too many parts and values in too many brackets.
void require_shallow(std::string_view text, const std::string &file) {
  int parts = 1, brackets = 0;
  std::size_t line = 1, counted = 0;
  const auto refuse_line = [&](const std::string &allowed) {
    throw ogive::SetupError(printable(file + ":" + std::to_string(line)) + ": " + allowed);
  };
  for (std::size_t at = 0; at < text.size();) {
    line += static_cast<std::size_t>(std::count(text.begin() + counted, text.begin() + at, '\n'));
    counted = at;
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_quoted(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.')
      ++parts;
    else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}')
      parts = 1;
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (parts > most_parts) refuse_line("a key must have at most " + std::to_string(most_parts) + " parts");
    if (brackets > most_brackets) refuse_line("brackets must lie at most " + std::to_string(most_brackets) + " deep");
    ++at;
  }
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
  require_shallow(text, file);
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error &error) {
    throw ogive::SetupError(printable(place(file, error.source())) + ": " + printable(error.description()) +
                            "; a line of TOML reads key = value, for example " + example);
  }
  const auto lines = split(text, '\n');
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
    if (c == '"' || c == '\\') escaped += '\\';
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    escaped += is_control ? printed("\\u%04x", static_cast<unsigned>(c)) : std::string(1, c);
  }
  return escaped + '"';
}

} // namespace options
