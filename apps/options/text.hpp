// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/text.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// Text for users: lists, formatted numbers, mistyped names, lines that fit a terminal.

namespace options {

using ogive::number_from;
using ogive::printable;
using ogive::shortest;

/// The text that std::printf would print in the locale "C", cut after 400 characters.
[[gnu::format(printf, 1, 2)]] std::string printed(const char *format, ...);

/// Texts or numbers with `separator` between them.
template <class List> std::string joined(const List &items, const std::string &separator = ", ") {
  std::string all;
  for (const auto &item : items) {
    if (&item != &*std::begin(items)) all += separator;
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(item)>>)
      all += shortest(static_cast<double>(item));
    else
      all += item;
  }
  return all;
}

/// The parts of a text between separators.
std::vector<std::string> split(std::string_view text, char separator);

/// The shortest text that reads back as the same number times 10^power, exactly.
std::string shortest(double number, int power);

/// A number from all of `text`, times 10^power, without rounding in between.
std::optional<double> number_from(std::string_view text, int power);

/// Contents of a regular file; nothing if it cannot be read.
std::optional<std::string> text_in(const std::filesystem::path &file);

/// The known name that a mistyped one is nearest to: fewest letters changed, added, dropped or swapped with a
/// neighbour. Empty if more than a third of the letters differ.
std::string nearest(std::string_view name, const std::vector<std::string> &known);

/// ", the nearest is <name>", or empty.
std::string nearest_text(std::string_view name, const std::vector<std::string> &known);

/// `start` and then `text`, broken at blanks to fit a terminal of 100 columns; further lines are indented.
std::string broken(const std::string &start, const std::string &text, std::size_t indent);

} // namespace options
