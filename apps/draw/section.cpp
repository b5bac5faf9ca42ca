// SPDX-License-Identifier: BSD-3-Clause
#include "section.hpp"

#include "ogive/core/error.hpp"
#include "options/text.hpp"

#include <algorithm>

namespace draw {

int panel_columns(std::size_t cells) {
  const auto count = static_cast<int>(cells), rows = (count + 3) / 4;
  return rows == 0 ? 1 : (count + rows - 1) / rows;
}

PanelLayout panel_layout(std::size_t cells, const SectionPanel &panel) {
  using ogive::require;
  require(cells > 0 && cells <= 100, "number of sections on the panel", cells, "must be 1 to 100");
  require(std::isfinite(panel.low_mm) && std::isfinite(panel.high_mm) && panel.high_mm - panel.low_mm >= 1,
          "highest z of the panel's sections (mm)", panel.high_mm, "must be 1 mm above the lowest or more");
  require(std::isfinite(panel.radius_mm) && panel.radius_mm >= 1, "farthest x of the panel's sections (mm)",
          panel.radius_mm, "must be 1 mm or more");
  require(std::isfinite(panel.scale_bar_mm) && panel.scale_bar_mm > 0, "scale bar of the panel (mm)",
          panel.scale_bar_mm, "must be positive");
  require(panel.columns >= 0, "columns of the panel", panel.columns, "must not be negative");
  const int wanted = panel.columns > 0 ? panel.columns : panel_columns(cells);
  const int columns = std::min(wanted, static_cast<int>(cells));
  const int rows = (static_cast<int>(cells) + columns - 1) / columns;

  PanelLayout layout;
  layout.font_size = panel.font_size > 0 ? panel.font_size : std::max(8, panel.width / 55);
  const double font = layout.font_size, gap = 0.5 * font, label = 1.8 * font, side = 7.4 * font;
  const double title = panel.title.empty() ? gap : 2.2 * font;
  const double wide = 2 * panel.radius_mm, tall = panel.high_mm - panel.low_mm;
  layout.pixels_per_mm = std::min({(panel.width - side - (columns + 1) * gap) / (columns * wide),
                                   (panel.height - title - gap - rows * (label + gap)) / (rows * tall)});
  const double cell_width = std::floor(layout.pixels_per_mm * wide);
  const double cell_height = std::floor(layout.pixels_per_mm * tall), step = cell_height + label + gap;
  // Colours and scale bar need some height beside a single row of flat sections too.
  const double right = columns * (cell_width + gap) + gap, top = std::max(gap + rows * step, 11 * font);
  require(std::min(cell_width, cell_height) >= 16 && top + title <= panel.height, "size of the panel",
          std::to_string(panel.width) + " x " + std::to_string(panel.height),
          "has no room for " + std::to_string(rows) + " x " + std::to_string(columns) + " sections");
  layout.width = static_cast<int>(std::ceil(right + side));
  layout.height = static_cast<int>(std::ceil(top + title));
  layout.title = {0, top, double(layout.width), title};
  for (std::size_t k = 0; k < cells; ++k) {
    const auto row = static_cast<int>(k) / columns, column = static_cast<int>(k) % columns;
    const double x = gap + column * (cell_width + gap), y = top - row * step - cell_height;
    layout.cells.push_back({x, y, cell_width, cell_height});
    layout.labels.push_back({x, y - label, cell_width, label});
  }
  // Colours as tall as one usual section: more would show no more.
  const double scale = 2 * font, bar = std::min(top - scale - 2 * gap, 18 * font);
  layout.bar = {right, top - bar, side, bar};
  layout.scale = {right, std::max(gap, layout.bar.y - 3 * gap - scale), side, scale};
  return layout;
}

void render_panel(const std::vector<PanelCell> &cells, const std::filesystem::path &path, const SectionPanel &panel) {
  const PanelLayout layout = panel_layout(cells.size(), panel);
  const int font_size = layout.font_size;
  const double font = font_size;
  Page page = white_page(layout.width, layout.height);

  int label_size = font_size;
  for (const PanelCell &cell : cells)
    label_size = std::min(label_size, fitting_size(cell.label, font_size, layout.cells.front().width));
  for (std::size_t k = 0; k < cells.size(); ++k) add_text(page, cells[k].label, layout.labels[k], label_size);
  add_text(page, panel.title, narrowed(layout.title, 0.98), font_size + font_size / 8);

  const auto colours = section_colours(panel.style);
  const Box &bar = layout.bar, &scale = layout.scale;
  add_text(page, panel.bar_title, narrowed({bar.x, bar.y + bar.height - 1.4 * font, bar.width, 1.4 * font}, 0.9),
           font_size);
  add_colour_bar(page, colours, font_size, {bar.x + 1.6 * font, bar.y, 5.3 * font, bar.height - 2 * font});
  double scale_mm = panel.scale_bar_mm;
  while (scale_mm * layout.pixels_per_mm > scale.width - font) scale_mm /= 2;
  const double length = scale_mm * layout.pixels_per_mm, thickness = std::max(2.0, font / 6);
  add_bar(page, {scale.x + (scale.width - length) / 2, scale.y + thickness / 2, length, thickness});
  add_text(page, options::printed("%g mm", scale_mm), {scale.x, scale.y + 0.6 * font, scale.width, 1.4 * font},
           font_size);

  SectionView view{0, (panel.low_mm + panel.high_mm) / 2, layout.cells.front().height / layout.pixels_per_mm / 2};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    view.from = cells[k].from;
    add_scene(page, section_scene(cells[k].frame, panel.style, colours, view), layout.cells[k]);
  }
  write_png(page, path, 52, panel.compression);
}

void render_section(const PanelCell &cell, const std::string &title, double low_mm, const std::filesystem::path &path,
                    Rear rear) {
  SectionPanel panel{.style = {}, .title = title, .low_mm = std::min(low_mm, -38.0), .height = 1200};
  std::vector<PanelCell> cells{cell};
  if (rear == Rear::shown) cells.push_back({cell.frame, "from behind, without the projectile", Seen::behind});
  // As wide as the page allows.
  panel.radius_mm = (rear == Rear::shown ? 0.31 : 0.62) * (panel.high_mm - panel.low_mm);
  render_panel(cells, path, panel);
}

} // namespace draw
