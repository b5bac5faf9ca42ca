// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.hpp"
#include "figures.hpp"

#include "ogive/material/library.hpp"
#include "ogive/mesh/projectile_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace section {

namespace {

using Shape = ogive::ProjectileShape<double>;

constexpr double row_height_mm = 50;
constexpr std::array steel_grey{0.80, 0.82, 0.85};

/// "62 mm", four digits at most.
std::string in_mm(double metres, const char *before = "") {
  char text[48];
  std::snprintf(text, sizeof text, "%s%.4g mm", before, 1e3 * metres);
  return text;
}

/// The outline in mm, clockwise from the tail's upper corner; the tail is at x = 0, the tip at the right.
std::vector<Point> outline(const Shape &shape) {
  constexpr int pieces = 60;
  const double whole = length(shape), height = nose_height(shape);
  std::vector<Point> upper{{0, 1e3 * shape.diameter / 2}};
  for (int k = 0; k <= pieces; ++k) {
    const double behind_tip = height * (1 - double(k) / pieces);
    upper.push_back({1e3 * (whole - behind_tip), 1e3 * radius_at(shape, behind_tip)});
  }
  std::vector<Point> all = upper;
  std::for_each(upper.rbegin(), upper.rend(), [&](const Point &point) { all.push_back({point[0], -point[1]}); });
  return all;
}

/// The radius of an ogive, with an arrow to the middle of its arc.
void add_arc_radius(Drawing &drawing, const Shape &shape) {
  const double arc = ogive_radius(shape), before = 0.55 * nose_height(shape);
  const double x = 1e3 * (shape.shank_length + before), z = 1e3 * radius_at(shape, nose_height(shape) - before);
  const double sine = before / arc, cosine = std::sqrt(1 - sine * sine), reach = 100 * drawing.mm_per_pixel;
  const Point end{x + reach * sine, z + reach * cosine};
  add_line(drawing, {{x, z}, end}, 1.5);
  add_arrow_head(drawing, {x, z}, {-sine, -cosine});
  add_text(drawing, in_mm(arc, "R "), {end[0], end[1] + 0.7 * drawing.font_size * drawing.mm_per_pixel});
}

void add_projectile(Drawing &drawing, const Shape &shape, const std::string &letter) {
  const auto corners = outline(shape);
  auto closed = corners;
  closed.push_back(corners.front());
  const double shank = 1e3 * shape.shank_length, whole = 1e3 * length(shape), radius = 1e3 * shape.diameter / 2;
  add_area(drawing, corners, steel_grey);
  add_line(drawing, closed, 3);
  if (shank < whole) add_line(drawing, {{shank, radius}, {shank, -radius}}, 1.5);
  add_axis(drawing, {-4, 0}, {whole + 4, 0});

  char mass[64];
  std::snprintf(mass, sizeof mass, "%s, %.4g g", std::string(name(shape.nose)).c_str(),
                1e3 * ogive::mass(shape, ogive::library::arne_tool_steel<double>().density));
  add_text(drawing, letter + " " + mass, {0, radius + 5}, Beside::right);
  add_height(drawing, radius, 0, -7, in_mm(shape.diameter, "Ø "));
  add_length(drawing, 0, shank, -radius, -radius - 7, in_mm(shape.shank_length));
  if (shank == whole) return;
  add_length(drawing, shank, whole, -radius, -radius - 7, in_mm(nose_height(shape)));
  add_length(drawing, 0, whole, -radius - 7, -radius - 14, in_mm(length(shape)));
  add_height(drawing, 1e3 * shape.tip_diameter / 2, whole, whole + 7, in_mm(shape.tip_diameter, "Ø "));
  if (shape.nose == ogive::Nose::ogival) add_arc_radius(drawing, shape);
}

} // namespace

void draw_projectiles(const Options &o) {
  constexpr std::array noses{ogive::Nose::blunt, ogive::Nose::conical, ogive::Nose::ogival};
  constexpr int width = 1500;
  constexpr double left_mm = -28, right_mm = 126;
  constexpr double mm_per_pixel = (right_mm - left_mm) / width;
  const double title_mm = o.title.empty() ? 0 : 8;
  const double height_mm = row_height_mm * noses.size() + title_mm;
  const auto height = static_cast<int>(height_mm / mm_per_pixel);

  vtkNew<vtkRenderer> page;
  page->SetBackground(1, 1, 1);
  const auto window = ogive::picture_window(width, height, o.out);
  window->AddRenderer(page);
  for (std::size_t k = 0; k < noses.size(); ++k) {
    Drawing drawing;
    drawing.mm_per_pixel = mm_per_pixel;
    add_projectile(drawing, ogive::paper_projectile<double>(noses[k]), std::string("(") + char('a' + k) + ")");
    ogive::aim(drawing.scene, {(left_mm + right_mm) / 2, -4, row_height_mm / 2});
    const double top = 1 - (title_mm + row_height_mm * double(k)) / height_mm;
    drawing.scene->SetViewport(0, top - row_height_mm / height_mm, 1, top);
    window->AddRenderer(drawing.scene);
  }
  if (!o.title.empty()) {
    const int size = ogive::fitting_size(o.title, 34, 0.98 * width);
    page->AddActor2D(ogive::page_text(o.title, 0.5, 1 - title_mm / 2 / height_mm, size));
  }
  ogive::write_png(o.out, window);
}

} // namespace section
