#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <optional>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

/// \file
/// The projectile's velocity against time as an SVG, drawn by gnuplot, which is called without a shell.

namespace ogive {

/// What the plot shows.
struct VelocityPlot {
  std::string title;                                 ///< none if empty
  std::string curve = "computed";                    ///< name of the curve in the legend
  std::string time_column = "time_us";               ///< of the history, us
  std::string velocity_column = "velocity_m_per_s";  ///< of the history, m/s
  std::optional<double> measured_residual_m_per_s{}; ///< a horizontal line if given
};

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
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) || c == ' ' || c == '/' || c == '.' || c == '_' || c == '-')
      quoted += c;
    else {
      std::array<char, 8> octal{};
      std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(byte));
      quoted += octal.data();
    }
  }
  return quoted + "\"";
}

/// Number of the column `name`, from 1, in the first line of a CSV file. Throws SetupError if there is none.
inline int csv_column(const std::filesystem::path &path, const std::string &name) {
  std::ifstream file(path);
  std::string header;
  require(static_cast<bool>(std::getline(file, header)), "history", path.string(), "must be a CSV file with a header");
  int column = 1;
  for (std::size_t begin = 0; begin <= header.size(); ++column) {
    const auto end = std::min(header.find(',', begin), header.size());
    if (header.compare(begin, end - begin, name) == 0) return column;
    begin = end + 1;
  }
  throw SetupError(path.string() + " column = " + name + ": must be one of " + header);
}

/// The plot as one line of commands for gnuplot that write to `output`.
inline std::string velocity_plot_script(const std::filesystem::path &history, const std::filesystem::path &output,
                                        const VelocityPlot &plot) {
  const std::string columns = std::to_string(csv_column(history, plot.time_column)) + ":" +
                              std::to_string(csv_column(history, plot.velocity_column));
  std::string script = "set encoding utf8; "
                       "set terminal svg size 900,600 noenhanced font 'Helvetica,Arial,sans-serif,18' "
                       "background 'white' linewidth 1.2; "
                       "set datafile separator ','; set border 3 linecolor '#404040'; set tics nomirror out; "
                       "set grid linecolor '#d8d8d8' linewidth 0.7 dashtype 1; "
                       "set xlabel 'time / µs'; set ylabel 'projectile velocity / (m/s)'; set key top right; "
                       "set yrange [*<0:*]; set offsets graph 0, 0, graph 0.08, graph 0.02; ";
  if (!plot.title.empty()) script += "set title " + gnuplot_quoted(plot.title) + "; ";
  // Absolute, because gnuplot takes a name that begins with '<' or '|' for a command.
  script += "set output " + gnuplot_quoted(std::filesystem::absolute(output).string()) + "; plot " +
            gnuplot_quoted(std::filesystem::absolute(history).string()) + " using " + columns +
            " every ::1 with lines linewidth 3 linecolor '#1f5fa8' title " + gnuplot_quoted(plot.curve);
  if (plot.measured_residual_m_per_s) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "%.10g", *plot.measured_residual_m_per_s);
    script +=
        std::string(", ") + value.data() +
        " with lines linewidth 2 dashtype 2 linecolor '#c0392b' title 'measured residual velocity: " + value.data() +
        " m/s'";
  }
  return script + "; unset output";
}

/// Draws the velocity (m/s) of a history in CSV against its time (us) as the SVG `picture`. Throws SetupError if the
/// history cannot be read or lacks a column, WriteError if gnuplot is missing or fails, or the file cannot be written.
inline void write_velocity_plot(const std::filesystem::path &history, const std::filesystem::path &picture,
                                const VelocityPlot &plot = {}) {
  require_replaceable(picture);
  const auto temporary = temporary_name(picture);
  const std::string script = velocity_plot_script(history, temporary, plot);
  if (!gnuplot_available()) throw write_error(picture, "gnuplot is not installed or not in PATH");
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
