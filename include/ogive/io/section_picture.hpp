// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/section_page.hpp"
#include "ogive/io/section_scene.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

namespace ogive {

/// What a picture of the section shows, and how large.
struct SectionPicture {
  SectionStyle style{};       ///< colours and what is grey
  std::string title{};        ///< one line above the picture: case, time, velocity
  std::string bar_title{};    ///< beside the colours; the field's name if empty
  double half_height_mm = 30; ///< half of what is seen from bottom to top
  double centre_z_mm = -8;    ///< height in the middle of the picture; the plate's front face is z = 0
  double scale_bar_mm = 10;   ///< length of the scale bar
  int width = 1600;           ///< pixels
  int height = 1200;          ///< pixels
};

/// Throws SetupError unless a picture's sides are 64 to 16384 pixels.
inline void check_picture_size(int width, int height) {
  require(width >= 64 && height >= 64 && width <= 16384 && height <= 16384, "size of the picture",
          std::to_string(width) + " x " + std::to_string(height), "must be 64 to 16384 pixels each way");
}

/// Throws SetupError unless the range of a style's colours is one.
inline void check_range(const SectionStyle &style) {
  require(style.largest > style.smallest, "largest value of the colours", style.largest, "must be above the smallest");
}

/// Draws the section y = 0 of a frame as a PNG: the half behind the plane, seen along y with z upwards, mirrored at
/// x = 0 if that is a symmetry plane. The computed part of a model lies where the coordinates of its symmetry planes
/// are positive. Throws SetupError if a part lacks the field asked for, WriteError if there is no display to draw on
/// (see display_available) or the file cannot be written.
inline void render_section(const Frame &frame, SymmetryPlanes planes, const std::filesystem::path &path,
                           const SectionPicture &picture = {}) {
  check_picture_size(picture.width, picture.height);
  require(picture.half_height_mm > 0, "half height of the picture (mm)", picture.half_height_mm, "must be positive");
  check_range(picture.style);
  const auto colours = section_colours(picture.style);
  const double scene_width = 0.87, scene_height = 0.93;
  const double page_width_mm = 2 * picture.half_height_mm / scene_height * picture.width / picture.height;
  const int font_size = std::max(8, picture.height / 36);

  const auto scene = section_scene(frame, planes, picture.style, colours,
                                   {.centre_z_mm = picture.centre_z_mm, .half_height_mm = picture.half_height_mm});
  scene->SetViewport(0, 0, scene_width, scene_height);

  vtkNew<vtkRenderer> page;
  page->SetBackground(1, 1, 1);
  page->AddActor2D(page_text(picture.title, 0.5, 0.965, font_size + 4));
  page->AddActor2D(colour_bar(colours, picture.bar_title.empty() ? picture.style.field : picture.bar_title, font_size,
                              {0.885, 0.16, 0.10, 0.68}));

  vtkNew<vtkRenderer> scale;
  scale->SetLayer(1);
  const double bar_length = picture.scale_bar_mm / page_width_mm;
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", picture.scale_bar_mm);
  scale->AddActor2D(page_bar(0.03, 0.04, bar_length, 0.006));
  scale->AddActor2D(page_text(label, 0.03 + bar_length / 2, 0.07, font_size));

  const auto window = picture_window(picture.width, picture.height, path);
  window->SetNumberOfLayers(2);
  window->AddRenderer(page);
  window->AddRenderer(scene);
  window->AddRenderer(scale);
  write_png(path, window);
}

} // namespace ogive
