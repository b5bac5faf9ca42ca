// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "draw/plot.hpp"

#include "ogive/fit/strain_bins.hpp"
#include "ogive/fit/stress_curve.hpp"
#include "ogive/io/atomic_file.hpp"

#include <set>

namespace calibrate {

namespace {

using ogive::CurveUse;
using ogive::SortedCurve;
using options::printed;
using options::shortest;
using Curves = std::vector<draw::Curve>;

/// A table that grows in memory, to be written at once.
struct Table {
  std::string text;

  void add(std::initializer_list<double> values) { text += options::joined(values, ",") + "\n"; }
};

/// Points from 0 to the last strain of the curves that belong, denser at the start where a power law is steep.
std::vector<double> strains_of(const Results &r, auto &&belongs) {
  double last = 0;
  for (const auto &s : r.series.curves)
    if (belongs(s)) last = std::max(last, s.curve.strain.back());
  constexpr int steps = 200;
  std::vector<double> strains;
  for (int i = 0; i <= steps; ++i) strains.push_back(last * (double(i) / steps) * (double(i) / steps));
  return strains;
}

/// Data that all plots of one calibration share.
struct Plots {
  const Options &options;
  const Results &results;
  const ogive::Calibration &law;
  std::string left_out;

  void write(const std::string &name, const Table &table) const {
    ogive::write_atomically(options.out / name, table.text);
  }

  /// Columns `columns` ("2:3") of the rows of a table whose column `key` has a value.
  std::string rows(const std::string &table, int key, double value, const std::string &columns) const {
    const auto colon = columns.find(':');
    return draw::gnuplot_columns(options.out / table, "($" + std::to_string(key) + "==" + shortest(value) + " ? $" +
                                                          columns.substr(0, colon) + " : 1/0)" + columns.substr(colon));
  }

  /// The points of curve `c`.
  std::string points_of(std::size_t c) const { return rows("points.csv", 1, double(c + 1), "7:8"); }

