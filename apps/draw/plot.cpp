// SPDX-License-Identifier: BSD-3-Clause
#include "plot.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"
#include "options/text.hpp"
#include "process.hpp"

#include <algorithm>
#include <fstream>

namespace draw {

namespace {

constexpr double most_seconds = 60; ///< a plot takes well below one
constexpr char package[] = "gnuplot-nox";

/// Settings that all plots share: white ground, CSV files, quiet axes.
std::string style(bool png, PictureSize size) {
  const std::string pixels = options::printed(" size %d,%d", size.width, size.height);
  return "set encoding utf8; set terminal " +
         (png ? "pngcairo" + pixels + " noenhanced font 'sans,12'"
              : "svg" + pixels + " noenhanced font 'Helvetica,Arial,sans-serif,18'") +
         " linewidth 1.2 background 'white'; set datafile separator ','; set border 3 linecolor '#404040'; "
         "set tics nomirror out; set grid linecolor '#d8d8d8' linewidth 0.7 dashtype 1; ";
}

} // namespace

bool gnuplot_available() { return run_program("gnuplot", {"--version"}, most_seconds) == 0; }

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
    quoted += escaped ? options::printed("\\%03o", static_cast<unsigned>(byte)) : std::string(1, c);
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
  const std::string script = style(picture.extension() == ".png", size) + "set output " + gnuplot_file(temporary) +
                             "; " + commands + "; unset output";
  // Settings of the user in ~/.gnuplot or of the machine would change the picture.
  const int status = run_program("gnuplot", {"-d", "-e", script}, most_seconds);
  std::error_code error, ignored;
  const bool drawn = status == 0 && std::filesystem::file_size(temporary, error) > 0 && !error;
  if (drawn) std::filesystem::rename(temporary, picture, error);
  if (drawn && !error) return;
  std::filesystem::remove(temporary, ignored);
  throw ogive::write_error(picture, drawn ? error.message() : failure_of("gnuplot", package, status, most_seconds));
}

std::string gnuplot_columns(const std::filesystem::path &file, const std::string &columns) {
  return gnuplot_file(file) + " every ::1 using " + columns;
}

std::string commands_of(const Plot &plot) {
  std::string commands = "set xlabel " + gnuplot_quoted(plot.x) + "; set ylabel " + gnuplot_quoted(plot.y) + "; " +
                         (plot.title.empty() ? "" : "set title " + gnuplot_quoted(plot.title) + "; ") +
                         (plot.settings.empty() ? "" : plot.settings + "; ") + "plot ";
  for (const Curve &curve : plot.curves)
    commands += (&curve == &plot.curves.front() ? "" : ", ") + curve.points + " with " + curve.look +
                (curve.title.empty() ? " notitle" : " title " + gnuplot_quoted(curve.title));
  return commands;
}

int csv_column(const std::filesystem::path &path, const std::string &name) {
  std::ifstream file(path);
  std::string header;
  ogive::require(static_cast<bool>(std::getline(file, header)), "history", path.string(),
                 "must be a CSV file with a header");
  const auto columns = options::split(header, ',');
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end())
    throw ogive::SetupError(path.string() + " column = " + name + ": must be one of " + header);
  return static_cast<int>(found - columns.begin()) + 1;
}

void write_velocity_plot(const VelocityPlot &plot, const std::filesystem::path &picture) {
  Plot drawn{.title = plot.title,
             .x = "time / µs",
             .y = "projectile velocity / (m/s)",
             .settings = "set key top right; set yrange [*<0:*]; set offsets graph 0, 0, graph 0.08, graph 0.02"};
  for (const auto &[history, name] : plot.curves) {
    const int time = csv_column(history, "time_us"), velocity = csv_column(history, "velocity_m_per_s");
    drawn.curves.push_back({gnuplot_columns(history, options::printed("%d:%d", time, velocity)),
                            "lines linewidth 3 linecolor " + gnuplot_colour(drawn.curves.size()), name});
  }
  if (plot.measured_residual_m_per_s) {
    const std::string value = options::printed("%.10g", *plot.measured_residual_m_per_s);
    drawn.curves.push_back(
        {value, "lines linewidth 2 dashtype 2 linecolor '#c0392b'", "measured residual velocity: " + value + " m/s"});
  }
  draw_with_gnuplot(commands_of(drawn), picture);
}

} // namespace draw
