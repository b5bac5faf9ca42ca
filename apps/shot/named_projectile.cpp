// SPDX-License-Identifier: BSD-3-Clause
#include "named_projectile.hpp"

#include "materials/library.hpp"
#include "parts.hpp"
#include "table.hpp"

#include "ogive/perforation/projectile_library.hpp"

#include <array>

namespace shot {

namespace {

using options::Given;
using options::Origins;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 24> keys{"nose",
                                                "diameter_mm",
                                                "length_mm",
                                                "nose_length_mm",
                                                "tip_diameter_mm",
                                                "calibre_radius_head",
                                                "edge_radius_mm",
                                                "tail_length_mm",
                                                "tail_diameter_mm",
                                                "mass_g",
                                                "profile",
                                                "profile_mm",
                                                "projectile_mesh",
                                                "mesh_unit",
                                                "part_metals",
                                                "parts",
                                                "part_friction",
                                                "bore_radius_mm",
                                                "bore_depth_mm",
                                                "filler_profile_mm",
                                                "core_profile_mm",
                                                "projectile_metal",
                                                "projectile_erosion",
                                                "rigid"};

/// A name that means a nose and nothing else: --nose.
bool is_nose(std::string_view name) {
  for (const Nose nose : ogive::all_noses)
    if (name == ogive::name(nose) && nose != Nose::profile && nose != Nose::mesh) return true;
  return false;
}

/// The projectile of the library with this name.
std::optional<ogive::Projectile<double>> find_projectile(std::string_view name) {
  for (auto &projectile : ogive::library::all_projectiles<double>())
    if (projectile.name == name) return std::move(projectile);
  return std::nullopt;
}

/// "arne_tool_steel", or "jacket gilding_metal, core lead".
std::string metals_text(const ogive::Projectile<double> &p) {
  if (p.part_metals.empty()) return p.metal.name;
  const auto parts = ogive::part_names(p.shape);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < parts.size(); ++k) texts.push_back(parts[k] + " " + p.part_metals[k]);
  return options::joined(texts);
}

/// Without the last digits of a conversion.
std::string in_thousandths(double value) { return options::shortest(std::round(value * 1e9) / 1e6); }

std::vector<Given> givens_of(const ogive::Projectile<double> &p, const std::string &where) {
  std::vector<Given> all;
  const auto give = [&](const char *key, const std::string &value) { all.push_back({key, where, value}); };
  const auto give_profile = [&](const char *key, const ogive::Profile<double> &profile) {
    Given given{key, where, "", Given::list};
    for (const auto &point : profile)
      for (const double value : {point.z, point.radius})
        given.entries.push_back({key, where, in_thousandths(value), Given::number});
    all.push_back(given);
  };
  give("nose", std::string(name(p.shape.nose)));
  if (is_nose(p.name)) return all;
  if (!p.shape.inner.empty()) give_profile("core_profile_mm", p.shape.inner.front());
  if (p.shape.inner.size() > 1) give_profile("filler_profile_mm", p.shape.inner.back());
  Given metals{"part_metals", where, "", Given::list};
  const auto parts = ogive::part_names(p.shape);
  for (std::size_t k = 0; k < p.part_metals.size(); ++k)
    metals.entries.push_back({"part_metals", where, entry_of({parts[k], p.part_metals[k]}), Given::text});
  if (!metals.entries.empty()) all.push_back(metals);
  if (p.shape.nose == Nose::profile) {
    give_profile("profile_mm", p.shape.profile);
    give("diameter_mm", in_thousandths(p.shape.diameter));
    give("length_mm", in_thousandths(ogive::length(p.shape)));
    give("mass_g", in_thousandths(p.mass));
    give("projectile_metal", p.metal.name);
    give("rigid", p.rigid ? "true" : "false");
    return all;
  }
  give("diameter_mm", in_thousandths(p.shape.diameter));
  give("length_mm", in_thousandths(ogive::length(p.shape)));
  give("nose_length_mm", in_thousandths(p.shape.nose_length));
  give("tip_diameter_mm", in_thousandths(p.shape.tip_diameter));
  give("mass_g", in_thousandths(p.mass));
  give("projectile_metal", p.metal.name);
  give("rigid", p.rigid ? "true" : "false");
  return all;
}

} // namespace

