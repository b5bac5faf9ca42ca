// SPDX-License-Identifier: BSD-3-Clause
#include "card_text.hpp"

#include <cctype>
#include <cmath>

namespace cards {

namespace {

constexpr std::string_view blanks = " \t\r";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// 1.5D3 and 7.85-9 as 1.5e3 and 7.85e-9.
std::string with_exponent(std::string_view field) {
  std::string text;
  for (const char c : field) {
    const bool is_sign = c == '-' || c == '+';
    if (is_sign && !text.empty() && (is_digit(text.back()) || text.back() == '.')) text += 'e';
    if (c == '+' && !text.empty()) continue; // behind an e
    text += c == 'd' || c == 'D' || c == 'E' ? 'e' : c;
  }
  return text;
}

} // namespace

std::vector<Line> lines_of(std::string_view text, std::string_view comment) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  std::vector<Line> lines;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    if (!line.empty() && !line.starts_with(comment)) lines.push_back({std::string(line), number});
  }
  return lines;
}

void refuse_line(const std::string &file, std::size_t line, const std::string &what) {
  throw ogive::SetupError(options::printable(file) + ":" + std::to_string(line) + ": " + what);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string squeezed(std::string_view text) {
  std::string all;
  for (const char c : text)
    if (blanks.find(c) == std::string_view::npos) all += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return all;
}

std::optional<Number> number_in(std::string_view field, const std::string &name, const std::string &file,
                                std::size_t line) {
  field = trimmed(field);
  if (field.empty()) return {};
  const std::string text = with_exponent(field);
  const auto value = options::number_from(text);
  const auto refuse = [&](const char *must) {
    refuse_line(file, line, name + " = " + options::printable(field) + ": " + must);
  };
  if (field.starts_with('&')) refuse("is a parameter; put its number in its place");
  if (field.find_first_of(blanks) != std::string_view::npos) refuse("must be one number: the columns do not fit");
  if (!value || !std::isfinite(*value)) refuse("must be a number");
  return Number{name, text, *value, line};
}

std::vector<std::string> columns_of(const Line &line, const std::vector<std::size_t> &widths, const std::string &file) {
  if (line.text.find('\t') != std::string::npos)
    refuse_line(file, line.number, "has a tab, with which columns cannot be counted; put blanks in its place");
  constexpr std::size_t most = 20;
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin < line.text.size() && fields.size() < most;) {
    const std::size_t width = widths[std::min(fields.size(), widths.size() - 1)];
    fields.push_back(line.text.substr(begin, width));
    begin += width;
  }
  return fields;
}

std::string title_of(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string title(trimmed(text).substr(0, longest));
  for (char &c : title)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  return title;
}

std::string text_of(const Number &number, const std::string &meaning) {
  return number.name + " = " + number.text + " (line " + std::to_string(number.line) + ")" +
         (meaning.empty() ? "" : ": " + meaning);
}

} // namespace cards
