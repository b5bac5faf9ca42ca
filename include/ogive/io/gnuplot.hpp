// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

/// \file
/// Pictures drawn by gnuplot, which is called without a shell.

namespace ogive {

/// Runs gnuplot with `arguments`, silently, and returns its exit status; 127 if it cannot be started.
inline int run_gnuplot(std::vector<std::string> arguments) {
  std::string program = "gnuplot";
  std::vector<char *> argv{program.data()};
  for (auto &argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return 127;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 127;
}

/// Whether gnuplot can be run.
inline bool gnuplot_available() { return run_gnuplot({"--version"}) == 0; }

/// `text` as a string of gnuplot's that stands for itself. Throws SetupError if it holds a line end or a NUL.
inline std::string gnuplot_quoted(const std::string &text) {
  require(text.find_first_of(std::string("\r\n\0", 3)) == std::string::npos, "text for gnuplot", text,
          "must not hold a line end or a NUL");
  // Everything that could mean something to gnuplot goes in octal: its rules for quotes within quotes have gaps.
  std::string quoted = "\"";
  bool escaped = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    // It takes a digit behind three octal ones for a fourth.
    escaped = !(byte >= 0x80 || (std::isdigit(byte) && !escaped) || std::isalpha(byte) || c == ' ' || c == '/' ||
                c == '.' || c == '_' || c == '-');
    if (!escaped)
      quoted += c;
    else {
      std::array<char, 8> octal{};
      std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(byte));
      quoted += octal.data();
    }
  }
  return quoted + "\"";
}

/// The name of a file as a string of gnuplot's. Absolute, because gnuplot takes a name that begins with '<' or '|' for
/// a command.
inline std::string gnuplot_file(const std::filesystem::path &file) {
  return gnuplot_quoted(std::filesystem::absolute(file).string());
}

/// Width and height of a picture in pixels.
struct PictureSize {
  int width = 900;  ///< pixels
  int height = 600; ///< pixels
};

/// Settings that all pictures share: white ground, CSV files, quiet axes.
inline std::string gnuplot_style(bool png, PictureSize size) {
  const std::string pixels = " size " + std::to_string(size.width) + "," + std::to_string(size.height);
  return "set encoding utf8; set terminal " +
         (png ? "pngcairo" + pixels + " noenhanced font 'sans,12' linewidth 1.2"
              : "svg" + pixels + " noenhanced font 'Helvetica,Arial,sans-serif,18' linewidth 1.2") +
         " background 'white'; "
         "set datafile separator ','; set border 3 linecolor '#404040'; set tics nomirror out; "
         "set grid linecolor '#d8d8d8' linewidth 0.7 dashtype 1; ";
}

/// Draws what `commands` (one line of gnuplot's: settings and a plot) say as `picture`, in place of an old one: a PNG
/// if its name ends so, else an SVG. Throws WriteError if gnuplot is missing or fails, or the file cannot be written;
/// the old one stays then.
inline void draw_with_gnuplot(const std::string &commands, const std::filesystem::path &picture,
                              PictureSize size = {}) {
  require_replaceable(picture);
  const auto temporary = temporary_name(picture);
  if (!gnuplot_available()) throw write_error(picture, "gnuplot is not installed or not in PATH");
  const std::string script = gnuplot_style(picture.extension() == ".png", size) +
                             ("set output " + gnuplot_file(temporary)) + "; " + commands + "; unset output";
  const int status = run_gnuplot({"-e", script});
  std::error_code error;
  const bool drawn = status == 0 && std::filesystem::file_size(temporary, error) > 0 && !error;
  if (drawn) std::filesystem::rename(temporary, picture, error);
  if (drawn && !error) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw write_error(picture, drawn ? error.message() : "gnuplot fails with exit status " + std::to_string(status));
}

} // namespace ogive
