// SPDX-License-Identifier: BSD-3-Clause
#include "projectile.hpp"

#include "materials/library.hpp"
#include "ogive/io/read_profile.hpp"
#include "options/toml_file.hpp"
#include "parts.hpp"
#include "table.hpp"

#include "ogive/mesh/nested_mesh.hpp"

namespace shot {

namespace {

bool is_pointed(const Options &o) {
  return o.nose == Nose::conical || o.nose == Nose::ogival || o.nose == Nose::chisel;
}

/// A profile of z and r in turn (mm), m.
ogive::Profile<double> profile_of(const std::vector<double> &z_and_r_mm) {
  ogive::Profile<double> profile;
  for (std::size_t k = 0; k + 1 < z_and_r_mm.size(); k += 2)
    profile.push_back({z_and_r_mm[k] * 1e-3, z_and_r_mm[k + 1] * 1e-3});
  return profile;
}

/// A shape with the surfaces within it.
ogive::ProjectileShape<double> with_inner(ogive::ProjectileShape<double> shape, const Options &o) {
  if (o.bore_radius_mm > 0) {
    shape.inner = {ogive::bore(o.bore_radius_mm * 1e-3, o.bore_depth_mm * 1e-3, ogive::length(shape))};
    shape.is_hollow = true;
  }
  for (const auto *surface : {&o.core_profile_mm, &o.filler_profile_mm})
    if (!surface->empty()) shape.inner.push_back(profile_of(*surface));
  return shape;
}

/// The paper's projectile with the nose and diameter of the options: all lengths grow with the diameter. SI units.
ogive::ProjectileShape<double> scaled_shape(const Options &o) {
  auto shape = ogive::default_projectile<double>(o.nose);
  const double scale = o.diameter_mm / (shape.diameter * 1e3);
  for (double *size : {&shape.diameter, &shape.shank_length, &shape.nose_length, &shape.tip_diameter}) *size *= scale;
  return shape;
}

/// Without the last digits of a conversion.
double millimetres(double metres) { return std::round(metres * 1e9) / 1e6; }

} // namespace

double default_nose_length_mm(const Options &o) { return is_pointed(o) ? millimetres(scaled_shape(o).nose_length) : 0; }

double default_tip_diameter_mm(const Options &o) {
  return is_pointed(o) ? millimetres(scaled_shape(o).tip_diameter) : 0;
}

double default_length_mm(const Options &o) {
  if (o.nose == Nose::profile || o.nose == Nose::mesh) return millimetres(ogive::length(shape_of(o)));
  auto shape = scaled_shape(o);
  if (is_pointed(o)) shape.nose_length = o.nose_length_mm * 1e-3;
  if (is_pointed(o) && o.tip_diameter_mm != default_tip_diameter_mm(o)) shape.tip_diameter = o.tip_diameter_mm * 1e-3;
  return millimetres(ogive::length(shape));
}

ogive::ProjectileShape<double> shape_of(const Options &o) {
  if (o.nose == Nose::mesh)
    return o.own_mesh.read ? o.own_mesh.read->projectile.shape : ogive::ProjectileShape<double>{};
  if (o.nose == Nose::profile) return with_inner(ogive::projectile_of(profile_of(o.profile_mm)), o);
  auto shape = scaled_shape(o);
  if (is_pointed(o) && o.nose_length_mm != default_nose_length_mm(o)) shape.nose_length = o.nose_length_mm * 1e-3;
  if (is_pointed(o) && o.tip_diameter_mm != default_tip_diameter_mm(o)) shape.tip_diameter = o.tip_diameter_mm * 1e-3;
  shape.edge_radius = o.edge_radius_mm * 1e-3;
  shape.tail_length = o.tail_length_mm * 1e-3;
  shape.tail_diameter = o.tail_diameter_mm * 1e-3;
  if (o.length_mm != default_length_mm(o)) shape.shank_length = o.length_mm * 1e-3 - ogive::nose_height(shape);
  return with_inner(std::move(shape), o);
}

bool is_of_the_tests(const Options &o) {
  return o.projectile.empty() && o.projectile_metal == Options{}.projectile_metal && o.tail_length_mm == 0 &&
         o.part_metals.empty() && o.nose != Nose::mesh && parts_of(o).size() == 1 && o.bore_radius_mm == 0 &&
         o.tip_diameter_mm == default_tip_diameter_mm(o) && o.diameter_mm == Options{}.diameter_mm &&
         o.nose_length_mm == default_nose_length_mm(o) && o.length_mm == default_length_mm(o) && o.mass_g == 0 &&
         o.obliquity_deg == 0 && o.pitch_deg == 0 && o.yaw_deg == 0;
}

std::string projectile_label(const Options &o) {
  if (!o.projectile.empty()) return materials::label_of(o.projectile);
  if (o.nose == Nose::profile && !o.profile.empty()) return std::filesystem::path(o.profile).stem().string();
  if (o.nose == Nose::mesh && !o.projectile_mesh.empty())
    return std::filesystem::path(o.projectile_mesh).stem().string();
  return name_of(o.nose);
}

bool is_blunt(const Options &o) {
  if (o.nose == Nose::mesh) return !ogive::is_sharp(shape_of(o));
  return o.nose == Nose::blunt || o.nose == Nose::chisel;
}

void read_profile(Options &o, const options::Origins &origins, const std::filesystem::path &folder) {
  const std::filesystem::path file = folder / o.profile;
  const std::string text = options::text_of_file(file, options::origin_of(origins, "profile"), "CSV");
  for (const auto &point : ogive::read_profile(text, file.string()))
    for (const double value : {point.z, point.radius}) o.profile_mm.push_back(millimetres(value));
}

namespace {

/// Takes sizes from the profile or the mesh, which gives all of them. Throws SetupError.
void take_sizes(Options &o, const options::Origins &origins, const ogive::ProjectileShape<double> &shape,
                const std::string &thing, const std::string &origin) {
  const auto take = [&](const char *key, double &value, double own) {
    if (origins.contains(key) && std::abs(value - own) > 1e-6 * own)
      refuse_value(origins, key, value, "contradicts " + thing + ", which gives " + options::shortest(own) + " mm");
    const options::Limits limits = options::find(table_of(o), key)->limits;
    if (!options::within(limits, own))
      options::refuse(origin, options::shortest(own) + " mm as its " + key, "must lie between " + text_of(limits));
    value = own;
  };
  take("diameter_mm", o.diameter_mm, millimetres(shape.diameter));
  take("length_mm", o.length_mm, millimetres(ogive::length(shape)));
  const auto needs_no = [&](const char *key, double value) {
    if (value != 0) refuse_value(origins, key, value, "contradicts " + thing + ": give one of them");
  };
  needs_no("nose_length_mm", o.nose_length_mm), needs_no("tip_diameter_mm", o.tip_diameter_mm);
  needs_no("calibre_radius_head", o.calibre_radius_head), needs_no("edge_radius_mm", o.edge_radius_mm);
  needs_no("tail_length_mm", o.tail_length_mm), needs_no("tail_diameter_mm", o.tail_diameter_mm);
  if (thing != "projectile_mesh") return;
  needs_no("bore_radius_mm", o.bore_radius_mm);
  needs_no("filler_profile_mm", double(o.filler_profile_mm.size()));
  needs_no("core_profile_mm", double(o.core_profile_mm.size()));
}

/// Takes nose and sizes from the profile. Throws SetupError.
void settle_profile(Options &o, const options::Origins &origins) {
  if (o.profile_mm.empty()) {
    if (o.nose == Nose::profile) refuse_value(origins, "nose", o.nose, "needs --profile FILE.csv");
    return;
  }
  if (o.profile_mm.size() % 2 != 0)
    refuse_value(origins, "profile_mm", o.profile_mm.size(), "must be an even number of values, z and r in turn");
  ogive::ProjectileShape<double> shape;
  try {
    shape = shape_of(o);
  } catch (const ogive::SetupError &error) {
    throw ogive::SetupError(options::origin_of(origins, "profile_mm") + ": " + error.what());
  }
  take_sizes(o, origins, shape, "profile", options::origin_of(origins, o.profile.empty() ? "profile_mm" : "profile"));
}

/// Checks the bore and the surfaces of filler and core. Throws SetupError.
void settle_inner(const Options &o, const options::Origins &origins) {
  if (o.bore_radius_mm == 0 && o.bore_depth_mm != 0)
    refuse_value(origins, "bore_depth_mm", o.bore_depth_mm, "needs --bore-radius-mm");
  if (o.bore_radius_mm != 0 && !(o.bore_depth_mm > 0))
    refuse_value(origins, "bore_depth_mm", o.bore_depth_mm, "must be positive with --bore-radius-mm");
  for (const auto &[key, values] :
       {std::pair{"core_profile_mm", &o.core_profile_mm}, {"filler_profile_mm", &o.filler_profile_mm}}) {
    if (values->size() % 2 != 0)
      refuse_value(origins, key, values->size(), "must be an even number of values, z and r in turn");
    if (!values->empty() && o.bore_radius_mm != 0)
      refuse_value(origins, "bore_radius_mm", o.bore_radius_mm,
                   std::string("contradicts ") + key + ": give one of them");
  }
  if (o.core_profile_mm.empty() && !o.filler_profile_mm.empty())
    refuse_value(origins, "filler_profile_mm", o.filler_profile_mm.size(), "needs --core-profile-mm");
  const auto shape = shape_of(o);
  if (shape.inner.empty()) return;
  const char *key = o.bore_radius_mm != 0 ? "bore_radius_mm" : "core_profile_mm";
  if (shape.is_hollow && o.bore_depth_mm > ogive::length(shape) * 1e3 * (1 + 1e-9))
    refuse_value(origins, "bore_depth_mm", o.bore_depth_mm,
                 "must be at most the length, " + options::shortest(millimetres(ogive::length(shape))) + " mm");
  try {
    check(shape), check_inner(shape);
  } catch (const ogive::SetupError &error) {
    throw ogive::SetupError(options::origin_of(origins, key) + ": " + error.what());
  }
}

/// Checks the boat tail. Throws SetupError.
void settle_tail(const Options &o, const options::Origins &origins, double shank_mm) {
  if (o.tail_length_mm == 0 && o.tail_diameter_mm == 0) return;
  if (o.tail_length_mm == 0) refuse_value(origins, "tail_diameter_mm", o.tail_diameter_mm, "needs --tail-length-mm");
  if (o.tail_diameter_mm < o.diameter_mm / 4 || o.tail_diameter_mm > o.diameter_mm)
    refuse_value(origins, "tail_diameter_mm", o.tail_diameter_mm,
                 "must lie between " + options::shortest(o.diameter_mm / 4) +
                     " mm, a quarter of the diameter, and the diameter");
  if (!(o.tail_length_mm < shank_mm))
    refuse_value(origins, "tail_length_mm", o.tail_length_mm,
                 "must be less than the length of the shank, " + options::shortest(millimetres(shank_mm * 1e-3)) +
                     " mm");
}

} // namespace

void settle_nose(Options &o, const options::Origins &origins) {
  if (!o.projectile_mesh.empty()) {
    if (origins.contains("nose") && o.nose != Nose::mesh)
      refuse_value(origins, "nose", o.nose, "contradicts projectile_mesh: give one of them");
    if (!o.profile_mm.empty())
      options::refuse(options::origin_of(origins, "projectile_mesh"), o.projectile_mesh,
                      "contradicts profile: give one of them");
    o.nose = Nose::mesh;
    o.own_mesh = read_own_mesh(o.projectile_mesh, o.mesh_unit, o.extent, o.parts,
                               options::origin_of(origins, "projectile_mesh"));
    return;
  }
  if (o.nose == Nose::mesh) refuse_value(origins, "nose", o.nose, "needs --projectile-mesh FILE");
  if (o.profile_mm.empty()) return;
  if (origins.contains("nose") && o.nose != Nose::profile)
    refuse_value(origins, "nose", o.nose, "contradicts profile: give one of them");
  o.nose = Nose::profile;
}

void settle_projectile(Options &o, const options::Origins &origins) {
  if (o.nose == Nose::mesh)
    return take_sizes(o, origins, shape_of(o), "projectile_mesh", options::origin_of(origins, "projectile_mesh"));
  settle_profile(o, origins);
  if (o.nose == Nose::profile) return settle_inner(o, origins);
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
    refuse_value(origins, "nose_length_mm", o.nose_length_mm,
                 "needs --nose conical or --nose ogival, or --nose chisel");
  if (!origins.contains("tip_diameter_mm")) o.tip_diameter_mm = default_tip_diameter_mm(o);
  if (!is_pointed(o) && o.tip_diameter_mm != 0)
    refuse_value(origins, "tip_diameter_mm", o.tip_diameter_mm, "needs --nose conical, ogival or chisel");
  if (is_pointed(o) && !(o.tip_diameter_mm >= 0.02 * o.diameter_mm && o.tip_diameter_mm < o.diameter_mm))
    refuse_value(origins, "tip_diameter_mm", o.tip_diameter_mm,
                 "must lie between 0.02 diameters, " + options::shortest(0.02 * o.diameter_mm) +
                     " mm, and the diameter: hexes need a flat");
  if ((o.nose == Nose::conical || o.nose == Nose::chisel) && !(o.nose_length_mm > 0))
    refuse_value(origins, "nose_length_mm", o.nose_length_mm, "must be positive");
  if (o.nose == Nose::chisel && o.nose_length_mm > 0.9 * (o.diameter_mm - o.tip_diameter_mm))
    refuse_value(origins, "nose_length_mm", o.nose_length_mm,
                 "must be at most " + options::shortest(millimetres(0.9e-3 * (o.diameter_mm - o.tip_diameter_mm))) +
                     " mm: flats inclined by 61 degrees");
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
  if (o.nose == Nose::sphere && o.length_mm != default_length_mm(o))
    refuse_value(origins, "length_mm", o.length_mm, "must be the diameter of a sphere");
  const double shank_mm = shape_of(o).shank_length * 1e3;
  settle_tail(o, origins, shank_mm);
  settle_inner(o, origins);
  if (o.nose == Nose::sphere) return;
  if (!(shank_mm >= 0.1 * o.diameter_mm))
    refuse_value(origins, "length_mm", o.length_mm,
                 "must be " + options::shortest(std::ceil(10 * (o.length_mm - shank_mm + 0.1 * o.diameter_mm)) / 10) +
                     " mm or more: nose and a shank of a tenth of the diameter");
}

} // namespace shot
