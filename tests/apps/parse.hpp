// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/commands.hpp"
#include "shot/plates.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// The options of a command line without the program's name; nothing if text was asked for.
inline std::optional<shot::Options> parse(const std::vector<const char *> &arguments, std::ostream &text) {
  const auto command = commands::parse_shoot({arguments.begin(), arguments.end()}, text);
  return command ? std::optional(command->shot) : std::nullopt;
}

inline shot::Options options_of(const std::vector<const char *> &arguments) {
  std::ostringstream text;
  return parse(arguments, text).value();
}

/// The metal of the first plate.
inline materials::AnyMetal plate_of(const shot::Options &options) { return shot::plates_of(options).front(); }

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
