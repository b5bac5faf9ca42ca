// SPDX-License-Identifier: BSD-3-Clause
#include "sections.hpp"

#include "../results.hpp"
#include "draw/section.hpp"
#include "options/text.hpp"

#include "ogive/fem/hex8.hpp"
#include "ogive/io/read_frame.hpp"

namespace commands::drawing {

using ogive::Frame;
using options::refuse;

namespace {

/// The number of the frame nearest to a time; refuses times that are not in the series.
std::size_t frame_at(const ogive::StoredSeries &series, double time_us) {
  if (time_us == last_time) return series.frames.size() - 1;
  const double last_us = series.frames.back().time * 1e6;
  // The last frame may come a step after the time that somebody reads off a table.
  if (time_us > last_us + 0.5)
    refuse("--times-us", options::shortest(time_us),
           "must not be later than the last frame of " + series.pvd.string() + ", " +
               options::shortest(std::round(last_us * 100) / 100) + " us");
  return ogive::nearest_frame(series, time_us * 1e-6);
}

/// Mean velocity of the projectile in the direction of flight, weighted by mass, m/s. Nothing if the frame lacks what
/// it takes.
std::optional<double> projectile_velocity(const Frame &frame) {
  const auto named = [](const auto &all, const char *name) {
    return std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.name == name; });
  };
  const auto grid = named(frame.grids, "projectile");
  if (grid == frame.grids.end() || grid->hexes.empty()) return std::nullopt;
  const auto velocity = named(grid->point_fields, "velocity_m_per_s");
  const auto density = named(grid->cell_fields, "density_kg_per_m3");
  if (velocity == grid->point_fields.end() || density == grid->cell_fields.end() || velocity->components != 3)
    return std::nullopt;
  double mass = 0, momentum = 0;
  for (std::size_t e = 0; e < grid->hexes.size(); ++e) {
    ogive::Corners<double> corners;
    double mean = 0;
    int c = 0;
    for (const auto n : grid->hexes[e]) {
      corners.row(c++) = grid->positions[static_cast<std::size_t>(n)].cast<double>();
      mean -= velocity->values[3 * static_cast<std::size_t>(n) + 2] / 8.0;
    }
    const double m = density->values[e] * ogive::hex_volume(corners);
    mass += m;
    momentum += m * mean;
  }
  return momentum / mass;
}

/// "(a) 40 µs, 151 m/s".
std::string time_label(std::size_t number, const Frame &frame) {
  const auto velocity = projectile_velocity(frame);
  return options::printed("(%c) %.0f µs", static_cast<int>('a' + number % 26), frame.time * 1e6) +
         // A rebound is no "-0".
         (velocity ? options::printed(", %.0f m/s", std::round(*velocity) + 0.0) : "");
}

/// The z below which the share `below` of the positions within a radius of the axis lies, mm; 0 if there are none.
double low_mm(const std::vector<ogive::Vec3<float>> &positions, double radius_mm, double below) {
  std::vector<float> heights;
  for (const auto &x : positions)
    if (std::hypot(x[0], x[1]) <= 1e-3F * static_cast<float>(radius_mm)) heights.push_back(x[2]);
  if (heights.empty()) return 0;
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(below * double(heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  return 1e3 * double(*place);
}

/// From well above the front face down to below the projectile and the plug.
std::array<double, 3> usual_view(const std::vector<draw::PanelCell> &cells) {
  std::array<double, 3> view{-20, 22, 28};
  const auto extend = [&](const auto &parts, double below) {
    for (const auto &part : parts) view[0] = std::min(view[0], std::floor(low_mm(part.positions, view[2], below) - 4));
  };
  for (const auto &cell : cells) {
    extend(cell.frame.grids, 0);
    // A plug is a sixth of the disc; splinters are far less, and may have flown far ahead.
    extend(cell.frame.clouds, 0.01);
  }
  return view;
}

std::vector<draw::PanelCell> read_cells(const Options &o) {
  std::vector<draw::PanelCell> cells;
  for (const auto &given : o.series) {
    const auto series = ogive::read_series(find_pvd(given, "--series"));
    std::vector<std::size_t> numbers;
    for (const double time_us : o.times_us) numbers.push_back(frame_at(series, time_us));
    for (const std::size_t k : numbers) {
      const std::size_t n = cells.size();
      auto &cell = cells.emplace_back(draw::PanelCell{ogive::read_frame(series, k, symmetry_of(o.extent)), ""});
      cell.label = o.label.empty() ? time_label(n, cell.frame) : o.label[n];
      if (o.label.empty() && o.series.size() > 1) cell.label.insert(4, folder_name(series.pvd) + ", ");
    }
  }
  return cells;
}

} // namespace

void draw_sections(const Options &o) {
  const auto cells = read_cells(o);
  const bool strain = o.colour == Colour::plastic_strain;
  const auto range = o.range.value_or(strain ? std::array{0.0, 1.5} : std::array{300.0, 900.0});
  const auto view = o.view_mm ? *o.view_mm : usual_view(cells);
  draw::SectionPanel panel{.title = o.title,
                           .bar_title = strain ? "plastic strain" : "temperature (K)",
                           .low_mm = view[0],
                           .high_mm = view[1],
                           .radius_mm = view[2],
                           .columns = o.columns.value_or(0)};
  panel.style.field = strain ? "plastic_strain" : "temperature_K";
  panel.style.smallest = range[0];
  panel.style.largest = range[1];
  panel.style.mesh_edges = o.mesh_edges;
  draw::render_panel(cells, o.out, panel);
}

} // namespace commands::drawing
