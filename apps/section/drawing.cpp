// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.hpp"

#include <cmath>

namespace section {

namespace {

vtkSmartPointer<vtkPolyData> poly(const std::vector<Point> &points, bool area) {
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> cells;
  for (const auto &[x, z] : points) corners->InsertNextPoint(x, area ? 1.0 : 0.0, z);
  cells->InsertNextCell(static_cast<int>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) cells->InsertCellPoint(static_cast<vtkIdType>(k));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(corners);
  if (area)
    data->SetPolys(cells);
  else
    data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkActor> flat_actor(const std::vector<Point> &points, bool area, const std::array<double, 3> &colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(poly(points, area));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  return actor;
}

} // namespace

void add_area(Drawing &drawing, const std::vector<Point> &corners, const std::array<double, 3> &colour) {
  drawing.scene->AddActor(flat_actor(corners, true, colour));
}

void add_line(Drawing &drawing, const std::vector<Point> &points, double pixels) {
  const auto actor = flat_actor(points, false, ogive::page_ink);
  actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
  drawing.scene->AddActor(actor);
}

void add_axis(Drawing &drawing, Point from, Point to) {
  const double dash = 24 * drawing.mm_per_pixel, dot = 4 * drawing.mm_per_pixel, gap = 8 * drawing.mm_per_pixel;
  for (double x = from[0]; x < to[0];) {
    add_line(drawing, {{x, from[1]}, {std::min(x + dash, to[0]), from[1]}}, 1.5);
    x += dash + gap;
    if (x + dot < to[0]) add_line(drawing, {{x, from[1]}, {x + dot, from[1]}}, 1.5);
    x += dot + gap;
  }
}

void add_text(Drawing &drawing, const std::string &text, Point at, Beside beside) {
  const auto actor = ogive::page_text(text, 0, 0, drawing.font_size);
  auto *position = actor->GetPositionCoordinate();
  position->SetCoordinateSystemToWorld();
  position->SetValue(at[0], 0, at[1]);
  // Text to the left of its point ends there.
  if (beside == Beside::left) actor->GetTextProperty()->SetJustificationToRight();
  if (beside == Beside::right) actor->GetTextProperty()->SetJustificationToLeft();
  drawing.scene->AddActor2D(actor);
}

void add_arrow_head(Drawing &drawing, Point tip, Point direction) {
  const double length = 16 * drawing.mm_per_pixel, half_width = 4.5 * drawing.mm_per_pixel;
  const double bx = tip[0] - length * direction[0], bz = tip[1] - length * direction[1];
  add_area(drawing,
           {tip,
            {bx - half_width * direction[1], bz + half_width * direction[0]},
            {bx + half_width * direction[1], bz - half_width * direction[0]}},
           ogive::page_ink);
}

void add_length(Drawing &drawing, double from, double to, double surface_z, double z, const std::string &text) {
  const double beyond = (z > surface_z ? 8 : -8) * drawing.mm_per_pixel;
  for (const double x : {from, to}) add_line(drawing, {{x, surface_z + beyond}, {x, z + beyond}}, 1.5);
  add_line(drawing, {{from, z}, {to, z}}, 1.5);
  add_arrow_head(drawing, {from, z}, {-1, 0});
  add_arrow_head(drawing, {to, z}, {1, 0});
  add_text(drawing, text, {(from + to) / 2, z + 0.7 * drawing.font_size * drawing.mm_per_pixel});
}

void add_height(Drawing &drawing, double half, double surface_x, double x, const std::string &text) {
  const double side = x > surface_x ? 1 : -1, pixel = drawing.mm_per_pixel;
  const bool outside = 2 * half < 60 * pixel;
  for (const double z : {-half, half})
    add_line(drawing, {{surface_x + side * 8 * pixel, z}, {x + side * 8 * pixel, z}}, 1.5);
  const double reach = outside ? half + 44 * pixel : half;
  add_line(drawing, {{x, -reach}, {x, reach}}, 1.5);
  add_arrow_head(drawing, {x, half}, {0, outside ? -1.0 : 1.0});
  add_arrow_head(drawing, {x, -half}, {0, outside ? 1.0 : -1.0});
  add_text(drawing, text, {x + side * 18 * pixel, 0}, side > 0 ? Beside::right : Beside::left);
}

} // namespace section
