// SPDX-License-Identifier: BSD-3-Clause
#include "plots.hpp"

#include "draw/plot.hpp"

#include "ogive/io/atomic_file.hpp"
#include "shot/experiment.hpp"

#include <set>

namespace study {

namespace {

namespace fs = std::filesystem;
using experiment::Specimen;
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

/// The style and the title of a curve.
struct Look {
  std::string title, style, colour{};
};

/// One colour and symbol for each method and law, the same in all figures; the columns of the study's own follow in the
/// title and change the colour.
Look look_of(const Key &key, const Texts &own, std::size_t place) {
  const std::string &method = key.values[method_column], &model = key.values[model_column];
  std::string title = "ogive, " + std::string(model == "mjc" ? "MJC" : "JC") + ", " + method;
  std::string colour = method != "paper" ? "#1e8449" : model == "mjc" ? "#c0392b" : "#2471a3";
  constexpr std::array colours{"#c0392b", "#2471a3", "#1e8449", "#7d3c98", "#b9770e", "#34495e", "#16a085", "#922b21"};
  if (!own.empty()) colour = colours[place % colours.size()];
  for (std::size_t k = key_columns().size(); k < key.values.size(); ++k)
    title += ", " + column_name(k, own) + " " + key.values[k];
  return {title,
          "linespoints linecolor rgb '" + colour + "' linewidth 1.5 pointsize 0.9 pointtype " +
              (model == "mjc" ? "6" : "8"),
          colour};
}

const Look measured{"test", "points linecolor rgb 'black' pointtype 7 pointsize 0.9", "black"};
const Look of_paper{"paper, MJC: strike velocity close to its limit (Fig. 10)",
                    "points linecolor rgb '#b9770e' pointtype 4 pointsize 1"};

/// The name of a series' files: "paper_mjc", with a number where the study has columns of its own.
std::string file_part(const Key &key, const Texts &own, std::size_t place) {
  return key.values[method_column] + "_" + key.values[model_column] +
         (own.empty() ? "" : "_" + std::to_string(place + 1));
}

/// A curve through the first two columns of a file.
draw::Curve curve(const fs::path &file, const Look &look) {
  return {draw::gnuplot_columns(file, "1:2"), look.style, look.title};
}

/// Limits with the half of their brackets as error bars.
std::vector<draw::Curve> curve_with_bars(const std::map<double, ogive::LimitEstimate<double>> &limits,
                                         const fs::path &file, const Look &look) {
  std::string csv = "x,y,half_width\n";
  for (const auto &[x, limit] : limits)
    csv += options::joined(std::array{x, limit.limit, limit.half_width}, ",") + "\n";
  const fs::path points = written(csv, file);
  return {{draw::gnuplot_columns(points, "1:2:3"), "yerrorbars linecolor rgb '" + look.colour + "' pointtype 0"},
          curve(points, look)};
}

/// The range of an axis that holds all values, with a tenth of it on both sides.
std::string range_of(const std::set<double> &values) {
  const double low = *values.begin(), high = *values.rbegin();
  const double margin = (high > low ? high - low : std::max(high, 1.0)) / 10;
  return "[" + shortest(low >= 0 ? std::max(0.0, low - margin) : low - margin) + ":" + shortest(high + margin) + "]";
}

/// Plate and projectile that the shots of a panel share.
Specimen specimen_of(const Key &key) {
  const std::string &material = key.values[material_column];
  return {material.starts_with("weldox")   ? "Weldox 460 E"
          : material.starts_with("aa5083") ? "AA5083-H116"
                                           : material,
          key.values[nose_column], number(key, thickness_column)};
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

void draw_both(const std::string &commands, const fs::path &out, const std::string &name, draw::PictureSize size) {
  for (const char *kind : {".svg", ".png"}) draw::draw_with_gnuplot(commands, out / (name + kind), size);
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

bool draw_residuals(const Plot &plot, const std::vector<Series> &series, const std::vector<Row> &rows, const Texts &own,
                    const fs::path &out, bool with_fit) {
  std::map<Specimen, std::vector<const Series *>> panels;
  double slowest = 1e9, fastest = 300;
  for (const Series &one : series)
    if (const auto points = residuals(one.key, rows); !points.empty()) {
      panels[specimen_of(one.key)].push_back(&one);
      slowest = std::min(slowest, points.front().first);
      fastest = std::max(fastest, points.back().first);
    }
  if (panels.empty()) return false;
  const int count = static_cast<int>(panels.size()), columns = count > 4 ? 3 : count > 3 ? 2 : count;
  const int lines = (count + columns - 1) / columns;
  // The axes of the paper, where they hold all points.
  const bool is_usual = slowest >= 100 && fastest <= 420;
  std::string commands =
      options::printed("set multiplot layout %d,%d title ", lines, columns) + draw::gnuplot_quoted(plot.title) +
      "; set key left top reverse Left samplen 2 font ',12'; " +
      (is_usual ? "set xrange [100:420]; set yrange [0:400]; " : "set xrange [*:*]; set yrange [0:*]; ") + "set grid; ";
  int panel = 0;
  for (const auto &[specimen, members] : panels) {
    const std::string base = plot.name + "_" + std::to_string(++panel) + "_";
    draw::Plot one{.title = shortest(specimen.thickness_mm) + " mm " + specimen.metal + ", " + specimen.nose,
                   .x = "initial velocity, m/s",
                   .y = "residual velocity, m/s"};
    const auto add = [&](const Points &points, const std::string &what, const Look &look) {
      one.curves.push_back(curve(written(points, out / "plot_data" / (base + what + ".csv")), look));
    };
    const auto tested = std::find_if(members.begin(), members.end(),
                                     [](const Series *member) { return member->published.test_limit_mps.has_value(); });
    if (tested != members.end()) {
      const Published &published = (*tested)->published;
      add(points_of({published.a, published.p, *published.test_limit_mps}, std::max(420.0, fastest)), "test_curve",
          {"Recht-Ipson, measured limit", "lines linecolor rgb '#707070' dashtype 2 linewidth 1.5"});
      Points tests;
      for (const auto &shot : experiment::find_shots(specimen)) tests.emplace_back(shot.initial_mps, shot.residual_mps);
      if (!tests.empty()) add(tests, "tests", measured);
      if (const auto v = published.paper_velocity_mps)
        add({{*v, 0}}, "paper", {"paper, MJC: near its limit", of_paper.style});
    }
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Key &key = members[k]->key;
      const Look look = look_of(key, own, k);
      add(residuals(key, rows), file_part(key, own, k), look);
      if (const auto limits = with_fit ? limits_in({*members[k]}, rows) : std::vector<LimitRow>{};
          !limits.empty() && limits.front().fit)
        add(points_of(limits.front().fit->curve, fastest * 1.02), file_part(key, own, k) + "_fit",
            {"fit", "lines linecolor rgb '" + look.colour + "' dashtype 3 linewidth 1.5"});
    }
    commands += commands_of(one) + "; ";
  }
  draw_both(commands + "unset multiplot", out, plot.name, {520 * columns, 440 * lines + 40});
  return true;
}

bool draw_limits(const Plot &plot, const std::vector<LimitRow> &limits, const Texts &own, const fs::path &out) {
  if (limits.empty()) return false;
  const std::size_t abscissa = abscissa_of(limits);
  std::map<Key, std::map<double, ogive::LimitEstimate<double>>> computed;
  std::map<double, ogive::LimitEstimate<double>> tests;
  std::set<std::pair<double, double>> paper;
  std::set<double> places, velocities;
  const auto note = [&](double x, const ogive::LimitEstimate<double> &limit) {
    places.insert(x);
    velocities.insert({limit.limit - limit.half_width, limit.limit + limit.half_width});
    return limit;
  };
  for (const LimitRow &row : limits) {
    const double x = number(row.key, abscissa);
    if (!std::isfinite(x)) continue;
    if (const auto test = row.published.test_limit_mps) tests[x] = note(x, {*test, experiment::limit_half_width_mps});
    if (const auto v = row.published.paper_velocity_mps) paper.emplace(x, note(x, {*v, 0}).limit);
    Key curve_key = row.key;
    curve_key.values[abscissa].clear();
    // The metal of the weaker plate belongs to the same curve.
    if (abscissa == thickness_column) curve_key.values[material_column] = specimen_of(row.key).metal;
    if (const auto estimate = ogive::limit_estimate(row.bracket)) computed[curve_key][x] = note(x, *estimate);
  }
  if (computed.empty()) return false;
  const std::string base = (out / "plot_data" / plot.name).string();
  draw::Plot one{.title = plot.title,
                 .x = abscissa == thickness_column ? "plate thickness, mm" : column_name(abscissa, own),
                 .y = "ballistic limit, m/s",
                 .settings = "set key left top reverse Left; set grid; set xrange " + range_of(places) +
                             "; set yrange " + range_of(velocities)};
  const auto add = [&](const std::vector<draw::Curve> &curves) {
    one.curves.insert(one.curves.end(), curves.begin(), curves.end());
  };
  if (!tests.empty()) add(curve_with_bars(tests, base + "_tests.csv", measured));
  if (!paper.empty()) add({curve(written(Points(paper.begin(), paper.end()), base + "_paper.csv"), of_paper)});
  std::size_t place = 0;
  for (const auto &[key, estimates] : computed) {
    add(curve_with_bars(estimates, base + "_" + file_part(key, own, place) + ".csv", look_of(key, own, place)));
    ++place;
  }
  draw_both(commands_of(one), out, plot.name, {900, 600});
  return true;
}

} // namespace study
