// SPDX-License-Identifier: BSD-3-Clause
#include "text.hpp"

#include <algorithm>
#include <clocale>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <locale.h>
#include <numeric>
#include <utility>

namespace options {

namespace {

/// Letters changed, added, dropped or swapped with a neighbour (Damerau 1964, optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(last, row);
  }
  return last.back();
}

} // namespace

std::string printed(const char *format, ...) {
  // Of this thread alone, until the text is made.
  static const locale_t plain = ::newlocale(LC_ALL_MASK, "C", locale_t{});
  const locale_t users = ::uselocale(plain);
  char text[400];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  ::uselocale(users);
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string shortest(double number, int power) {
  if (power == 0 || number == 0 || !std::isfinite(number)) return shortest(number);
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::scientific);
  const std::string_view text(buffer.data(), end.ptr);
  const std::size_t e = text.find('e');
  const std::string sign = text.starts_with('-') ? "-" : "";
  // The point is moved in the text: that is exact, where a multiplication would round.
  const int exponent = std::atoi(std::string(text.substr(e + 1)).c_str()) + power;
  std::string digits(text.substr(sign.size(), e - sign.size()));
  std::erase(digits, '.');
  if (exponent < -5 || exponent >= 15)
    return sign + digits.substr(0, 1) + (digits.size() > 1 ? "." : "") + digits.substr(1) + "e" +
           std::to_string(exponent);
  if (exponent < 0) return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::optional<double> number_from(std::string_view text, int power) {
  const auto number = number_from(text);
  if (!number || power == 0) return number;
  const std::size_t e = text.find_first_of("eE");
  const long exponent = e == std::string_view::npos ? 0 : std::atol(std::string(text.substr(e + 1)).c_str());
  return number_from(std::string(text.substr(0, e)) + "e" +
                     std::to_string(std::clamp(exponent, -100000L, 100000L) + power));
}

std::optional<std::string> text_in(const std::filesystem::path &file) {
  std::error_code error;
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::string text(std::filesystem::file_size(file, error), '\0');
  if (error || !in.read(text.data(), static_cast<std::streamsize>(text.size()))) return std::nullopt;
  return text;
}

std::string nearest(std::string_view name, const std::vector<std::string> &known) {
  constexpr std::size_t longest = 100;
  if (name.size() > longest) return "";
  std::string best;
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string &one : known)
    // A name that only lacks its end, such as a unit, is meant too.
    if (const std::size_t d = name.size() > 3 && one.starts_with(name) ? 1 : distance(name, one); d < fewest) {
      fewest = d;
      best = one;
    }
  return best;
}

std::string nearest_text(std::string_view name, const std::vector<std::string> &known) {
  const std::string found = nearest(name, known);
  return found.empty() ? "" : ", the nearest is " + found;
}

std::string broken(const std::string &start, const std::string &text, std::size_t indent) {
  constexpr std::size_t width = 100;
  std::string lines = start;
  std::size_t column = lines.size() - (lines.rfind('\n') + 1);
  for (const std::string &word : split(text, ' ')) {
    if (column + word.size() > width) {
      lines.back() = '\n';
      lines.append(indent, ' ');
      column = indent;
    }
    lines += word + " ";
    column += word.size() + 1;
  }
  lines.back() = '\n';
  return lines;
}

} // namespace options