bool is_of_projectile(std::string_view key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); }

bool names_projectile(std::string_view value) { return value != "deformable" && value != "rigid"; }

std::string projectile_title(const std::string &name) {
  const auto projectile = find_projectile(name);
  return projectile ? projectile->title : name;
}

std::vector<std::string> projectile_names() {
  std::vector<std::string> names;
  for (const auto &projectile : ogive::library::all_projectiles<double>()) names.push_back(projectile.name);
  return names;
}

bool is_library_projectile(std::string_view name) { return !is_nose(name) && find_projectile(name).has_value(); }

std::string allowed_projectiles() {
  return "one of " + options::joined(projectile_names()) + ", or a file that ends in .toml";
}

std::string projectile_given(const Given &given) {
  const std::string name = line_given(given, allowed_projectiles());
  if (names_projectile(name) && !materials::is_material_file(name) && !find_projectile(name))
    refuse(given, "must be " + allowed_projectiles() + options::nearest_text(name, projectile_names()));
  return name;
}

Level level_of_projectile(const Given &given, const fs::path &folder) {
  const std::string name = projectile_given(given);
  if (const auto projectile = find_projectile(name)) return {givens_of(*projectile, given.where), folder};
  const fs::path file = folder / name;
  Options any;
  options::Table table = table_of(any);
  std::erase_if(table.options, [](const options::Option &option) { return !is_of_projectile(option.key); });
  // In a file of a projectile a mesh is just that, and parts have tables.
  for (options::Option &option : table.options) {
    if (option.key == std::string_view("projectile_mesh")) option.key = "mesh";
    if (option.key == std::string_view("part_metals")) option.key = "part";
  }
  Level level{options::entries_of(table, options::text_of_file(file, given.where), file.string(), "diameter_mm = 12.7"),
              file.parent_path()};
  for (Given &entry : level.given) {
    if (entry.key == "mesh") entry.key = "projectile_mesh";
    if (entry.key == "part") entry = part_metals_given(entry);
  }
  return level;
}

void copy_projectile(const Options &from, Options &to) {
  to.projectile = from.projectile, to.nose = from.nose;
  to.diameter_mm = from.diameter_mm, to.length_mm = from.length_mm;
  to.nose_length_mm = from.nose_length_mm, to.tip_diameter_mm = from.tip_diameter_mm;
  to.calibre_radius_head = from.calibre_radius_head, to.edge_radius_mm = from.edge_radius_mm;
  to.tail_length_mm = from.tail_length_mm, to.tail_diameter_mm = from.tail_diameter_mm;
  to.profile = from.profile, to.profile_mm = from.profile_mm;
  to.projectile_mesh = from.projectile_mesh, to.mesh_unit = from.mesh_unit, to.own_mesh = from.own_mesh;
  to.part_metals = from.part_metals, to.parts = from.parts, to.part_friction = from.part_friction;
  to.bore_radius_mm = from.bore_radius_mm, to.bore_depth_mm = from.bore_depth_mm;
  to.filler_profile_mm = from.filler_profile_mm, to.core_profile_mm = from.core_profile_mm;
  to.projectile_erosion = from.projectile_erosion;
  to.mass_g = from.mass_g, to.projectile_metal = from.projectile_metal, to.rigid = from.rigid;
}

void forget_projectile(Options &o, Origins &origins) {
  copy_projectile({}, o);
  for (const std::string_view key : keys) origins.erase(std::string(key));
}

std::string projectile_list() {
  std::string text = "Projectiles for --projectile:\n";
  for (const auto &p : ogive::library::all_projectiles<double>()) {
    const double grams = 1e3 * (p.mass > 0 ? p.mass : ogive::mass(p.shape, p.metal.density));
    text += options::broken("  " + p.name + ": ",
                            options::printed("%.4g mm in diameter, %.4g mm long, %.4g g, %s%s; ",
                                             1e3 * p.shape.diameter, 1e3 * ogive::length(p.shape), grams,
                                             metals_text(p).c_str(), p.rigid ? ", rigid" : "") +
                                p.source,
                            4);
  }
  return text;
}

} // namespace shot
