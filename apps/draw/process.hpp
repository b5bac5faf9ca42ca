// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// \file
/// Other processes that draw.

namespace draw {

/// The status of a program that could not be started.
inline constexpr int not_started = 127;

/// The status of a program that was ended because its time was over.
inline constexpr int out_of_time = 124;

/// Runs a program that is found in PATH, without a shell and silently, for at most `seconds`. Returns its exit status.
int run_program(std::string program, std::vector<std::string> arguments, double seconds);

/// Description of a failure, by the status of run_program(): "NAME is not installed or not in PATH (Debian: PACKAGE)",
/// "NAME takes more than ... s", or its exit status.
std::string failure_of(const std::string &program, const std::string &package, int status, double seconds);

/// Draws in a process of its own, a copy of this one, for at most `seconds`: a driver of OpenGL that hangs or crashes
/// costs the picture alone. Throws ogive::WriteError, with what the drawing throws or with how it ended.
void draw_apart(const std::filesystem::path &picture, double seconds, const std::function<void()> &draw);

} // namespace draw
