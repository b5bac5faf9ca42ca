// SPDX-License-Identifier: BSD-3-Clause
#include "sections.hpp"

#include "../results.hpp"
#include "draw/film.hpp"
#include "options/text.hpp"

#include "ogive/io/read_frame.hpp"

#include <cmath>

namespace commands::drawing {

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

/// The letter of a section, "(a) ".
std::string letter(std::size_t number) { return options::printed("(%c) ", static_cast<int>('a' + number % 26)); }

std::vector<draw::PanelCell> read_cells(const Options &o) {
  std::vector<draw::PanelCell> cells;
  for (const auto &given : o.series) {
    const auto series = ogive::read_series(find_pvd(given, "--series"));
    const auto motion = motion_of(series.pvd.parent_path());
    std::vector<std::size_t> numbers;
    for (const double time_us : o.times_us) numbers.push_back(frame_at(series, time_us));
    for (const std::size_t k : numbers) {
      const std::size_t n = cells.size();
      auto &cell = cells.emplace_back(draw::PanelCell{ogive::read_frame(series, k, symmetry_of(o.extent)), "", o.from});
      const std::string name = o.series.size() > 1 ? folder_name(series.pvd) + ", " : "";
      cell.label = o.label.empty() ? letter(n) + name + draw::time_text(cell.frame.time, motion) : o.label[n];
    }
  }
  return cells;
}

/// Takes what the options hold about a panel, except the visible box.
void choose(draw::SectionPanel &panel, const Options &o) {
  if (o.pixels) {
    const double scale = double(*o.pixels) / panel.width;
    panel.width = *o.pixels;
    panel.height = static_cast<int>(std::lround(scale * panel.height));
    panel.font_size = static_cast<int>(std::lround(scale * panel.font_size));
  }
  const bool strain = o.colour == Colour::plastic_strain;
  const auto range = o.range.value_or(strain ? std::array{0.0, 1.5} : std::array{300.0, 900.0});
  panel.title = o.title;
  panel.bar_title = strain ? "plastic strain" : "temperature (K)";
  panel.columns = o.columns.value_or(0);
  panel.style.field = strain ? "plastic_strain" : "temperature_K";
  panel.style.smallest = range[0];
  panel.style.largest = range[1];
  panel.style.mesh_edges = o.mesh_edges;
}

/// The visible box: --view-mm, else the default of a section, and of the rear view a square.
draw::SeenBox first_box(const Options &o) {
  draw::SeenBox box;
  if (o.view_mm) return {(*o.view_mm)[0], (*o.view_mm)[1], (*o.view_mm)[2]};
  if (o.from == draw::Seen::behind) return {-box.radius_mm, box.radius_mm, box.radius_mm};
  return box;
}

void see(draw::SectionPanel &panel, const draw::SeenBox &box) {
  panel.low_mm = box.low_mm;
  panel.high_mm = box.high_mm;
  panel.radius_mm = box.radius_mm;
}

/// Whether the box follows from the frames.
bool fits(const Options &o) { return !o.view_mm && o.from != draw::Seen::behind; }

} // namespace

void draw_sections(const Options &o) {
  const auto cells = read_cells(o);
  draw::SeenBox box = first_box(o);
  if (fits(o))
    for (const auto &cell : cells) box = draw::extended(box, cell.frame);
  draw::SectionPanel panel;
  choose(panel, o);
  see(panel, box);
  draw::render_panel(cells, o.out, panel);
}

void draw_film(const Options &o) {
  const auto pvd = find_pvd(o.series.front(), "--series");
  draw::Film film;
  choose(film.panel, o);
  if (o.title.empty()) film.panel.title = case_title(pvd.parent_path());
  film.motion = motion_of(pvd.parent_path());
  see(film.panel, first_box(o));
  film.fits = fits(o);
  film.from = o.from;
  film.symmetry = symmetry_of(o.extent);
  film.most_frames = o.frames;
  film.frames_per_second = o.frames_per_second;
  draw::render_film(ogive::read_series(pvd), film, o.animate);
}

} // namespace commands::drawing
