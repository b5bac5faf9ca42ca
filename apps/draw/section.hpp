// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "page.hpp"
#include "scene.hpp"

/// \file
/// Sections through plate and projectile as PNG: one with its colours beside it, or several on one page, all at the
/// same scale and with the same colours.

namespace draw {

/// One section of a panel, or another view.
struct PanelCell {
  ogive::Frame frame; ///< that is cut
  std::string label;  ///< one line below the section
  Seen from = Seen::section;
};

/// Contents, visible box (mm) and size (pixels) of a panel.
struct SectionPanel {
  SectionStyle style{.mesh_edges = false, .particle_ambient = 0.7}; ///< colours and what is grey
  std::string title{};                                              ///< one line above the panel; none if empty
  std::string bar_title = "plastic strain";                         ///< above the colours
  double low_mm = -40;      ///< lowest z that is seen; the plate's front face is z = 0
  double high_mm = 22;      ///< highest z that is seen
  double radius_mm = 28;    ///< farthest x that is seen on either side
  double scale_bar_mm = 10; ///< length of the scale bar
  int columns = 0;          ///< 0: up to four, such that the rows are even
  int width = 1600;         ///< pixels at most
  int height = 1800;        ///< pixels at most
  int font_size = 0;        ///< pixels; 0: by the width
  int compression = 9;      ///< of the PNG, 1 to 9
};

/// The boxes of a panel's sections, texts and scales, in pixels.
struct PanelLayout {
  int width = 0, height = 0; ///< of the page, pixels
  int font_size = 0;         ///< of all text
  double pixels_per_mm = 0;  ///< scale of the sections
  std::vector<Box> cells;    ///< the sections
  std::vector<Box> labels;   ///< below them
  Box title;                 ///< above the sections
  Box bar;                   ///< the colours, their values and their title
  Box scale;                 ///< the scale bar and its length
};

/// Columns for `cells` sections where the panel gives no number.
int panel_columns(std::size_t cells);

/// Lays `cells` sections out, row by row from the top. Throws ogive::SetupError for a panel without cells, and for
/// sizes that leave no room for them.
PanelLayout panel_layout(std::size_t cells, const SectionPanel &panel);

/// Draws sections y = 0 as one PNG: the half behind the plane, seen along y with z upwards, mirrored at x = 0 if that
/// is a symmetry plane of the frame. Throws ogive::SetupError for a panel that cannot be laid out or a part that lacks
/// the field of the style, ogive::WriteError as write_png() does.
void render_panel(const std::vector<PanelCell> &cells, const std::filesystem::path &path,
                  const SectionPanel &panel = {});

/// Choice of a second view, of the plate from behind.
enum class Rear { left_out, shown };

/// Draws the section of a run's last frame by plastic strain, with the mesh, from 22 mm in front of the plate down to
/// `low_mm` at least, and beside it the plate from behind if that is shown. Throws as render_panel().
void render_section(const PanelCell &cell, const std::string &title, double low_mm, const std::filesystem::path &path,
                    Rear rear = Rear::left_out);

} // namespace draw
