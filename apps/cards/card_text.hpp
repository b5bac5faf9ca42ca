// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "card.hpp"

/// \file
/// Lines and fields of cards. All functions throw SetupError "FILE:LINE: what is wrong".

namespace cards {

/// A line without comments around it.
struct Line {
  std::string text;
  std::size_t number = 0; ///< from 1
};

/// The lines that are neither empty nor a comment, without what ends a line.
std::vector<Line> lines_of(std::string_view text, std::string_view comment);

/// Throws the error of a line.
[[noreturn]] void refuse_line(const std::string &file, std::size_t line, const std::string &what);

/// A text without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// A text in capitals, without blanks.
std::string squeezed(std::string_view text);

/// A field as a number, in any way that Fortran takes: 1.5d3, 7.85-9. Nothing if it is empty.
std::optional<Number> number_in(std::string_view field, const std::string &name, const std::string &file,
                                std::size_t line);

/// The fields of a line in columns of `widths`, the last of which repeats; what lies beyond 20 fields is left out.
std::vector<std::string> columns_of(const Line &line, const std::vector<std::size_t> &widths, const std::string &file);

/// A title as the name of a metal: one line of ASCII.
std::string title_of(std::string_view text);

/// "PC = -5000 (line 7): cut-off of the pressure"
std::string text_of(const Number &number, const std::string &meaning);

} // namespace cards
