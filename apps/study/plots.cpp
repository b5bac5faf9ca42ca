// SPDX-License-Identifier: BSD-3-Clause
#include "plots.hpp"

#include "draw/plot.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/write_error.hpp"
#include "shot/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace study {

namespace {

namespace fs = std::filesystem;
using ::draw::gnuplot_file;
using ::draw::gnuplot_quoted;
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

/// How a curve looks.
struct Look {
  std::string title, style, colour{};
};

/// One colour and symbol for each method and law, the same in all figures; the columns of the study's own follow in the
/// title and change the colour.
Look look_of(const Key &key, const std::vector<std::string> &own, std::size_t place) {
  const std::string &method = key.values[method_column], &model = key.values[model_column];
  std::string title = "ogive, " + std::string(model == "mjc" ? "MJC" : "JC") + (method == "sfm" ? "" : ", " + method);
  std::string colour = method == "sfm"        ? (model == "mjc" ? "#c0392b" : "#2471a3")
                       : method == "adaptive" ? "#7d3c98"
                                              : "#1e8449";
  constexpr std::array colours{"#c0392b", "#2471a3", "#1e8449", "#7d3c98", "#b9770e", "#34495e", "#16a085", "#922b21"};
  if (!own.empty()) colour = colours[place % colours.size()];
  for (std::size_t k = 0; k < own.size(); ++k) title += ", " + own[k] + " " + key.values[key_columns().size() + k];
  return {title,
          "with linespoints linecolor rgb '" + colour + "' linewidth 1.5 pointsize 0.9 pointtype " +
              std::to_string(model == "mjc" ? 6 : 8),
          colour};
}

constexpr const char *measured_style = "with points linecolor rgb 'black' pointtype 7 pointsize 0.9";

/// One curve of a panel.
std::string curve(const fs::path &file, const Look &look) {
  return gnuplot_file(file) + " using 1:2 " + look.style + " title " + gnuplot_quoted(look.title);
}

/// Plate and nose of a panel: what its shots share.
struct Plate {
  std::string metal, nose;
  double thickness_mm = 0;
  auto operator<=>(const Plate &) const = default;
};
Plate plate_of(const Key &key) {
  const std::string &material = key.values[material_column];
  return {material.starts_with("weldox")   ? "Weldox 460 E"
          : material.starts_with("aa5083") ? "AA5083-H116"
                                           : material,
          key.values[nose_column], number(key, thickness_column)};
}

/// Measured shots of a plate.
Points measured_shots(const Plate &plate) {
  Points points;
  for (const auto &row : experiment::read_rows(experiment::data_folder() / "experiment_shots.csv")) {
    if (row.size() < 6 || row[1] != plate.metal || row[2] != plate.nose) continue;
    const auto thickness = ogive::number_from(row[3]), v = ogive::number_from(row[4]),
               left = ogive::number_from(row[5]);
    if (thickness && v && left && std::abs(*thickness - plate.thickness_mm) < 0.01) points.emplace_back(*v, *left);
  }
  return points;
}

/// Residual against initial velocity by a curve, up to `fastest` m/s.
Points points_of(const ogive::BallisticCurve<double> &curve, double fastest) {
  Points points;
  // Closely spaced where the curve rises steeply.
  for (double s = 0; s <= 1.0001; s += 0.02) {
    const double v = curve.limit + (fastest - curve.limit) * s * s;
    points.emplace_back(v, residual_velocity(curve, v));
  }
  return points;
}

/// The last of the stopped shots and all that perforated: stopped ones further down are the search's.
Points residuals(const Key &key, const std::vector<Row> &rows) {
  Points points;
  for (const Row &row : rows)
    if (series_key(row.key) == key && !is_undecided(row))
      points.emplace_back(number(row.key, velocity_column), number(row, "residual_velocity_mps"));
  std::sort(points.begin(), points.end());
  while (points.size() > 1 && points[1].second == 0) points.erase(points.begin());
  return points;
}

/// Axes and grid of a panel.
std::string axes(const std::string &x, const std::string &y, const std::string &title) {
  return "set title " + gnuplot_quoted(title) + "; set xlabel " + gnuplot_quoted(x) + "; set ylabel " +
         gnuplot_quoted(y) + "; ";
}

void draw(const std::string &commands, const fs::path &out, const std::string &name, int width, int height) {
  for (const char *kind : {"svg", "png"})
    ::draw::draw_with_gnuplot(commands, out / (name + "." + kind), {width, height});
}

/// The column of the limits' abscissa: the first whose numbers differ, else the thickness.
std::size_t abscissa_of(const std::vector<LimitRow> &limits) {
  const auto varies = [&](std::size_t column) {
    return std::any_of(limits.begin(), limits.end(), [&](const LimitRow &row) {
      return std::isfinite(number(row.key, column)) && row.key.values[column] != limits.front().key.values[column];
    });
  };
  for (std::size_t k = thickness_column; k < limits.front().key.values.size(); ++k)
    if (k != velocity_column && varies(k)) return k;
  return thickness_column;
}

} // namespace

