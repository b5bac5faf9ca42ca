// SPDX-License-Identifier: BSD-3-Clause
#include "projectile.hpp"

#include "table.hpp"

namespace shot {

namespace {

bool is_pointed(const Options &o) { return o.nose == Nose::conical || o.nose == Nose::ogival; }

/// The paper's projectile with the nose and diameter of the options: all lengths grow with the diameter. SI units.
ogive::ProjectileShape<double> scaled_shape(const Options &o) {
  auto shape = ogive::paper_projectile<double>(o.nose);
  const double scale = o.diameter_mm / (shape.diameter * 1e3);
  for (double *size : {&shape.diameter, &shape.shank_length, &shape.nose_length, &shape.tip_diameter}) *size *= scale;
  return shape;
}

/// Without the last digits of a conversion.
double millimetres(double metres) { return std::round(metres * 1e9) / 1e6; }

} // namespace

double default_nose_length_mm(const Options &o) { return is_pointed(o) ? millimetres(scaled_shape(o).nose_length) : 0; }

double default_length_mm(const Options &o) {
  auto shape = scaled_shape(o);
  if (is_pointed(o)) shape.nose_length = o.nose_length_mm * 1e-3;
  return millimetres(ogive::length(shape));
}

ogive::ProjectileShape<double> shape_of(const Options &o) {
  auto shape = scaled_shape(o);
  if (is_pointed(o) && o.nose_length_mm != default_nose_length_mm(o)) shape.nose_length = o.nose_length_mm * 1e-3;
  shape.edge_radius = o.edge_radius_mm * 1e-3;
  if (o.length_mm != default_length_mm(o)) shape.shank_length = o.length_mm * 1e-3 - ogive::nose_height(shape);
  return shape;
}

bool is_of_the_tests(const Options &o) {
  return o.diameter_mm == Options{}.diameter_mm && o.nose_length_mm == default_nose_length_mm(o) &&
         o.length_mm == default_length_mm(o) && o.mass_g == 0 && o.obliquity_deg == 0;
}

void settle_projectile(Options &o, const options::Origins &origins) {
  const double radius_mm = o.diameter_mm / 2;
  if (o.calibre_radius_head != 0) {
    if (o.nose != Nose::ogival)
      refuse_value(origins, "calibre_radius_head", o.calibre_radius_head, "needs --nose ogival");
    if (origins.contains("nose_length_mm"))
      refuse_value(origins, "calibre_radius_head", o.calibre_radius_head,
                   "contradicts nose_length_mm: give one of them");
    if (!(o.calibre_radius_head > 0.5))
      refuse_value(origins, "calibre_radius_head", o.calibre_radius_head, "must exceed 0.5, a hemisphere");
    o.nose_length_mm = o.diameter_mm * std::sqrt(o.calibre_radius_head - 0.25);
    o.calibre_radius_head = 0;
  } else if (!origins.contains("nose_length_mm"))
    o.nose_length_mm = default_nose_length_mm(o);
  if (!is_pointed(o) && o.nose_length_mm != 0)
    refuse_value(origins, "nose_length_mm", o.nose_length_mm, "needs --nose conical or --nose ogival");
  if (o.nose == Nose::conical && !(o.nose_length_mm > 0))
    refuse_value(origins, "nose_length_mm", o.nose_length_mm, "must be positive");
  if (o.nose == Nose::ogival && !(o.nose_length_mm > radius_mm))
    refuse_value(origins, "nose_length_mm", o.nose_length_mm,
                 "must exceed the radius of an ogive, " + options::shortest(radius_mm) + " mm");

  if (o.edge_radius_mm != 0 && o.nose != Nose::blunt)
    refuse_value(origins, "edge_radius_mm", o.edge_radius_mm, "needs --nose blunt");
  if (o.edge_radius_mm > std::min(o.diameter_mm / 8, 2 * o.spacing_mm))
    refuse_value(origins, "edge_radius_mm", o.edge_radius_mm,
                 "must be at most an eighth of the diameter, " + options::shortest(o.diameter_mm / 8) +
                     " mm, and twice the particle distance, " + options::shortest(2 * o.spacing_mm) + " mm");

  if (!origins.contains("length_mm")) o.length_mm = default_length_mm(o);
  const double shank_mm = shape_of(o).shank_length * 1e3;
  if (!(shank_mm >= 0.1 * o.diameter_mm))
    refuse_value(origins, "length_mm", o.length_mm,
                 "must be " + options::shortest(std::ceil(10 * (o.length_mm - shank_mm + 0.1 * o.diameter_mm)) / 10) +
                     " mm or more: nose and a shank of a tenth of the diameter");
}

} // namespace shot
