// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text.hpp"

#include "ogive/core/error.hpp"

#include <algorithm>

/// \file
/// Values given on the command line or in a file: conversion to numbers and choices, limits, and one-line errors.

namespace options {

/// Smallest and largest value of a number, in `unit`.
struct Limits {
  double low = 0;
  double high = 0;
  const char *unit = "";
};

/// The value given for one option or key, and its origin.
struct Given {
  enum Kind { untyped, number, integer, boolean, text, list, other };
  std::string key;
  std::string where; ///< the flag, or file, line and key
  std::string value;
  Kind kind = untyped;          ///< the command line has only text, a TOML file has types
  std::vector<Given> entries{}; ///< of a list or a table in a TOML file
};

/// A choice and its name.
template <class E> struct Choice {
  E value{};
  std::string_view name{};
};

/// A list of choices: named<E>({{E::one, "one"}, {E::two, "two"}}).
template <class E, std::size_t count> constexpr auto named(const Choice<E> (&choices)[count]) {
  return std::to_array(choices);
}

/// Name of a choice in a list of all.
template <class List, class E> std::string name_in(const List &list, E value) {
  for (const auto &choice : list)
    if (choice.value == value) return std::string(choice.name);
  return "";
}

/// All names in a list of choices, separated by commas.
template <class List> std::string names_in(const List &list) {
  std::vector<std::string_view> names;
  for (const auto &choice : list) names.push_back(choice.name);
  return joined(names);
}

/// "0.5 and 100 mm", or with another word between.
inline std::string text_of(const Limits &limits, const char *between = " and ") {
  const std::string unit = *limits.unit == 0 ? "" : std::string(" ") + limits.unit;
  return shortest(limits.low) + between + shortest(limits.high) + unit;
}

/// Throws the one-line error "<what> = <value>: <allowed>".
[[noreturn]] inline void refuse(const std::string &what, std::string_view value, const std::string &allowed) {
  throw ogive::SetupError(printable(what) + " = " + printable(value) + ": " + allowed);
}

/// Throws the one-line error for what was given.
[[noreturn]] inline void refuse(const Given &given, const std::string &allowed) {
  const bool quoted = given.kind == Given::text;
  refuse(given.where, quoted ? '"' + given.value + '"' : given.value, allowed);
}

inline bool within(const Limits &limits, double number) { return number >= limits.low && number <= limits.high; }

/// The number that was given, if it is one.
inline std::optional<double> number_given(const Given &given) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::number || given.kind == Given::integer;
  return may_be ? number_from(given.value) : std::nullopt;
}

/// The number that was given; throws SetupError unless it is one within the limits.
inline double number_within(const Given &given, const Limits &limits) {
  const auto number = number_given(given);
  if (!number)
    refuse(given,
           "must be a number between " + text_of(limits) + (*limits.unit == 0 ? "" : ", written without the unit"));
  if (!within(limits, *number)) refuse(given, "must lie between " + text_of(limits));
  return *number;
}

/// Whether true or false was given; throws SetupError for anything else.
inline bool truth_given(const Given &given) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::boolean;
  if (!may_be || (given.value != "true" && given.value != "false")) refuse(given, "must be true or false");
  return given.value == "true";
}

/// The text that was given; throws SetupError unless it is one of at least one character and without line breaks.
inline std::string line_given(const Given &given, const std::string &allowed) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::text;
  const bool one_line =
      std::none_of(given.value.begin(), given.value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (!may_be || given.value.empty() || !one_line) refuse(given, "must be " + allowed + ", on one line");
  return given.value;
}

/// The entries of a list that was given, for the checks of one: an array of a file, or text with commas between them.
inline std::vector<Given> entries_given(const Given &given) {
  if (given.kind == Given::list) return given.entries;
  std::vector<Given> entries;
  if (given.kind != Given::untyped && given.kind != Given::text) return {given};
  for (const std::string &part : split(given.value, ','))
    entries.push_back({given.key, given.where, part, Given::untyped});
  return entries;
}

/// The choice that was given; throws SetupError unless it is in the list.
template <class List> auto choice_given(const Given &given, const List &list) {
  const bool may_be = given.kind == Given::untyped || given.kind == Given::text;
  for (const auto &choice : list)
    if (may_be && given.value == choice.name) return choice.value;
  refuse(given, "must be one of " + names_in(list));
}

} // namespace options
