// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

/// \file
/// Text that users type, and numbers in it. The locale of the program has no part in any of it.

namespace ogive {

/// A value as text for messages: on one line and short, whatever the user typed.
inline std::string printable(std::string_view text) {
  constexpr std::size_t longest = 160;
  std::string line(text.substr(0, longest));
  for (char &c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text.size() > longest ? line + "..." : line;
}

/// The shortest text that reads back as the same number.
inline std::string shortest(double number) {
  std::array<char, 32> digits{};
  const double size = std::abs(number);
  const bool plain = size == 0 || (size >= 1e-5 && size < 1e15);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, format).ptr;
  return {digits.data(), end};
}

namespace text_detail {

inline std::string formatted(double number, std::chars_format format, int precision) {
  // The largest double has 309 digits before the point.
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format, precision).ptr;
  return {text.data(), end};
}

} // namespace text_detail

/// A number in at most `digits` significant digits: what printf gives for `%.*g` in the locale "C".
inline std::string with_digits(double number, int digits) {
  return text_detail::formatted(number, std::chars_format::general, digits);
}

/// A number with `decimals` digits behind the point, at most 60: what printf gives for `%.*f` in the locale "C".
inline std::string with_decimals(double number, int decimals) {
  return text_detail::formatted(number, std::chars_format::fixed, decimals);
}

/// Whether `c` is one of A-Z, a-z and 0-9, in every locale.
constexpr bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// A number from all of `text`, nothing if it holds anything else; infinity where it is too large for a double.
inline std::optional<double> number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  if (error != std::errc{}) return std::nullopt;
  return number;
}

} // namespace ogive
