// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// Plots drawn by gnuplot, which is called without a shell.

namespace draw {

/// True if gnuplot can be run.
bool gnuplot_available();

/// `text` as a literal string of gnuplot. Throws ogive::SetupError if it holds a line end or a NUL.
std::string gnuplot_quoted(const std::string &text);

/// The name of a file as a string of gnuplot's. Absolute, because gnuplot takes a name that begins with '<' or '|' for
/// a command.
std::string gnuplot_file(const std::filesystem::path &file);

/// A colour of gnuplot's for the curve number `k`: eight that differ for all readers (Okabe & Ito 2008), then again.
std::string gnuplot_colour(std::size_t k);

/// Columns of a CSV file with a header, as a curve's points: "1:2".
std::string gnuplot_columns(const std::filesystem::path &file, const std::string &columns);

/// One curve of a plot, as gnuplot's plot command takes it.
struct Curve {
  std::string points;  ///< columns of a file, or a formula of x
  std::string look;    ///< "lines linewidth 3"
  std::string title{}; ///< in the legend; none if empty
};

/// Curves with axes.
struct Plot {
  std::string title{}; ///< none if empty
  std::string x{}, y{};
  std::string settings{}; ///< commands of gnuplot
  std::vector<Curve> curves{};
};

/// The commands that draw a plot.
std::string commands_of(const Plot &plot);

/// Pixels of a picture.
struct PictureSize {
  int width = 900, height = 600;
};

/// Runs `commands` (one line for gnuplot: settings and a plot) and writes `picture`, in place of an old one: a PNG
/// if its name ends so, else an SVG. Throws ogive::WriteError if gnuplot is missing or fails, or the file cannot be
/// written; the old one stays then.
void draw_with_gnuplot(const std::string &commands, const std::filesystem::path &picture, PictureSize size = {});

/// Number of the column `name`, from 1, in the first line of a CSV file. Throws ogive::SetupError if there is none.
int csv_column(const std::filesystem::path &file, const std::string &name);

/// A history in CSV, with the columns time_us and velocity_m_per_s, and its name in the legend.
struct VelocityCurve {
  std::filesystem::path history;
  std::string name = "computed";
};

/// The projectile's velocity against time, of one or several runs.
struct VelocityPlot {
  std::string title; ///< none if empty
  std::vector<VelocityCurve> curves;
  std::optional<double> measured_residual_m_per_s{}; ///< a horizontal line if given
};

/// Draws the plot as an SVG or PNG. Throws ogive::SetupError if a history cannot be read or lacks a column,
/// ogive::WriteError as draw_with_gnuplot() does.
void write_velocity_plot(const VelocityPlot &plot, const std::filesystem::path &picture);

} // namespace draw
