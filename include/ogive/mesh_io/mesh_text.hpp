// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/text.hpp"
#include "ogive/mesh_io/file_mesh.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// Lines and fields of meshes in text.

namespace ogive {

/// A line of a text without what ends it and without blanks at its end.
struct TextLine {
  std::string_view text; ///< its characters
  long number = 0;       ///< from 1
};

/// Calls `f(line)` for each line that is neither empty nor begins with `comment`; a byte order mark is left out. `f`
/// returns false to end.
template <class F> void for_each_line(std::string_view text, std::string_view comment, F &&f) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for (long number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (line.empty() || line.starts_with(comment)) continue;
    if (!f(TextLine{line, number})) return;
  }
}

/// Without blanks at both ends.
inline std::string_view trimmed_text(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string_view::npos ? std::string_view{}
                                         : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// In capitals, without blanks.
inline std::string squeezed_text(std::string_view text) {
  std::string all;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r') all += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return all;
}

/// The fields of a line between commas, without blanks around them.
inline std::vector<std::string_view> comma_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    fields.push_back(trimmed_text(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  fields.push_back(trimmed_text(line));
  return fields;
}

/// A whole number from 1 on. Throws SetupError that names `thing`.
inline std::int64_t number_of_field(const MeshCollector &all, std::string_view field, const char *thing, long line) {
  const auto number = number_from(field);
  constexpr double most = 1e15;
  if (!number || !(*number >= 1 && *number <= most) || *number != std::floor(*number))
    refuse_line(all, line, std::string(thing) + " = " + printable(field) + ": must be a whole number from 1 on");
  return static_cast<std::int64_t>(*number);
}

/// A coordinate in any way that Fortran takes: 1.5d3, 7.85-9. Throws SetupError.
inline double coordinate_of_field(const MeshCollector &all, std::string_view field, const char *thing, long line) {
  if (field.empty()) return 0;
  std::string text;
  for (const char c : field) {
    const bool is_sign = c == '-' || c == '+';
    if (is_sign && !text.empty() && ((text.back() >= '0' && text.back() <= '9') || text.back() == '.')) text += 'e';
    if (c == '+' && !text.empty()) continue; // behind an e
    text += c == 'd' || c == 'D' || c == 'E' ? 'e' : c;
  }
  const auto number = number_from(text);
  if (!number || !std::isfinite(*number))
    refuse_line(all, line, std::string(thing) + " = " + printable(field) + ": must be a number");
  return *number;
}

/// A node from the fields number, x, y, z; what follows is left out. Throws SetupError.
inline void add_node_of_fields(MeshCollector &all, const std::vector<std::string_view> &fields, long line) {
  if (fields.size() < 4)
    refuse_line(all, line, "fields of a node = " + std::to_string(fields.size()) + ": must be 4, number, x, y and z");
  const std::int64_t number = number_of_field(all, fields[0], "node", line);
  add_node(all, number,
           {coordinate_of_field(all, fields[1], "x", line), coordinate_of_field(all, fields[2], "y", line),
            coordinate_of_field(all, fields[3], "z", line)},
           line);
}

} // namespace ogive
