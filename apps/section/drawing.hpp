// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/section_page.hpp"
#include "ogive/io/section_scene.hpp"

#include <array>
#include <string>
#include <vector>

/// \file
/// A drawing to scale: outlines, lines and dimensions in the plane of x and z, in mm.

namespace section {

/// A point (x, z), mm.
using Point = std::array<double, 2>;

/// Where text stands beside its point.
enum class Beside { centre, left, right };

struct Drawing {
  vtkSmartPointer<vtkRenderer> scene = ogive::white_scene();
  double mm_per_pixel = 0.1;
  int font_size = 30; ///< pixels
};

/// A filled polygon, which must be convex, without outline. Colour 0 to 1.
void add_area(Drawing &drawing, const std::vector<Point> &corners, const std::array<double, 3> &colour);

/// A line through points, `pixels` wide.
void add_line(Drawing &drawing, const std::vector<Point> &points, double pixels);

/// An axis: dashes and dots between two points on a horizontal line.
void add_axis(Drawing &drawing, Point from, Point to);

void add_text(Drawing &drawing, const std::string &text, Point at, Beside beside = Beside::centre);

/// An arrow's head with its tip at `tip`, pointing along `direction` (of length 1).
void add_arrow_head(Drawing &drawing, Point tip, Point direction);

/// The length between two points on a horizontal line, measured at the height `z`, text above the line.
void add_length(Drawing &drawing, double from, double to, double surface_z, double z, const std::string &text);

/// The height between z = -half and half, measured at `x`, for a body that ends at `surface_x`; text on the side away
/// from the body. Small heights have their arrows outside.
void add_height(Drawing &drawing, double half, double surface_x, double x, const std::string &text);

} // namespace section
