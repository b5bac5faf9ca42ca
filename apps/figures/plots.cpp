// SPDX-License-Identifier: BSD-3-Clause
#include "plots.hpp"

#include "draw/plot.hpp"
#include "ogive/io/atomic_file.hpp"
#include "shared/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace figures {

namespace {

namespace fs = std::filesystem;
using draw::gnuplot_file;
using draw::gnuplot_quoted;
using ogive::shortest;

/// Points to be plotted, x and y.
using Points = std::vector<std::pair<double, double>>;

/// Writes points and returns the file. Throws WriteError.
fs::path written(const std::string &csv, const fs::path &file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw ogive::write_error(file, error.message());
  ogive::write_atomically(file, csv);
  return file;
}

fs::path written(const Points &points, const fs::path &file) {
  std::string csv = "x,y\n";
  for (const auto &[x, y] : points) csv += shortest(x) + "," + shortest(y) + "\n";
  return written(csv, file);
}

/// How a curve looks: one colour and symbol for each method and law, the same in all figures.
struct Look {
  std::string title, style, colour{};
};
Look look_of(const std::string &method, const std::string &model) {
  const std::string law = model == "mjc" ? "MJC" : "JC", way = method == "sfm" ? "" : ", " + method;
  const std::string colour = method == "sfm"        ? (model == "mjc" ? "#c0392b" : "#2471a3")
                             : method == "adaptive" ? "#7d3c98"
                                                    : "#1e8449";
  const int symbol = model == "mjc" ? 6 : 8;
  return {"ogive, " + law + way,
          "with linespoints linecolor rgb '" + colour + "' linewidth 1.5 pointsize 0.9 pointtype " +
              std::to_string(symbol),
          colour};
}

constexpr const char *measured_style = "with points linecolor rgb 'black' pointtype 7 pointsize 0.9";

/// One curve of a panel.
std::string curve(const fs::path &file, const Look &look) {
  return gnuplot_file(file) + " using 1:2 " + look.style + " title " + gnuplot_quoted(look.title);
}

/// Plate of a panel: what its shots share.
struct Plate {
  std::string metal, nose;
  double thickness_mm = 0;
  auto operator<=>(const Plate &) const = default;
};
Plate plate_of(const SeriesKey &k) {
  return {k.material.starts_with("weldox") ? "Weldox 460 E" : "AA5083-H116", k.nose, k.thickness_mm};
}

/// Measured shots of a plate.
Points measured_shots(const Plate &plate, const fs::path &data) {
  Points points;
  for (const auto &row : experiment::read_rows(data / "experiment_shots.csv")) {
    if (row.size() < 6 || row[1] != plate.metal || row[2] != plate.nose) continue;
    const auto thickness = ogive::number_from(row[3]), v = ogive::number_from(row[4]),
               left = ogive::number_from(row[5]);
    if (thickness && v && left && std::abs(*thickness - plate.thickness_mm) < 0.01) points.emplace_back(*v, *left);
  }
  return points;
}

/// The Recht-Ipson curve through a measured limit, up to 420 m/s.
Points test_curve(const Published &published) {
  const ogive::BallisticCurve<double> curve{published.a, published.p, *published.test_limit_mps};
  Points points;
  // Closely spaced where the curve rises steeply.
  for (double s = 0; s <= 1.0001; s += 0.02) {
    const double v = curve.limit + (420 - curve.limit) * s * s;
    points.emplace_back(v, residual_velocity(curve, v));
  }
  return points;
}

/// The last of the stopped shots and all that perforated: stopped ones further down are the search's.
Points residuals(const SeriesKey &key, const std::vector<ShotRow> &rows) {
  Points points;
  for (const ShotRow &row : rows)
    if (series_of(row.key) == key) points.emplace_back(row.key.initial_velocity_mps, row.residual_velocity_mps);
  std::sort(points.begin(), points.end());
  while (points.size() > 1 && points[1].second == 0) points.erase(points.begin());
  return points;
}

/// Axes and grid of a panel.
std::string axes(const std::string &x, const std::string &y, const std::string &title) {
  return "set title " + gnuplot_quoted(title) + "; set xlabel " + gnuplot_quoted(x) + "; set ylabel " +
         gnuplot_quoted(y) + "; ";
}

void draw(const std::string &commands, const fs::path &out, int figure, int width, int height) {
  const std::string name = "figure_" + std::to_string(figure);
  for (const char *kind : {"svg", "png"}) draw::draw_with_gnuplot(commands, out / (name + "." + kind), {width, height});
}

bool draw_residuals(const Plot &plot, const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
                    const fs::path &data, const fs::path &out) {
  std::map<Plate, std::vector<SeriesKey>> panels;
  for (const SeriesKey &key : series)
    if (!residuals(key, rows).empty()) panels[plate_of(key)].push_back(key);
  if (panels.empty()) return false;
  const int columns = panels.size() > 4 ? 3 : panels.size() > 3 ? 2 : static_cast<int>(panels.size());
  const int lines = (static_cast<int>(panels.size()) + columns - 1) / columns;
  std::string commands = "set multiplot layout " + std::to_string(lines) + "," + std::to_string(columns) + " title " +
                         gnuplot_quoted(plot.title) +
                         "; set key left top reverse Left samplen 2 font ',12'; set xrange [100:420]; "
                         "set yrange [0:400]; set grid; set xtics 100; ";
  int panel = 0;
  for (const auto &[plate, keys] : panels) {
    const fs::path base = out / "plot_data" / ("figure_" + std::to_string(plot.figure) + "_" + std::to_string(++panel));
    std::string title = shortest(plate.thickness_mm) + " mm " + plate.metal + ", " + plate.nose, curves;
    const auto add = [&](const std::string &one) { curves += (curves.empty() ? "plot " : ", ") + one; };
    const auto file = [&](const std::string &what) { return base.string() + "_" + what + ".csv"; };
    if (const auto published = find_published(keys.front(), data); published.test_limit_mps)
      add(curve(written(test_curve(published), file("test_curve")),
                {"Recht-Ipson, measured limit", "with lines linecolor rgb '#707070' dashtype 2 linewidth 1.5"}));
    if (const auto shots = measured_shots(plate, data); !shots.empty())
      add(curve(written(shots, file("tests")), {"test", measured_style}));
    for (const SeriesKey &key : keys)
      add(curve(written(residuals(key, rows), file(key.method + "_" + key.model)), look_of(key.method, key.model)));
    commands += axes("initial velocity, m/s", "residual velocity, m/s", title) + curves + "; ";
  }
  draw(commands + "unset multiplot", out, plot.figure, 520 * columns, 440 * lines + 40);
  return true;
}

/// Limits against thickness, each with a bar over what lies between the shots that bracket it.
bool draw_limits(const Plot &plot, const std::vector<LimitRow> &limits, const fs::path &out) {
  std::map<std::pair<std::string, std::string>, std::map<double, ogive::LimitEstimate<double>>> computed;
  std::map<double, double> tests, paper;
  double thickest = 0;
  for (const LimitRow &row : limits) {
    const double t = row.key.thickness_mm;
    thickest = std::max(thickest, t);
    if (row.published.test_limit_mps) tests[t] = *row.published.test_limit_mps;
    if (row.published.paper_velocity_mps) paper[t] = *row.published.paper_velocity_mps;
    if (const auto estimate = ogive::limit_estimate(row.bracket))
      computed[{row.key.method, row.key.model}][t] = *estimate;
  }
  if (computed.empty()) return false;
  const fs::path base = out / "plot_data" / ("figure_" + std::to_string(plot.figure));
  std::string curves = "plot " + curve(written(Points(tests.begin(), tests.end()), base.string() + "_tests.csv"),
                                       {"test", measured_style});
  if (!paper.empty())
    curves += ", " + curve(written(Points(paper.begin(), paper.end()), base.string() + "_paper.csv"),
                           {"paper, MJC: strike velocity close to its limit (Fig. 10)",
                            "with points linecolor rgb '#b9770e' pointtype 4 pointsize 1"});
  for (const auto &[key, estimates] : computed) {
    std::string csv = "x,y,half_width\n";
    for (const auto &[t, estimate] : estimates)
      csv += shortest(t) + "," + shortest(estimate.limit) + "," + shortest(estimate.half_width) + "\n";
    const Look look = look_of(key.first, key.second);
    const fs::path file = written(csv, base.string() + "_" + key.first + "_" + key.second + ".csv");
    curves += ", " + gnuplot_file(file) + " using 1:2:3 with yerrorbars linecolor rgb '" + look.colour +
              "' pointtype 0 notitle, " + curve(file, look);
  }
  const std::string commands =
      axes("plate thickness, mm", "ballistic limit, m/s", plot.title) +
      "set key left top reverse Left; set grid; set yrange [0:400]; set xrange [0:" + shortest(thickest + 4) + "]; " +
      curves;
  draw(commands, out, plot.figure, 900, 600);
  return true;
}

} // namespace

bool draw_plot(const Plot &plot, const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
               const std::vector<LimitRow> &limits, const fs::path &data, const fs::path &out) {
  return plot.kind == Plot::residual_velocity ? draw_residuals(plot, series, rows, data, out)
                                              : draw_limits(plot, limits, out);
}

} // namespace figures
