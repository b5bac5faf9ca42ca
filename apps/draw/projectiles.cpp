// SPDX-License-Identifier: BSD-3-Clause
#include "projectiles.hpp"

#include "plot.hpp"

#include "ogive/io/text.hpp"
#include "ogive/material/library.hpp"
#include "ogive/mesh/projectile_shape.hpp"

#include <array>
#include <cmath>

namespace draw {

namespace {

using Shape = ogive::ProjectileShape<double>;

constexpr int page_width = 1500;
constexpr double left_mm = -28, right_mm = 126, row_height_mm = 50;

/// "62 mm", four digits at most.
std::string in_mm(double metres, const char *before = "") {
  return before + ogive::with_digits(1e3 * metres, 4) + " mm";
}

/// One projectile as commands for gnuplot; coordinates in mm, the tail at x = 0 and the axis at y = `axis`.
struct Drawing {
  std::string commands;
  double axis = 0;

  std::string at(double x, double z) const { return ogive::shortest(x) + "," + ogive::shortest(axis + z); }
  void add_line(double x0, double z0, double x1, double z1, const char *style = "nohead") {
    commands += "set arrow from " + at(x0, z0) + " to " + at(x1, z1) + " " + style + " linewidth 1.2; ";
  }
  void add_text(const std::string &text, double x, double z, const char *side = "center") {
    commands += "set label " + gnuplot_quoted(text) + " at " + at(x, z) + " " + side + " font ',21'; ";
  }
};

constexpr const char *head = "head filled size 1.6,16", *heads = "heads filled size 1.6,16";

/// The length between two points of a surface, measured at the height `z`, text above the line.
void add_length(Drawing &drawing, double from, double to, double surface_z, double z, const std::string &text) {
  for (const double x : {from, to}) drawing.add_line(x, surface_z - 0.8, x, z - 0.8);
  drawing.add_line(from, z, to, z, heads);
  drawing.add_text(text, (from + to) / 2, z + 2.4);
}

/// The height between z = -half and half, measured at `x`, for a body that ends at `surface_x`; text on the side away
/// from the body. Small heights have their arrows outside.
void add_height(Drawing &drawing, double half, double surface_x, double x, const std::string &text) {
  const double side = x > surface_x ? 1 : -1;
  for (const double z : {-half, half}) drawing.add_line(surface_x + 0.8 * side, z, x + 0.8 * side, z);
  if (half > 3)
    drawing.add_line(x, -half, x, half, heads);
  else
    for (const double sign : {-1.0, 1.0}) drawing.add_line(x, sign * (half + 4.5), x, sign * half, head);
  drawing.add_text(text, x + 1.8 * side, 0, side > 0 ? "left" : "right");
}

/// Outline, name, mass and dimensions.
std::string commands_of(const Shape &shape, double axis, char letter) {
  Drawing drawing{"", axis};
  const double height = nose_height(shape), shank = 1e3 * shape.shank_length, whole = 1e3 * length(shape),
               radius = 1e3 * shape.diameter / 2;
  constexpr int pieces = 60;
  std::string lower;
  drawing.commands = "set object polygon from " + drawing.at(0, radius);
  for (int k = 0; k <= pieces; ++k) {
    const double before = height * k / pieces, z = 1e3 * radius_at(shape, height - before), x = shank + 1e3 * before;
    drawing.commands += " to " + drawing.at(x, z);
    lower = " to " + drawing.at(x, -z) + lower;
  }
  drawing.commands += lower + " to " + drawing.at(0, -radius) + " to " + drawing.at(0, radius) +
                      " fillcolor rgb '#ccd1d9' fillstyle solid border lt -1 linewidth 2.4; ";
  if (shank < whole) drawing.add_line(shank, radius, shank, -radius);
  drawing.add_line(-4, 0, whole + 4, 0, "nohead dashtype (48,16,8,16)");

  const double grams = 1e3 * ogive::mass(shape, ogive::library::arne_tool_steel<double>().density);
  const std::string title =
      std::string("(") + letter + ") " + std::string(name(shape.nose)) + ", " + ogive::with_digits(grams, 4) + " g";
  drawing.add_text(title, 0, radius + 5, "left");
  add_height(drawing, radius, 0, -7, in_mm(shape.diameter, "Ø "));
  add_length(drawing, 0, shank, -radius, -radius - 7, in_mm(shape.shank_length));
  if (shank == whole) return drawing.commands;
  add_length(drawing, shank, whole, -radius, -radius - 7, in_mm(height));
  add_length(drawing, 0, whole, -radius - 7, -radius - 14, in_mm(length(shape)));
  add_height(drawing, 1e3 * shape.tip_diameter / 2, whole, whole + 7, in_mm(shape.tip_diameter, "Ø "));
  if (shape.nose == ogive::Nose::ogival) {
    // An arrow to the middle of the arc, along its radius.
    const double arc = ogive_radius(shape), before = 0.55 * height;
    const double x = shank + 1e3 * before, z = 1e3 * radius_at(shape, height - before);
    const double end_x = x + 10 * before / arc, end_z = z + 10 * std::sqrt(1 - before * before / (arc * arc));
    drawing.add_line(end_x, end_z, x, z, head);
    drawing.add_text(in_mm(arc, "R "), end_x, end_z + 2.4);
  }
  return drawing.commands;
}

} // namespace

void render_projectiles(const std::string &title, const std::filesystem::path &path) {
  constexpr std::array noses{ogive::Nose::blunt, ogive::Nose::conical, ogive::Nose::ogival};
  const double height_mm = row_height_mm * noses.size() + (title.empty() ? 0 : 8);
  std::string script = "unset border; unset tics; unset grid; unset key; set margins 0,0,0,0; set xrange [" +
                       ogive::shortest(left_mm) + ":" + ogive::shortest(right_mm) +
                       "]; set yrange [0:" + ogive::shortest(height_mm) + "]; ";
  for (std::size_t k = 0; k < noses.size(); ++k)
    script += commands_of(ogive::paper_projectile<double>(noses[k]), row_height_mm * (double(noses.size() - k) - 0.42),
                          char('a' + k));
  if (!title.empty()) script += "set label " + gnuplot_quoted(title) + " at graph 0.5,graph 0.975 center font ',25'; ";
  draw_with_gnuplot(script + "plot 1/0", path,
                    {page_width, static_cast<int>(height_mm * page_width / (right_mm - left_mm))});
}

} // namespace draw
