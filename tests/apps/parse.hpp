// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perforate/options.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// The options of a command line without the program's name; nothing if text was asked for.
inline std::optional<perforate::Options> parse(std::vector<const char *> arguments, std::ostream &text) {
  arguments.insert(arguments.begin(), "perforate");
  return perforate::parse(static_cast<int>(arguments.size()), arguments.data(), text);
}

inline perforate::Options options_of(const std::vector<const char *> &arguments) {
  std::ostringstream text;
  return parse(arguments, text).value();
}

/// The message of the SetupError that `f()` throws; empty if it throws none.
template <class F> std::string message_of(F &&f) {
  try {
    f();
  } catch (const ogive::SetupError &error) {
    return error.what();
  }
  return "";
}

/// The message that these arguments are refused with; empty if they are not.
inline std::string refusal(const std::vector<const char *> &arguments) {
  return message_of([&] { options_of(arguments); });
}

inline void write(const std::filesystem::path &file, const std::string &text) { std::ofstream(file) << text; }