bool draw_residuals(const Plot &plot, const std::vector<Series> &series, const std::vector<Row> &rows,
                    const std::vector<std::string> &own, const fs::path &out, bool with_fit) {
  std::map<Plate, std::vector<const Series *>> panels;
  double slowest = 1e9, fastest = 300;
  for (const Series &one : series)
    if (const auto points = residuals(one.key, rows); !points.empty()) {
      panels[plate_of(one.key)].push_back(&one);
      slowest = std::min(slowest, points.front().first);
      fastest = std::max(fastest, points.back().first);
    }
  if (panels.empty()) return false;
  const int columns = panels.size() > 4 ? 3 : panels.size() > 3 ? 2 : static_cast<int>(panels.size());
  const int lines = (static_cast<int>(panels.size()) + columns - 1) / columns;
  // The axes of the paper, where they hold all points.
  const bool is_usual = slowest >= 100 && fastest <= 420;
  std::string commands =
      "set multiplot layout " + std::to_string(lines) + "," + std::to_string(columns) + " title " +
      gnuplot_quoted(plot.title) + "; set key left top reverse Left samplen 2 font ',12'; set xrange [" +
      std::string(is_usual ? "100:420" : "*:*") + "]; set yrange [0:" + (is_usual ? "400" : "*") + "]; set grid; ";
  int panel = 0;
  for (const auto &[plate, members] : panels) {
    const fs::path base = out / "plot_data" / (plot.name + "_" + std::to_string(++panel));
    std::string title = shortest(plate.thickness_mm) + " mm " + plate.metal + ", " + plate.nose, curves;
    const auto add = [&](const std::string &one) { curves += (curves.empty() ? "plot " : ", ") + one; };
    const auto file = [&](const std::string &what) { return base.string() + "_" + what + ".csv"; };
    const auto tested = std::find_if(members.begin(), members.end(),
                                     [](const Series *one) { return one->published.test_limit_mps.has_value(); });
    if (tested != members.end()) {
      const Published &published = (*tested)->published;
      add(curve(written(points_of({published.a, published.p, *published.test_limit_mps}, std::max(420.0, fastest)),
                        file("test_curve")),
                {"Recht-Ipson, measured limit", "with lines linecolor rgb '#707070' dashtype 2 linewidth 1.5"}));
      if (const auto shots = measured_shots(plate); !shots.empty())
        add(curve(written(shots, file("tests")), {"test", measured_style}));
    }
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Key &key = members[k]->key;
      const std::string what =
          key.values[method_column] + "_" + key.values[model_column] + (own.empty() ? "" : "_" + std::to_string(k + 1));
      const Look look = look_of(key, own, k);
      add(curve(written(residuals(key, rows), file(what)), look));
      if (const auto limits = with_fit ? limits_in({*members[k]}, rows) : std::vector<LimitRow>{};
          !limits.empty() && limits.front().fit)
        add(curve(written(points_of(limits.front().fit->curve, fastest * 1.02), file(what + "_fit")),
                  {"fit", "with lines linecolor rgb '" + look.colour + "' dashtype 3 linewidth 1.5"}));
    }
    commands += axes("initial velocity, m/s", "residual velocity, m/s", title) + curves + "; ";
  }
  draw(commands + "unset multiplot", out, plot.name, 520 * columns, 440 * lines + 40);
  return true;
}

bool draw_limits(const Plot &plot, const std::vector<LimitRow> &limits, const std::vector<std::string> &own,
                 const fs::path &out) {
  if (limits.empty()) return false;
  const std::size_t abscissa = abscissa_of(limits);
  std::map<Key, std::map<double, ogive::LimitEstimate<double>>> computed;
  Points tests, paper;
  double furthest = 0;
  for (const LimitRow &row : limits) {
    const double x = number(row.key, abscissa);
    furthest = std::max(furthest, x);
    if (row.published.test_limit_mps) tests.emplace_back(x, *row.published.test_limit_mps);
    if (row.published.paper_velocity_mps) paper.emplace_back(x, *row.published.paper_velocity_mps);
    Key curve_key = row.key;
    curve_key.values[abscissa].clear();
    // The metal of the weaker plate belongs to the same curve.
    if (abscissa == thickness_column) curve_key.values[material_column] = plate_of(row.key).metal;
    if (const auto estimate = ogive::limit_estimate(row.bracket)) computed[curve_key][x] = *estimate;
  }
  if (computed.empty()) return false;
  const auto once = [](Points &points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  };
  once(tests), once(paper);
  const fs::path base = out / "plot_data" / plot.name;
  std::string curves;
  const auto add = [&](const std::string &one) { curves += (curves.empty() ? "plot " : ", ") + one; };
  if (!tests.empty()) add(curve(written(tests, base.string() + "_tests.csv"), {"test", measured_style}));
  if (!paper.empty())
    add(curve(written(paper, base.string() + "_paper.csv"),
              {"paper, MJC: strike velocity close to its limit (Fig. 10)",
               "with points linecolor rgb '#b9770e' pointtype 4 pointsize 1"}));
  std::size_t place = 0;
  for (const auto &[key, estimates] : computed) {
    std::string csv = "x,y,half_width\n";
    for (const auto &[x, estimate] : estimates)
      csv += shortest(x) + "," + shortest(estimate.limit) + "," + shortest(estimate.half_width) + "\n";
    const Look look = look_of(key, own, place);
    const fs::path file =
        written(csv, base.string() + "_" + key.values[method_column] + "_" + key.values[model_column] +
                         (own.empty() ? "" : "_" + std::to_string(place + 1)) + ".csv");
    ++place;
    add(gnuplot_file(file) + " using 1:2:3 with yerrorbars linecolor rgb '" + look.colour + "' pointtype 0 notitle");
    add(curve(file, look));
  }
  const std::string x_title = abscissa == thickness_column      ? "plate thickness, mm"
                              : abscissa < key_columns().size() ? key_columns()[abscissa]
                                                                : own[abscissa - key_columns().size()];
  const std::string commands = axes(x_title, "ballistic limit, m/s", plot.title) +
                               "set key left top reverse Left; set grid; set yrange [0:*]; set xrange [0:" +
                               shortest(furthest * 1.1 + (abscissa == thickness_column ? 2 : 0)) + "]; " + curves;
  draw(commands, out, plot.name, 900, 600);
  return true;
}

} // namespace study
