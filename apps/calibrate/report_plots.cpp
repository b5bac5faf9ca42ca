// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "shared/input.hpp"

#include "ogive/fit/strain_bins.hpp"
#include "ogive/fit/stress_curve.hpp"
#include "ogive/io/gnuplot.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace calibrate {

namespace {

using input::shortest;
using ogive::gnuplot_quoted;

/// A table that grows in memory, to be written at once.
struct Table {
  std::string text;

  explicit Table(const std::string &header) : text(header + "\n") {}
  void add(std::initializer_list<double> values) {
    for (const double value : values) text += shortest(value) + ",";
    text.back() = '\n';
  }
};

/// Colours that can be told apart (Okabe & Ito 2008).
std::string colour(std::size_t k) {
  constexpr std::array<const char *, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#404040", "#8c6d00"};
  return std::string("'") + colours[k % colours.size()] + "'";
}

std::string number(double value, const char *format) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Points from 0 to `to`, denser at the start where a power law is steep.
std::vector<double> strains_up_to(double to) {
  std::vector<double> strains;
  constexpr int steps = 200;
  for (int i = 0; i <= steps; ++i) strains.push_back(to * (double(i) / steps) * (double(i) / steps));
  return strains;
}

double last_strain(const Results &r, auto &&belongs) {
  double last = 0;
  for (const auto &s : r.series.curves)
    if (belongs(s)) last = std::max(last, s.curve.strain.back());
  return last;
}

/// What the plots of one calibration share.
struct Plots {
  const Options &options;
  const Results &results;
  const ogive::Calibration &law;
  std::string left_out;

  std::filesystem::path file(const std::string &name) const { return options.out / name; }
};

void draw(Plots &p, const std::string &name, const std::string &commands) {
  if (!p.options.plots) return;
  try {
    ogive::draw_with_gnuplot(commands, p.file(name));
  } catch (const std::exception &error) {
    p.left_out += (p.left_out.empty() ? "" : "; ") + std::string(error.what());
  }
}

std::string axes(const std::string &title, const std::string &y) {
  return "set title " + gnuplot_quoted(title) + "; set xlabel 'plastic strain'; set ylabel " + gnuplot_quoted(y) + "; ";
}

/// Rows of a table where a column has a value.
std::string rows_where(const std::filesystem::path &file, int column, double value, int x, int y) {
  return ogive::gnuplot_file(file) + " every ::1 using ($" + std::to_string(column) + "==" + shortest(value) + " ? $" +
         std::to_string(x) + " : 1/0):" + std::to_string(y);
}

/// points.csv: every point of every curve, and the law along the temperature of the test.
void write_points(const Plots &p) {
  Table t("curve,hardening,used,strain_rate_per_s,initial_temperature_K,temperature_K,plastic_strain,stress_MPa,"
          "law_MPa");
  for (std::size_t k = 0; k < p.results.series.curves.size(); ++k) {
    const auto &s = p.results.series.curves[k];
    for (std::size_t i = 0; i < s.curve.strain.size(); ++i) {
      const double law = flow_stress_value(p.law, s.hardening, s.curve.strain[i], s.curve.rate, s.temperature[i]);
      t.add({double(k + 1), double(s.hardening + 1), double(s.use != ogive::CurveUse::left_out), s.curve.rate,
             s.curve.temperature, s.temperature[i], s.curve.strain[i], s.curve.stress[i] * 1e-6, law * 1e-6});
    }
  }
  ogive::write_atomically(p.file("points.csv"), t.text);
}

/// hardening.csv, hardening.svg (Fig. 1a) and plates.svg (Fig. 3).
void write_hardening(Plots &p) {
  const auto &curves = p.results.series.curves;
  Table t("hardening,plastic_strain,stress_MPa");
  for (std::size_t h = 0; h < p.law.hardenings.size(); ++h) {
    const double last = last_strain(p.results, [&](const auto &s) { return s.use == ogive::CurveUse::quasi_static; });
    for (const double strain : strains_up_to(last))
      t.add({double(h + 1), strain, ogive::quasi_static_stress(p.law.quasi_static[h], strain) * 1e-6});
  }
  ogive::write_atomically(p.file("hardening.csv"), t.text);

  const auto pair = [&](std::size_t h, const std::string &name, bool with_formula) {
    const auto &q = p.law.quasi_static[h];
    const std::string formula = number(q.A * 1e-6, "%.1f + ") + number(q.B * 1e-6, "%.1f ε^") + number(q.a, "%.4f MPa");
    std::string text;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (curves[k].use != ogive::CurveUse::quasi_static || curves[k].hardening != h) continue;
      text += rows_where(p.file("points.csv"), 1, double(k + 1), 7, 8) +
              " with points pointtype 6 pointsize 0.5 lc rgb " + colour(h) +
              (text.empty() ? " title " + gnuplot_quoted(name) : " notitle") + ", ";
    }
    return text + rows_where(p.file("hardening.csv"), 1, double(h + 1), 2, 3) + " with lines linewidth 2 lc rgb " +
           colour(with_formula ? 1 : h) + (with_formula ? " title " + gnuplot_quoted(formula) : " notitle");
  };
  const std::string rate = number(p.results.series.quasi_static_rate, "%g 1/s");
  const std::string at = "set key bottom right; set yrange [0:*]; plot ";
  draw(p, "hardening.svg",
       axes(p.options.name + ", quasi-static, " + rate, "true stress / MPa") + at + pair(0, "test", true));
  if (p.law.hardenings.size() < 2) return;
  std::string all;
  for (std::size_t h = 0; h < p.law.hardenings.size(); ++h)
    if (!(p.results.series.pooled && h + 1 == p.law.hardenings.size()))
      all += (h == 0 ? "" : ", ") + pair(h, p.law.hardenings[h], false);
  draw(p, "plates.svg", axes(p.options.name + ", each plate, " + rate, "true stress / MPa") + at + all);
}

