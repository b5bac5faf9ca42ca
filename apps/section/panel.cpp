// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "ogive/fem/hex8.hpp"
#include "ogive/io/read_frame.hpp"
#include "ogive/io/section_panel.hpp"
#include "shared/input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace section {

namespace {

namespace fs = std::filesystem;
using ogive::Frame;

/// The .pvd file that is meant: the one in a folder, or the file itself.
fs::path find_pvd(const fs::path &given) {
  std::error_code ignored;
  if (!fs::is_directory(given, ignored)) return given;
  std::vector<fs::path> found;
  for (const auto &entry : fs::directory_iterator(given, ignored))
    if (entry.path().extension() == ".pvd") found.push_back(entry.path());
  if (found.size() != 1)
    input::refuse("--series", given.string(),
                  found.empty() ? "must be a folder with a .pvd file, or a .pvd file"
                                : "must be a folder with one .pvd file, or the one that is meant");
  return found.front();
}

/// The number of the frame nearest to a time; refuses times that are not in the series.
std::size_t frame_at(const ogive::StoredSeries &series, double time_us) {
  if (time_us == last_time) return series.frames.size() - 1;
  const double last_us = series.frames.back().time * 1e6;
  // The last frame may come a step after the time that somebody reads off a table.
  if (time_us > last_us + 0.5)
    input::refuse("--times-us", input::shortest(time_us),
                  "must not be later than the last frame of " + series.pvd.string() + ", " +
                      input::shortest(std::round(last_us * 100) / 100) + " us");
  return ogive::nearest_frame(series, time_us * 1e-6);
}

const ogive::HexGrid *find_grid(const Frame &frame, const char *name) {
  for (const auto &grid : frame.grids)
    if (grid.name == name) return &grid;
  return nullptr;
}

/// Mean velocity of the projectile in the direction of flight, weighted by mass, m/s. Nothing if the frame lacks what
/// it takes.
std::optional<double> projectile_velocity(const Frame &frame) {
  const ogive::HexGrid *grid = find_grid(frame, "projectile");
  if (grid == nullptr || grid->hexes.empty()) return std::nullopt;
  const auto find = [](const std::vector<ogive::Field> &fields, const char *name) {
    return std::find_if(fields.begin(), fields.end(), [&](const auto &field) { return field.name == name; });
  };
  const auto velocity = find(grid->point_fields, "velocity_m_per_s");
  const auto density = find(grid->cell_fields, "density_kg_per_m3");
  if (velocity == grid->point_fields.end() || density == grid->cell_fields.end() || velocity->components != 3)
    return std::nullopt;
  double mass = 0, momentum = 0;
  for (std::size_t e = 0; e < grid->hexes.size(); ++e) {
    ogive::Corners<double> corners;
    double mean = 0;
    for (int c = 0; c < 8; ++c) {
      const auto n = static_cast<std::size_t>(grid->hexes[e][static_cast<std::size_t>(c)]);
      corners.row(c) = grid->positions[n].cast<double>();
      mean -= velocity->values[3 * n + 2] / 8.0;
    }
    const double m = density->values[e] * ogive::hex_volume(corners);
    mass += m;
    momentum += m * mean;
  }
  return momentum / mass;
}

/// "(a) 40 µs, 151 m/s".
std::string time_label(std::size_t number, const Frame &frame) {
  char text[80];
  const auto velocity = projectile_velocity(frame);
  // A rebound is no "-0".
  const double shown = std::round(velocity.value_or(0)) + 0.0;
  const int length = std::snprintf(text, sizeof text, "(%c) %.0f µs", char('a' + number % 26), frame.time * 1e6);
  if (velocity) std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), ", %.0f m/s", shown);
  return text;
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
View usual_view(const std::vector<ogive::PanelCell> &cells) {
  View view{-20, 22, 28};
  for (const auto &cell : cells) {
    const auto extend = [&](const auto &parts, double below) {
      for (const auto &part : parts)
        view.low_mm = std::min(view.low_mm, std::floor(low_mm(part.positions, view.radius_mm, below) - 4));
    };
    extend(cell.frame.grids, 0);
    // A plug is a sixth of the disc; splinters are far less, and may have flown far ahead.
    extend(cell.frame.clouds, 0.01);
  }
  return view;
}

std::vector<ogive::PanelCell> read_cells(const Options &o) {
  std::optional<ogive::SymmetryPlanes> symmetry;
  if (o.extent) symmetry = ogive::symmetry_planes(*o.extent);
  std::vector<ogive::PanelCell> cells;
  for (const auto &given : o.series) {
    const auto series = ogive::read_series(find_pvd(given));
    std::vector<std::size_t> numbers;
    for (const double time_us : o.times_us) numbers.push_back(frame_at(series, time_us));
    for (const std::size_t k : numbers) {
      const std::size_t n = cells.size();
      auto &cell = cells.emplace_back(ogive::PanelCell{ogive::read_frame(series, k, symmetry), ""});
      cell.label = o.label.empty() ? time_label(n, cell.frame) : o.label[n];
      if (o.label.empty() && o.series.size() > 1)
        cell.label.insert(4, fs::absolute(series.pvd).lexically_normal().parent_path().filename().string() + ", ");
    }
  }
  return cells;
}

} // namespace

void draw_panel(const Options &o) {
  const auto cells = read_cells(o);
  ogive::SectionPanel panel;
  const bool strain = o.colour == Colour::plastic_strain;
  panel.style.field = strain ? "plastic_strain" : "temperature_K";
  panel.bar_title = strain ? "plastic strain" : "temperature (K)";
  const Range range = o.range.value_or(strain ? Range{0, 1.5} : Range{300, 900});
  panel.style.smallest = range.low;
  panel.style.largest = range.high;
  panel.style.mesh_edges = o.mesh_edges;
  const View view = o.view_mm ? *o.view_mm : usual_view(cells);
  panel.low_mm = view.low_mm;
  panel.high_mm = view.high_mm;
  panel.radius_mm = view.radius_mm;
  panel.columns = o.columns.value_or(0);
  panel.title = o.title;
  ogive::render_panel(cells, o.out, panel);
}

} // namespace section
