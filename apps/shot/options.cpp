// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "defaults.hpp"
#include "materials/library.hpp"
#include "named_projectile.hpp"
#include "parts.hpp"
#include "plates.hpp"
#include "projectile.hpp"
#include "table.hpp"
#include "to_case.hpp"

#include <numbers>
#include <numeric>

namespace shot {

namespace {

using options::Given;
using options::Origins;
using options::shortest;

/// Sets what one level gives; later levels win. A projectile by name or file is a level below its own.
void apply_level(Options &o, Origins &origins, const Level &level, bool first) {
  const options::Table table = table_of(o);
  const auto gives = [&](std::string_view key) {
    return std::any_of(level.given.begin(), level.given.end(), [&](const Given &given) { return given.key == key; });
  };
  for (const Given &given : level.given)
    if (given.key == "projectile" && names_projectile(given.value)) {
      const Level of_projectile = level_of_projectile(given, level.folder);
      forget_projectile(o, origins);
      apply_level(o, origins, of_projectile, false);
    }
  // The points that come with the name of a file are those of the file.
  const bool reads_profile = gives("profile") && !gives("profile_mm");
  if (reads_profile) o.profile_mm.clear();
  if (!first)
    for (const Given &given : level.given) override_layers(o, origins, given.key);
  for (const Given &given : level.given) options::apply(table, origins, given);
  if (reads_profile) read_profile(o, origins, level.folder);
  if (level.folder.empty()) return;
  const auto from_there = [&](std::string &material) {
    if (materials::is_material_file(material)) material = (level.folder / material).string();
  };
  for (const Given &given : level.given) {
    if (given.key == "material") from_there(o.material);
    if (given.key == "projectile_metal") from_there(o.projectile_metal);
    if (given.key == "projectile") from_there(o.projectile);
    if (given.key == "projectile_mesh") o.projectile_mesh = (level.folder / o.projectile_mesh).string();
    if (given.key == "part_metals")
      for (std::string &entry : o.part_metals) {
        PartMetal part = part_metal_of(entry);
        from_there(part.metal);
        entry = entry_of(part);
      }
    if (given.key == "layer_materials") std::for_each(o.layer_materials.begin(), o.layer_materials.end(), from_there);
  }
}

} // namespace

std::vector<Level> levels_of(const options::CommandLine &line) {
  Options any;
  const options::Table table = table_of(any);
  std::vector<Level> levels(1);
  if (line.config)
    levels.front() = {
        options::entries_of(table, options::text_of_file(*line.config, "--config"), *line.config, toml_example),
        std::filesystem::path(*line.config).parent_path()};
  Level &own = levels.emplace_back();
  for (const Given &given : line.given)
    if (options::find(table, given.key) != nullptr) own.given.push_back(given);
  return levels;
}

Options settled(const std::vector<Level> &levels) {
  Options o;
  Origins origins;
  for (const Level &level : levels) apply_level(o, origins, level, &level == &levels.front());
  settle_layers(o, origins);
  settle_nose(o, origins);
  take_defaults(o, origins);
  settle_materials(o, origins);
  settle_projectile(o, origins);
  settle_parts(o, origins);
  if (!origins.contains("end_us")) o.end_us = default_end_us(o);
  if (!origins.contains("out")) o.out = default_out(o);
  check(o, origins);
  return o;
}

void check(const Options &o, const Origins &origins) {
  const auto refuse = [&](const char *key, const auto &value, const std::string &allowed) {
    refuse_value(origins, key, value, allowed);
  };
  if (o.damage == DamageLaw::none) {
    const std::string needed = "needs --damage jc or --damage cockcroft_latham";
    if (o.failure != FailureEffect::none) refuse("failure", o.failure, needed);
    if (o.damage_softening > 0) refuse("damage_softening", o.damage_softening, needed);
    if (o.damage_pressure != DamagePressure::own) refuse("damage_pressure", o.damage_pressure, needed);
  }
  const double thinnest =
      o.layers_mm.empty() ? o.thickness_mm : *std::min_element(o.layers_mm.begin(), o.layers_mm.end());
  const double coarsest = std::round(1e6 * thinnest / 2) / 1e6;
  if (o.spacing_mm > coarsest)
    refuse("spacing_mm", o.spacing_mm,
           std::string("must be at most half the thickness of the ") + (o.layers_mm.empty() ? "" : "thinnest ") +
               "plate, " + shortest(coarsest) + " mm");
  // A plate has a whole number of layers, so that the particle distance in it may be larger than --spacing-mm. The
  // hexes of a projectile follow it, unless its mesh is the user's own.
  const double first = o.layers_mm.empty() ? o.thickness_mm : o.layers_mm.front();
  const double in_plate =
      o.projectile_mesh.empty() ? first / static_cast<double>(ogive::layer_count(first, o.spacing_mm)) : o.spacing_mm;
  if (std::max(o.spacing_mm, in_plate) > o.diameter_mm / 4)
    refuse("spacing_mm", o.spacing_mm,
           "must be at most a quarter of the projectile's diameter, " + shortest(o.diameter_mm / 4) + " mm" +
               (o.spacing_mm > o.diameter_mm / 4 ? "" : ", where whole layers of particles fill the plate, too"));
  const double smallest_disc = std::round(1e9 * ogive::least_sph_radius(to_case(o))) / 1e6;
  const bool tilted = o.obliquity_deg > 0 || o.pitch_deg != 0 || o.yaw_deg != 0;
  if (o.sph_radius_mm < smallest_disc || o.sph_radius_mm >= o.clamp_radius_mm)
    refuse("sph_radius_mm", o.sph_radius_mm,
           "must lie between " + shortest(smallest_disc) + " mm, " +
               (tilted ? "what the oblique projectile needs" : "the projectile's radius") + " and two spacings, and " +
               "less than the clamp radius, " + shortest(o.clamp_radius_mm) + " mm");
  if (o.obliquity_deg > 0 && o.extent == Extent::quarter)
    refuse("obliquity_deg", o.obliquity_deg, "needs --extent half or --extent full");
  if (o.pitch_deg != 0 && o.extent == Extent::quarter)
    refuse("pitch_deg", o.pitch_deg, "needs --extent half or --extent full");
  if (o.yaw_deg != 0 && o.extent != Extent::full) refuse("yaw_deg", o.yaw_deg, "needs --extent full");
  if (o.mass_g > 0) {
    // Plastics to the heaviest metals, and bodies that are hollow or carry more than they are.
    constexpr double lightest = 100, heaviest = 50000; // kg/m3
    const double volume = ogive::volume(shape_of(o)), low = lightest * volume * 1e3, high = heaviest * volume * 1e3;
    if (o.mass_g < low || o.mass_g > high)
      refuse("mass_g", o.mass_g,
             "must give the projectile a density between 100 and 50000 kg/m3: " + shortest(std::ceil(low * 1e3) / 1e3) +
                 " to " + shortest(std::floor(high)) + " g");
  }
  const double particles = estimated_particles(o);
  if (particles > most_particles)
    refuse("spacing_mm", o.spacing_mm,
           "gives about " + shortest(std::round(particles / 1e6)) + " million particles, at most " +
               shortest(most_particles / 1e6) + " million are allowed");
}

double target_depth_mm(const Options &o) { return std::accumulate(o.gaps_mm.begin(), o.gaps_mm.end(), o.thickness_mm); }

double estimated_particles(const Options &o) {
  const double part = o.extent == Extent::quarter ? 0.25 : o.extent == Extent::half ? 0.5 : 1.0;
  return part * std::numbers::pi * o.sph_radius_mm * o.sph_radius_mm * o.thickness_mm / std::pow(o.spacing_mm, 3);
}

std::string to_toml(const Options &options) {
  Options o = options;
  const bool own_metal = materials::is_material_file(o.material) || materials::is_material_file(o.projectile_metal) ||
                         !o.projectile_mesh.empty() || !o.part_metals.empty();
  // What a reader of the file should choose anew, and what follows from other values. The copy of a material file has
  // another name, from which no folder can follow.
  const auto left_out = [&](const options::Option &option) {
    const std::string_view key = option.key;
    return (key == "out" && !own_metal && o.out == default_out(o)) ||
           (key == "model" && materials::is_material_file(o.material)) ||
           (key == "failure" && o.failure == default_failure(o.damage)) ||
           (key == "thickness_mm" && !o.layers_mm.empty()) || (key == "material" && !o.layer_materials.empty()) ||
           (o.projectile.empty() && ((key == "nose_length_mm" && o.nose_length_mm == default_nose_length_mm(o)) ||
                                     (key == "length_mm" && o.length_mm == default_length_mm(o)) ||
                                     (key == "tip_diameter_mm" && o.tip_diameter_mm == default_tip_diameter_mm(o)))) ||
           key == "calibre_radius_head";
  };
  return "# Runs the same case again: ogive shoot --config <this file>\n"
         "# The command line overrides this file. Values of friction and end_us are those that were used: with "
         "another\n"
         "# nose or material give them anew, or delete them to have the defaults.\n" +
         options::to_toml(table_of(o), left_out);
}

std::string to_complete_toml(const Options &options) {
  Options o = options;
  // Beyond the limits of one plate, and known from its parts.
  const auto left_out = [&](const options::Option &option) {
    return option.key == std::string_view("thickness_mm") && !o.layers_mm.empty();
  };
  return options::to_toml(table_of(o), left_out, false);
}

} // namespace shot
