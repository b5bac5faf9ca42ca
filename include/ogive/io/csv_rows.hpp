// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/text.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ogive {

/// One row of a CSV text.
struct CsvRow {
  long line = 0;                   ///< of its first character, from 1
  std::vector<std::string> fields; ///< without quotes and without blanks around them
};

/// "<name>:<line>", the place of an error.
inline std::string place(const std::string &name, long line) { return name + ":" + std::to_string(line); }

namespace csv_detail {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

inline void trim(std::string &field) {
  while (!field.empty() && is_blank(field.back())) field.pop_back();
  field.erase(0, std::min(field.find_first_not_of(" \t"), field.size()));
}

/// End of the line that begins at `from`: its line feed or the end of the text.
inline std::size_t line_end(std::string_view text, std::size_t from) {
  return std::min(text.find('\n', from), text.size());
}

/// True for lines that hold no row: blank ones and those that begin with '#'.
inline bool holds_no_row(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

/// Reads the quoted part of a field. `at` is behind the opening quotation mark, and afterwards behind the closing
/// one. Throws SetupError where there is none.
inline void read_quoted(std::string_view text, const std::string &name, long &line, std::size_t &at,
                        std::string &field) {
  const long opened = line;
  for (; at < text.size(); ++at) {
    if (text[at] == '\n') ++line;
    if (text[at] != '"') {
      field += text[at];
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      field += text[++at];
    } else {
      ++at;
      return;
    }
  }
  throw SetupError(place(name, opened) + ": field = \"" + printable(field) + ": must end with a quotation mark");
}

/// Throws SetupError for a first line whose columns other characters than commas separate.
inline void require_commas(std::string_view header, const std::string &name, long line) {
  if (header.find_first_of(",\"") != std::string_view::npos) return;
  for (const auto &[separator, text] : {std::pair(';', "semicolons"), std::pair('\t', "tabs")})
    if (header.find(separator) != std::string_view::npos)
      throw SetupError(place(name, line) + ": columns are separated by " + text +
                       ": must be separated by commas, with points in decimal numbers");
}

} // namespace csv_detail

/// Calls `f(row)` for each row of `text`, a table separated by commas (RFC 4180): fields may be quoted, lines may end
/// with LF or CRLF, a byte order mark, blank lines and lines that begin with '#' are passed over. Throws SetupError,
/// one line with `name` and the line, for damaged quotes, other separators in the first row and a row with more than
/// `most_fields` fields.
template <class F>
void for_each_csv_row(std::string_view text, const std::string &name, std::size_t most_fields, F &&f) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  CsvRow row;
  long line = 1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = csv_detail::line_end(text, at);
    if (csv_detail::holds_no_row(text.substr(at, end - at))) {
      at = end + 1;
      continue;
    }
    if (row.line == 0) csv_detail::require_commas(text.substr(at, end - at), name, line);
    row.line = line;
    row.fields.clear();
    for (bool more = true; more;) {
      if (row.fields.size() == most_fields)
        throw SetupError(place(name, line) + ": fields in the row: must be at most " + std::to_string(most_fields));
      std::string &field = row.fields.emplace_back();
      while (at < text.size() && csv_detail::is_blank(text[at])) ++at;
      const bool quoted = at < text.size() && text[at] == '"';
      if (quoted) csv_detail::read_quoted(text, name, line, ++at, field);
      std::string bare;
      while (at < text.size() && text[at] != ',' && text[at] != '\n') bare += text[at++];
      more = at < text.size() && text[at] == ',';
      if (!more && bare.ends_with('\r')) bare.pop_back();
      csv_detail::trim(bare);
      if (quoted && !bare.empty())
        throw SetupError(place(name, line) + ": field = \"" + printable(field) + "\"" + printable(bare) +
                         ": nothing may follow the closing quotation mark");
      if (!quoted) field = std::move(bare);
      ++at;
    }
    f(static_cast<const CsvRow &>(row));
  }
}

} // namespace ogive