  /// Draws a plot against the plastic strain. An old picture never stays beside new numbers.
  void draw(const std::string &name, draw::Plot plot) {
    std::error_code ignored;
    std::filesystem::remove(options.out / name, ignored);
    if (!options.plots || plot.curves.empty()) return;
    plot.title = options.name + ", " + plot.title;
    plot.x = "plastic strain";
    try {
      draw::draw_with_gnuplot(commands_of(plot), options.out / name);
    } catch (const std::exception &error) {
      left_out += (left_out.empty() ? "" : "; ") + std::string(error.what());
    }
  }
};

std::string colour(std::size_t k) { return " lc rgb " + draw::gnuplot_colour(k); }
const std::string circles = "points pointtype 6 pointsize 0.5", line = "lines linewidth 2",
                  error_bars = "yerrorbars pointtype 7 pointsize 0.5";
const std::string stress = "true stress / MPa", from_zero = "set key bottom right; set yrange [0:*]";

/// points.csv: every point of every curve, and the law along the temperature of the test.
void write_points(const Plots &p) {
  Table t{"curve,hardening,used,strain_rate_per_s,initial_temperature_K,temperature_K,plastic_strain,stress_MPa,"
          "law_MPa\n"};
  for (std::size_t k = 0; k < p.results.series.curves.size(); ++k) {
    const auto &s = p.results.series.curves[k];
    for (std::size_t i = 0; i < s.curve.strain.size(); ++i) {
      const double law = flow_stress_value(p.law, s.hardening, s.curve.strain[i], s.curve.rate, s.temperature[i]);
      t.add({double(k + 1), double(s.hardening + 1), double(s.use != CurveUse::left_out), s.curve.rate,
             s.curve.temperature, s.temperature[i], s.curve.strain[i], s.curve.stress[i] * 1e-6, law * 1e-6});
    }
  }
  p.write("points.csv", t);
}

/// hardening.csv, hardening.svg (Fig. 1a) and plates.svg (Fig. 3).
void write_hardening(Plots &p) {
  const auto &curves = p.results.series.curves;
  const std::size_t count = p.law.hardenings.size();
  Table t{"hardening,plastic_strain,stress_MPa\n"};
  const auto strains = strains_of(p.results, [](const SortedCurve &s) { return s.use == CurveUse::quasi_static; });
  for (std::size_t h = 0; h < count; ++h)
    for (const double strain : strains)
      t.add({double(h + 1), strain, ogive::quasi_static_stress(p.law.quasi_static[h], strain) * 1e-6});
  p.write("hardening.csv", t);

  const auto add_pair = [&](Curves &plot, std::size_t h, std::string name, const std::string &law,
                            std::size_t law_colour) {
    for (std::size_t k = 0; k < curves.size(); ++k)
      if (curves[k].use == CurveUse::quasi_static && curves[k].hardening == h)
        plot.push_back({p.points_of(k), circles + colour(h), std::exchange(name, "")});
    plot.push_back({p.rows("hardening.csv", 1, double(h + 1), "2:3"), line + colour(law_colour), law});
  };
  const std::string rate = printed("%g 1/s", p.results.series.quasi_static_rate);
  const auto &q = p.law.quasi_static[0];
  Curves first, plates;
  add_pair(first, 0, "curve", printed("%.1f + %.1f ε^%.4f MPa", q.A * 1e-6, q.B * 1e-6, q.a), 1);
  p.draw("hardening.svg", {"quasi-static, " + rate, "", stress, from_zero, first});
  for (std::size_t h = 0; count > 1 && h < count; ++h)
    if (!(p.results.series.pooled && h + 1 == count)) add_pair(plates, h, p.law.hardenings[h], "", h);
  p.draw("plates.svg", {"each plate, " + rate, "", stress, from_zero, plates});
}

/// A line over the window from which a parameter is taken.
draw::Curve plateau(const ogive::Interval &window, double last, double value, const std::string &title) {
  return {"[" + shortest(window.from) + ":" + shortest(std::min(window.to, last)) + "] " + shortest(value),
          line + colour(1), title};
}

/// rate_exponent.csv and .svg (Fig. 1b).
void write_rate_exponent(Plots &p) {
  Table t{"plastic_strain,C,standard_error,points\n"};
  const auto bins = rate_bins(p.results.series, p.law);
  for (const auto &bin : bins)
    if (std::isfinite(bin.standard_error)) t.add({bin.strain, bin.value, bin.standard_error, double(bin.points)});
  p.write("rate_exponent.csv", t);
  Curves plot;
  if (!bins.empty())
    plot = {{draw::gnuplot_columns(p.options.out / "rate_exponent.csv", "1:2:3"), error_bars + colour(0),
             "bin, ± standard error"},
            plateau(p.results.series.settings.rate_window, bins.back().strain, p.law.C, printed("C = %.5f", p.law.C))};
  p.draw("rate_exponent.svg",
         {"from each bin of plastic strain", "", "C", "set key top right; set xrange [0:*]", plot});
}

/// thermal_exponent.csv and .svg (Fig. 1c). Temperature 0 means all together.
void write_thermal_exponent(Plots &p) {
  Table t{"initial_temperature_K,plastic_strain,b,standard_error,points\n"};
  const std::string table = "thermal_exponent.csv", letter = parameters_of(p.law, 0).back().name;
  Curves plot;
  double last = 0;
  const auto all = thermal_bins(p.results.series, p.law);
  for (const auto &[temperature, bins] : all) {
    for (const auto &bin : bins)
      if (std::isfinite(bin.standard_error))
        t.add({temperature, bin.strain, bin.value, bin.standard_error, double(bin.points)});
    last = std::max(last, bins.back().strain);
    const std::size_t k = plot.size() + 2;
    if (temperature != 0)
      plot.push_back({p.rows(table, 1, temperature, "2:3"),
                      "points pointsize 0.8 pointtype " + std::to_string(k) + colour(k), shortest(temperature) + " K"});
  }
  p.write(table, t);
  if (!all.empty()) {
    plot.push_back({p.rows(table, 1, 0, "2:3:4"), error_bars + colour(0), "all, ± standard error"});
    plot.push_back(
        plateau(p.results.series.settings.thermal_window, last, p.law.b, letter + printed(" = %.4f", p.law.b)));
  }
  p.draw("thermal_exponent.svg",
         {"from each bin of plastic strain", "", letter, "set key below; set xrange [0:*]", plot});
}

/// Whether a curve belongs to hardening `h` and was taken at room temperature.
bool is_at_room(const SortedCurve &s, std::size_t h) {
  return s.hardening == h && (s.use == CurveUse::quasi_static || s.use == CurveUse::rate);
}

std::set<double> rates_of(const Results &r, std::size_t h) {
  std::set<double> rates;
  for (const auto &s : r.series.curves)
    if (is_at_room(s, h)) rates.insert(s.curve.rate);
  return rates;
}

/// prediction.csv and .svg (Fig. 2), of the hardening with the most rates at room temperature: there is most to
/// compare.
void write_prediction(Plots &p) {
  std::size_t h = 0;
  for (std::size_t k = 1; k < p.results.series.hardenings.size(); ++k)
    if (rates_of(p.results, k).size() > rates_of(p.results, h).size()) h = k;
  const auto &wanted = p.options.predict_rates_per_s;
  const auto rates = wanted.empty() ? rates_of(p.results, h) : std::set<double>(wanted.begin(), wanted.end());
  const auto strains = strains_of(p.results, [&](const SortedCurve &s) { return is_at_room(s, h); });
  Table t{"strain_rate_per_s,plastic_strain,stress_MPa,temperature_K\n"};
  for (const double rate : rates) {
    const double heat = rate >= p.options.adiabatic_above_per_s ? heat_per_work(p.options) : 0;
    const auto points = with_law(p.law, h, [&](const auto &law) {
      return adiabatic_curve(law, p.law.frame.temperatures(), rate, p.options.room_K, heat, strains);
    });
    for (const auto &q : points) t.add({rate, q.strain, q.stress * 1e-6, q.temperature});
  }
  p.write("prediction.csv", t);

  Curves plot;
  const auto add_tests = [&](auto &&belongs, const std::string &style, std::string title) {
    const auto &curves = p.results.series.curves;
    for (std::size_t c = 0; c < curves.size(); ++c)
      if (is_at_room(curves[c], h) && belongs(curves[c].curve.rate))
        plot.push_back({p.points_of(c), circles + style, std::exchange(title, "")});
  };
  add_tests([&](double rate) { return !rates.contains(rate); }, " lc rgb '#b0b0b0'", "curves at other rates");
  std::size_t k = 0;
  for (const double rate : rates) {
    add_tests([&](double other) { return other == rate; }, colour(k), "");
    plot.push_back({p.rows("prediction.csv", 1, rate, "2:3"), line + colour(k++), shortest(rate) + " 1/s"});
  }
  const std::string plate = p.law.hardenings.size() > 1 ? "plate " + p.law.hardenings[h] + ", " : "";
  p.draw("prediction.svg", {plate + "curves (points) and law (lines)", "", stress, from_zero, plot});
}

} // namespace

std::string write_plots(const Options &o, const Results &r) {
  Plots p{o, r, r.chosen.steps.law, {}};
  write_points(p);
  write_hardening(p);
  write_rate_exponent(p);
  write_thermal_exponent(p);
  write_prediction(p);
  return p.left_out;
}

} // namespace calibrate