/// A line over the window from which a parameter is taken.
std::string plateau(const ogive::Interval &window, double last, double value, const std::string &title) {
  return "[" + shortest(window.from) + ":" + shortest(std::min(window.to, last)) + "] " + shortest(value) +
         " with lines linewidth 2 lc rgb " + colour(1) + " title " + gnuplot_quoted(title);
}

/// rate_exponent.csv and .svg (Fig. 1b).
void write_rate_exponent(Plots &p) {
  Table t("plastic_strain,C,standard_error,points");
  const auto bins = rate_bins(p.results.series, p.law);
  for (const auto &bin : bins)
    if (std::isfinite(bin.standard_error)) t.add({bin.strain, bin.value, bin.standard_error, double(bin.points)});
  ogive::write_atomically(p.file("rate_exponent.csv"), t.text);
  if (bins.empty()) return;
  draw(p, "rate_exponent.svg",
       axes(p.options.name + ", from each bin of plastic strain", "C") + "set key top right; set xrange [0:*]; plot " +
           ogive::gnuplot_file(p.file("rate_exponent.csv")) +
           " every ::1 using 1:2:3 with yerrorbars pointtype 7 pointsize 0.5 lc rgb " + colour(0) +
           " title 'bin, ± standard error', " +
           plateau(p.results.series.settings.rate_window, bins.back().strain, p.law.C, number(p.law.C, "C = %.5f")));
}

/// thermal_exponent.csv and .svg (Fig. 1c). Temperature 0 stands for all together.
void write_thermal_exponent(Plots &p) {
  Table t("initial_temperature_K,plastic_strain,b,standard_error,points");
  const auto all = thermal_bins(p.results.series, p.law);
  for (const auto &[temperature, bins] : all)
    for (const auto &bin : bins)
      if (std::isfinite(bin.standard_error))
        t.add({temperature, bin.strain, bin.value, bin.standard_error, double(bin.points)});
  const auto file = p.file("thermal_exponent.csv");
  ogive::write_atomically(file, t.text);
  if (all.empty()) return;
  const std::string letter = parameter_names(p.law.frame.form).back();
  std::string plot;
  std::size_t k = 2;
  double last = 0;
  for (const auto &[temperature, bins] : all) {
    last = std::max(last, bins.back().strain);
    if (temperature == 0) continue;
    plot += rows_where(file, 1, temperature, 2, 3) + " with points pointsize 0.8 pointtype " + std::to_string(k) +
            " lc rgb " + colour(k) + " title " + gnuplot_quoted(shortest(temperature) + " K") + ", ";
    ++k;
  }
  plot +=
      rows_where(file, 1, 0, 2, 3) + ":4 with yerrorbars pointtype 7 pointsize 0.5 lc rgb " + colour(0) +
      " title 'all, ± standard error', " +
      plateau(p.results.series.settings.thermal_window, last, p.law.b, number(p.law.b, (letter + " = %.4f").c_str()));
  draw(p, "thermal_exponent.svg",
       axes(p.options.name + ", from each bin of plastic strain", letter) + "set key below; set xrange [0:*]; plot " +
           plot);
}

