// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

/// \file
/// The projectile's velocity against time as an SVG, drawn by gnuplot.

namespace ogive {

/// What the plot shows.
struct VelocityPlot {
  std::string title;                                 ///< none if empty
  std::string curve = "computed";                    ///< name of the curve in the legend
  std::string time_column = "time_us";               ///< of the history, us
  std::string velocity_column = "velocity_m_per_s";  ///< of the history, m/s
  std::optional<double> measured_residual_m_per_s{}; ///< a horizontal line if given
};

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

/// The plot as one line of commands for gnuplot.
inline std::string velocity_plot_script(const std::filesystem::path &history, const VelocityPlot &plot) {
  const std::string columns = std::to_string(csv_column(history, plot.time_column)) + ":" +
                              std::to_string(csv_column(history, plot.velocity_column));
  std::string script = "set xlabel 'time / µs'; set ylabel 'projectile velocity / (m/s)'; set key top right; "
                       "set yrange [*<0:*]; set offsets graph 0, 0, graph 0.08, graph 0.02; ";
  if (!plot.title.empty()) script += "set title " + gnuplot_quoted(plot.title) + "; ";
  script += "plot " + gnuplot_file(history) + " using " + columns +
            " every ::1 with lines linewidth 3 linecolor '#1f5fa8' title " + gnuplot_quoted(plot.curve);
  if (plot.measured_residual_m_per_s) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "%.10g", *plot.measured_residual_m_per_s);
    script +=
        std::string(", ") + value.data() +
        " with lines linewidth 2 dashtype 2 linecolor '#c0392b' title 'measured residual velocity: " + value.data() +
        " m/s'";
  }
  return script;
}

/// Draws the velocity (m/s) of a history in CSV against its time (us) as the SVG `picture`. Throws SetupError if the
/// history cannot be read or lacks a column, WriteError if gnuplot is missing or fails, or the file cannot be written.
inline void write_velocity_plot(const std::filesystem::path &history, const std::filesystem::path &picture,
                                const VelocityPlot &plot = {}) {
  draw_with_gnuplot(velocity_plot_script(history, plot), picture);
}

} // namespace ogive
