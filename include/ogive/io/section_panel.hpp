// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/section_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

/// \file
/// Several sections on one page, in rows and columns, all at the same scale and with the same colours: the times of one
/// shot, or several shots beside each other.

namespace ogive {

/// One section of a panel.
struct PanelCell {
  Frame frame;       ///< what is cut
  std::string label; ///< one line below the section
};

/// What a panel shows of each section, and how large.
struct SectionPanel {
  SectionStyle style{.mesh_edges = false, .particle_ambient = 0.7}; ///< colours and what is grey
  std::string title{};                                              ///< one line above the panel; none if empty
  std::string bar_title{};                                          ///< above the colours; the field's name if empty
  double low_mm = -40;      ///< lowest z that is seen; the plate's front face is z = 0
  double high_mm = 22;      ///< highest z that is seen
  double radius_mm = 28;    ///< farthest x that is seen on either side
  double scale_bar_mm = 10; ///< length of the scale bar
  int columns = 0;          ///< 0: up to four, such that the rows are even
  int width = 1600;         ///< pixels at most
  int height = 1800;        ///< pixels at most
};

/// Where things stand on a panel. Pixels from the lower left corner.
struct PanelLayout {
  int width = 0, height = 0;   ///< of the page
  int font_size = 0;           ///< of all text
  double pixels_per_mm = 0;    ///< scale of the sections
  std::vector<PageBox> cells;  ///< the sections
  std::vector<PageBox> labels; ///< below them
  PageBox title;               ///< above the sections
  PageBox bar;                 ///< the colours, their values and their title
  PageBox scale;               ///< the scale bar and its length
};

/// Columns for `cells` sections where none are asked for.
inline int panel_columns(std::size_t cells) {
  const auto count = static_cast<int>(cells), rows = (count + 3) / 4;
  return rows == 0 ? 1 : (count + rows - 1) / rows;
}

/// Lays `cells` sections out, row by row from the top. Throws SetupError for a panel without cells, and for sizes that
/// leave no room for them.
inline PanelLayout panel_layout(std::size_t cells, const SectionPanel &panel) {
  require(cells > 0 && cells <= 100, "number of sections on the panel", cells, "must be 1 to 100");
  check_picture_size(panel.width, panel.height);
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
  layout.font_size = std::max(8, panel.width / 55);
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
  // Colours as tall as a section of usual shape; more would not tell more.
  const double scale = 2 * font, bar = std::min(top - scale - 2 * gap, 18 * font);
  layout.bar = {right, top - bar, side, bar};
  layout.scale = {right, std::max(gap, layout.bar.y - 3 * gap - scale), side, scale};
  return layout;
}

/// Draws sections as one PNG, each as render_section does it, with the symmetry that its frame tells. Sections, scale
/// and colours are the same for all. Throws SetupError for a panel that cannot be laid out or a part that lacks the
/// field asked for, WriteError if there is no display to draw on (see display_available) or the file cannot be written.
inline void render_panel(const std::vector<PanelCell> &cells, const std::filesystem::path &path,
                         const SectionPanel &panel = {}) {
  const PanelLayout layout = panel_layout(cells.size(), panel);
  check_range(panel.style);
  const auto colours = section_colours(panel.style);
  const auto on_page = [&](const PageBox &box) {
    return PageBox{box.x / layout.width, box.y / layout.height, box.width / layout.width, box.height / layout.height};
  };
  vtkNew<vtkRenderer> page;
  page->SetBackground(1, 1, 1);
  const auto add_text = [&](const std::string &text, const PageBox &box, int size) {
    const PageBox at = on_page(box);
    page->AddActor2D(page_text(text, at.x + at.width / 2, at.y + at.height / 2, size));
  };

  int label_size = layout.font_size;
  for (const PanelCell &cell : cells)
    label_size = std::min(label_size, fitting_size(cell.label, layout.font_size, layout.cells.front().width));
  for (std::size_t k = 0; k < cells.size(); ++k) add_text(cells[k].label, layout.labels[k], label_size);
  const int title_size = layout.font_size + layout.font_size / 8;
  add_text(panel.title, layout.title, fitting_size(panel.title, title_size, 0.98 * layout.title.width));

  const std::string bar_title = panel.bar_title.empty() ? panel.style.field : panel.bar_title;
  const double font = layout.font_size;
  add_text(bar_title, {layout.bar.x, layout.bar.y + layout.bar.height - 1.4 * font, layout.bar.width, 1.4 * font},
           fitting_size(bar_title, layout.font_size, 0.9 * layout.bar.width));
  page->AddActor2D(
      colour_bar(colours, "", layout.font_size,
                 on_page({layout.bar.x + 1.6 * font, layout.bar.y, 5.3 * font, layout.bar.height - 2 * font})));
  double scale_mm = panel.scale_bar_mm;
  while (scale_mm * layout.pixels_per_mm > layout.scale.width - font) scale_mm /= 2;
  const double length = scale_mm * layout.pixels_per_mm, thickness = std::max(2.0, font / 6);
  const PageBox bar =
      on_page({layout.scale.x + (layout.scale.width - length) / 2, layout.scale.y + thickness / 2, length, thickness});
  page->AddActor2D(page_bar(bar.x, bar.y, bar.width, bar.height));
  char text[32];
  std::snprintf(text, sizeof text, "%g mm", scale_mm);
  add_text(text, {layout.scale.x, layout.scale.y + 0.6 * font, layout.scale.width, 1.4 * font}, layout.font_size);

  const SectionView view{0, (panel.low_mm + panel.high_mm) / 2, layout.cells.front().height / layout.pixels_per_mm / 2};
  std::vector<vtkSmartPointer<vtkRenderer>> scenes;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const PageBox box = on_page(layout.cells[k]);
    scenes.push_back(section_scene(cells[k].frame, cells[k].frame.symmetry, panel.style, colours, view));
    scenes.back()->SetViewport(box.x, box.y, box.x + box.width, box.y + box.height);
  }
  const auto window = picture_window(layout.width, layout.height, path);
  window->AddRenderer(page);
  for (const auto &scene : scenes) window->AddRenderer(scene);
  write_png(path, window, 52);
}

} // namespace ogive
