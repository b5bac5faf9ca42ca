// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "draw/plot.hpp"
#include "materials/material_keys.hpp"

#include "ogive/io/atomic_file.hpp"

namespace metals {

namespace {

/// A curve: how it is drawn and the points of its column.
struct Column {
  std::string title;
  std::string look;
  std::vector<double> values;
};

/// A table of curves over the same abscissa.
struct Panel {
  std::string title, x, y, settings;
  std::vector<double> abscissa{};
  std::vector<Column> columns{};
};

std::string line(std::size_t colour, const char *dash = "") {
  return "lines linewidth 2.5 linecolor " + draw::gnuplot_colour(colour) + dash;
}

/// Writes the points of a panel and returns its plot.
draw::Plot plot_of(const Panel &panel, const std::filesystem::path &table) {
  std::string text = panel.x;
  for (const Column &column : panel.columns) text += "," + column.title;
  for (std::size_t k = 0; k < panel.abscissa.size(); ++k) {
    text += "\n" + ogive::with_digits(panel.abscissa[k], 6);
    for (const Column &column : panel.columns) text += "," + ogive::with_digits(column.values[k], 6);
  }
  ogive::write_atomically(table, text + "\n");
  draw::Plot plot{.title = panel.title, .x = panel.x, .y = panel.y, .settings = panel.settings};
  for (std::size_t c = 0; c < panel.columns.size(); ++c)
    plot.curves.push_back(
        {draw::gnuplot_columns(table, "1:" + std::to_string(c + 2)), panel.columns[c].look, panel.columns[c].title});
  return plot;
}

/// Flow stress (MPa) at a rate (1/s) and temperature (K), which plastic work raises if `heats`.
template <class M>
std::vector<double> stresses(const M &metal, const std::vector<double> &strains, double rate, double temperature,
                             bool heats) {
  constexpr int steps = 20; // between two points
  std::vector<double> all;
  double last = 0;
  for (const double strain : strains) {
    for (int k = 0; k < steps && heats && metal.specific_heat > 0; ++k) {
      const double step = (strain - last) / steps, middle = last + (k + 0.5) * step;
      temperature += metal.taylor_quinney * flow_stress(metal, middle, rate, temperature).value * step /
                     (metal.density * metal.specific_heat);
    }
    last = strain;
    all.push_back(flow_stress(metal, strain, rate, temperature).value / 1e6);
  }
  return all;
}

/// A temperature with T* = 0.4, in whole kelvins.
template <class M> double warm_temperature(const M &metal) {
  return std::round(metal.room_temperature + 0.4 * (metal.melting_temperature - metal.room_temperature));
}

template <class M> Panel flow_panel(const M &metal, const std::string &title) {
  Panel panel{.title = title,
              .x = "plastic strain",
              .y = "flow stress / MPa",
              .settings =
                  "set key bottom right opaque; set xrange [0:1]; set xtics 0.5; set grid noxtics; set yrange [0:*]"};
  constexpr int points = 32;
  for (int k = 0; k <= points; ++k) panel.abscissa.push_back(double(k) * k / (points * points));
  const double room = metal.room_temperature, warm = warm_temperature(metal);
  const auto add = [&](const std::string &name, const std::string &look, double rate, double temperature, bool heats) {
    panel.columns.push_back({name, look, stresses(metal, panel.abscissa, rate, temperature, heats)});
  };
  add(options::printed("%g 1/s", metal.rate_floor), line(0), metal.rate_floor, room, false);
  add("1000 1/s", line(2), 1e3, room, false);
  add("100000 1/s", line(4), 1e5, room, false);
  add("1000 1/s, adiabatic", line(2, " dashtype 2"), 1e3, room, true);
  if (metal.melting_temperature < 9999)
    add(options::printed("%g 1/s, %g K", metal.rate_floor, warm), line(1), metal.rate_floor, warm, false);
  return panel;
}

/// Plastic strain at which Cockcroft and Latham's work is used up at a constant triaxiality, in stress states with one
/// axis of symmetry, at the smallest rate and room temperature; infinite beyond `most`.
template <class M> double strain_of_work(const M &metal, double triaxiality, double most) {
  constexpr int steps = 1000;
  const double ratio = std::max(0.0, triaxiality + 2.0 / 3), step = most / steps; // largest principal over equivalent
  double work = 0;
  for (int k = 0; k < steps; ++k) {
    work += ratio * flow_stress(metal, (k + 0.5) * step, metal.rate_floor, metal.room_temperature).value * step;
    if (work >= metal.damage.critical_work) return (k + 1) * step;
  }
  return std::numeric_limits<double>::infinity();
}

template <class M> Panel failure_panel(const M &metal) {
  constexpr double most = 3;
  Panel panel{.title = "failure strain",
              .x = "triaxiality",
              .y = "plastic strain at failure",
              .settings = options::printed("set key top right opaque; set xrange [-0.4:2]; set xtics 0.5; set grid "
                                           "noxtics; set ytics 1; set yrange [0:%g]",
                                           most)};
  for (int k = 0; k <= 32; ++k) panel.abscissa.push_back(-0.4 + 0.075 * k);
  const auto add = [&](const std::string &title, const std::string &look, auto &&strain) {
    panel.columns.push_back({title, look, {}});
    for (const double triaxiality : panel.abscissa)
      panel.columns.back().values.push_back(std::min(strain(triaxiality), 10.0));
  };
  if (has(metal, materials::Group::strain)) {
    const auto &f = metal.damage.failure_strain;
    add(options::printed("%g 1/s", metal.rate_floor), line(0),
        [&](double s) { return failure_strain(f, s, metal.rate_floor, 0.0); });
    add("10000 1/s", line(4), [&](double s) { return failure_strain(f, s, 1e4, 0.0); });
    const double warm = warm_temperature(metal);
    add(options::printed("%g 1/s, %g K", metal.rate_floor, warm), line(1),
        [&](double s) { return failure_strain(f, s, metal.rate_floor, homologous_temperature(metal, warm)); });
  }
  if (has(metal, materials::Group::work))
    add("Cockcroft-Latham", line(6, " dashtype 2"), [&](double s) { return strain_of_work(metal, s, most); });
  return panel;
}

} // namespace

void draw_metal(const materials::AnyMetal &any, const std::string &title, const std::filesystem::path &picture) {
  ogive::require_replaceable(picture);
  const auto table = [&](const char *what) {
    return std::filesystem::path(picture).replace_extension(std::string(what) + ".csv");
  };
  std::visit(
      [&](const auto &metal) {
        std::string commands = commands_of(plot_of(flow_panel(metal, title), table("flow")));
        const Panel failure = failure_panel(metal);
        if (!failure.columns.empty())
          commands = "set multiplot layout 1,2; " + commands + "; " + commands_of(plot_of(failure, table("failure"))) +
                     "; unset multiplot";
        draw::draw_with_gnuplot(commands, picture, {.width = failure.columns.empty() ? 600 : 1100, .height = 450});
      },
      any);
}

} // namespace metals
