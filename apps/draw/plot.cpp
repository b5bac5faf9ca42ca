// SPDX-License-Identifier: BSD-3-Clause
#include "plot.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace draw {

namespace {

/// Runs gnuplot with `arguments`, silently, and returns its exit status; 127 if it cannot be started.
int run_gnuplot(std::vector<std::string> arguments) {
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

/// Settings that all plots share: white ground, CSV files, quiet axes.
std::string style(bool png, PictureSize size) {
  const std::string pixels = " size " + std::to_string(size.width) + "," + std::to_string(size.height);
  return "set encoding utf8; set terminal " +
         (png ? "pngcairo" + pixels + " noenhanced font 'sans,12' linewidth 1.2"
              : "svg" + pixels + " noenhanced font 'Helvetica,Arial,sans-serif,18' linewidth 1.2") +
         " background 'white'; "
         "set datafile separator ','; set border 3 linecolor '#404040'; set tics nomirror out; "
         "set grid linecolor '#d8d8d8' linewidth 0.7 dashtype 1; ";
}

} // namespace

bool gnuplot_available() { return run_gnuplot({"--version"}) == 0; }

std::string gnuplot_quoted(const std::string &text) {
  ogive::require(text.find_first_of(std::string("\r\n\0", 3)) == std::string::npos, "text for gnuplot", text,
                 "must not hold a line end or a NUL");
  // Everything that could mean something to gnuplot goes in octal: its rules for quotes within quotes have gaps.
  std::string quoted = "\"";
  bool escaped = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    // It takes a digit behind three octal ones for a fourth.
    const bool is_digit = c >= '0' && c <= '9';
    escaped = !(byte >= 0x80 || (is_digit ? !escaped : ogive::is_letter_or_digit(c)) || c == ' ' || c == '/' ||
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

std::string gnuplot_file(const std::filesystem::path &file) {
  return gnuplot_quoted(std::filesystem::absolute(file).string());
}

std::string gnuplot_colour(std::size_t k) {
  constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#404040", "#8c6d00"};
  return std::string("'") + colours[k % colours.size()] + "'";
}

void draw_with_gnuplot(const std::string &commands, const std::filesystem::path &picture, PictureSize size) {
  ogive::require_replaceable(picture);
  const auto temporary = ogive::temporary_name(picture);
  if (!gnuplot_available()) throw ogive::write_error(picture, "gnuplot is not installed or not in PATH");
  const std::string script = style(picture.extension() == ".png", size) + "set output " + gnuplot_file(temporary) +
                             "; " + commands + "; unset output";
  // Settings of the user in ~/.gnuplot or of the machine would change the picture.
  const int status = run_gnuplot({"-d", "-e", script});
  std::error_code error, ignored;
  const bool drawn = status == 0 && std::filesystem::file_size(temporary, error) > 0 && !error;
  if (drawn) std::filesystem::rename(temporary, picture, error);
  if (drawn && !error) return;
  std::filesystem::remove(temporary, ignored);
  throw ogive::write_error(picture,
                           drawn ? error.message() : "gnuplot fails with exit status " + std::to_string(status));
}

int csv_column(const std::filesystem::path &path, const std::string &name) {
  std::ifstream file(path);
  std::string header;
  ogive::require(static_cast<bool>(std::getline(file, header)), "history", path.string(),
                 "must be a CSV file with a header");
  int column = 1;
  for (std::size_t begin = 0; begin <= header.size(); ++column) {
    const auto end = std::min(header.find(',', begin), header.size());
    if (header.compare(begin, end - begin, name) == 0) return column;
    begin = end + 1;
  }
  throw ogive::SetupError(path.string() + " column = " + name + ": must be one of " + header);
}

void write_velocity_plot(const VelocityPlot &plot, const std::filesystem::path &picture) {
  std::string script = "set xlabel 'time / µs'; set ylabel 'projectile velocity / (m/s)'; set key top right; "
                       "set yrange [*<0:*]; set offsets graph 0, 0, graph 0.08, graph 0.02; ";
  if (!plot.title.empty()) script += "set title " + gnuplot_quoted(plot.title) + "; ";
  script += "plot ";
  for (std::size_t k = 0; k < plot.curves.size(); ++k) {
    const auto &[history, name] = plot.curves[k];
    const int time = csv_column(history, "time_us"), velocity = csv_column(history, "velocity_m_per_s");
    script += (k == 0 ? "" : ", ") + gnuplot_file(history) + " every ::1 using " + std::to_string(time) + ":" +
              std::to_string(velocity) + " with lines linewidth 3 linecolor " + gnuplot_colour(k) + " title " +
              gnuplot_quoted(name);
  }
  if (plot.measured_residual_m_per_s) {
    const std::string value = ogive::with_digits(*plot.measured_residual_m_per_s, 10);
    script += ", " + value +
              " with lines linewidth 2 dashtype 2 linecolor '#c0392b' title 'measured residual velocity: " + value +
              " m/s'";
  }
  draw_with_gnuplot(script, picture);
}

} // namespace draw