/// The hardening with the most rates at room temperature: there is most to compare with.
std::size_t most_rates(const Results &r) {
  std::vector<std::set<double>> rates(r.series.hardenings.size());
  for (const auto &s : r.series.curves)
    if (s.use == ogive::CurveUse::quasi_static || s.use == ogive::CurveUse::rate)
      rates[s.hardening].insert(s.curve.rate);
  const auto more = [](const auto &a, const auto &b) { return a.size() < b.size(); };
  return static_cast<std::size_t>(std::max_element(rates.begin(), rates.end(), more) - rates.begin());
}

/// Stress and temperature of the law at room temperature.
std::vector<ogive::LawPoint> prediction(const Plots &p, std::size_t h, double rate,
                                        const std::vector<double> &strains) {
  const auto &law = p.law;
  const double heat = rate >= p.options.adiabatic_above_per_s ? heat_per_work(p.options) : 0, room = p.options.room_K;
  if (law.frame.form == ogive::FlowForm::modified)
    return adiabatic_curve(modified_law(law.hardening[h], law.C, law.b), law.frame.temperatures(), rate, room, heat,
                           strains);
  return adiabatic_curve(classical_law(law.frame, law.hardening[h], law.C, law.b), law.frame.temperatures(), rate, room,
                         heat, strains);
}

/// prediction.csv and .svg (Fig. 2).
void write_prediction(Plots &p) {
  const std::size_t h = most_rates(p.results);
  const auto at_room = [&](const ogive::SortedCurve &s) {
    return s.hardening == h && (s.use == ogive::CurveUse::quasi_static || s.use == ogive::CurveUse::rate);
  };
  std::set<double> rates(p.options.predict_rates_per_s.begin(), p.options.predict_rates_per_s.end());
  const bool asked = !rates.empty();
  for (const auto &s : p.results.series.curves)
    if (at_room(s) && !asked) rates.insert(s.curve.rate);
  Table t("strain_rate_per_s,plastic_strain,stress_MPa,temperature_K");
  for (const double rate : rates)
    for (const auto &q : prediction(p, h, rate, strains_up_to(last_strain(p.results, at_room))))
      t.add({rate, q.strain, q.stress * 1e-6, q.temperature});
  ogive::write_atomically(p.file("prediction.csv"), t.text);

  std::string plot;
  const auto add_tests = [&](auto &&belongs, const std::string &line_colour, std::string title) {
    for (std::size_t c = 0; c < p.results.series.curves.size(); ++c) {
      const auto &s = p.results.series.curves[c];
      if (!at_room(s) || !belongs(s.curve.rate)) continue;
      plot += rows_where(p.file("points.csv"), 1, double(c + 1), 7, 8) +
              " with points pointtype 6 pointsize 0.5 lc rgb " + line_colour + " " + title + ", ";
      title = "notitle";
    }
  };
  add_tests([&](double rate) { return !rates.contains(rate); }, "'#b0b0b0'", "title 'tests at other rates'");
  std::size_t k = 0;
  for (const double rate : rates) {
    add_tests([&](double other) { return other == rate; }, colour(k), "notitle");
    plot += rows_where(p.file("prediction.csv"), 1, rate, 2, 3) + " with lines linewidth 2 lc rgb " + colour(k) +
            " title " + gnuplot_quoted(shortest(rate) + " 1/s") + ", ";
    ++k;
  }
  plot.resize(plot.size() - 2);
  const std::string plate = p.law.hardenings.size() > 1 ? ", plate " + p.law.hardenings[h] : "";
  draw(p, "prediction.svg",
       axes(p.options.name + plate + ", tests (points) and law (lines)", "true stress / MPa") +
           "set key bottom right; set yrange [0:*]; plot " + plot);
}

} // namespace

std::string write_plots(const Options &o, const Results &r) {
  Plots p{o, r, r.chosen.steps.law, {}};
  // What is not drawn this time must not stand beside the new numbers.
  for (const char *name :
       {"hardening.svg", "rate_exponent.svg", "thermal_exponent.svg", "prediction.svg", "plates.svg"}) {
    std::error_code ignored;
    std::filesystem::remove(o.out / name, ignored);
  }
  write_points(p);
  write_hardening(p);
  write_rate_exponent(p);
  write_thermal_exponent(p);
  write_prediction(p);
  return p.left_out;
}

} // namespace calibrate
