// SPDX-License-Identifier: BSD-3-Clause
#include "parts.hpp"

#include "materials/library.hpp"
#include "projectile.hpp"
#include "table.hpp"

#include "ogive/mesh/nested_mesh.hpp"

#include <algorithm>

namespace shot {

namespace {

using options::Given;
using options::refuse;

constexpr char allowed_entries[] = "PART=METAL with commas between them, each METAL ";

/// The entry that was given; throws SetupError unless it is a part with a metal that is known.
std::string entry_given(const Given &given) {
  const std::string allowed = allowed_entries + materials::allowed_projectile_metals();
  const std::string entry = line_given(given, allowed);
  const PartMetal part = part_metal_of(entry);
  if (part.part.empty() || part.metal.empty()) refuse(given, "must be " + allowed);
  if (!materials::is_known(part.metal)) {
    auto names = materials::projectile_metal_names();
    for (const auto &name : materials::library_names()) names.push_back(name);
    refuse(given.where + ", " + part.part, part.metal,
           "must be " + materials::allowed_projectile_metals() + options::nearest_text(part.metal, names));
  }
  return entry;
}

} // namespace

PartMetal part_metal_of(const std::string &entry) {
  const std::size_t equals = entry.find('=');
  if (equals == std::string::npos) return {};
  return {entry.substr(0, equals), entry.substr(equals + 1)};
}

std::string entry_of(const PartMetal &part) { return part.part + "=" + part.metal; }

// clang-format off
void add_parts(options::Table &t, Options &o) {
  options::Option &metals = options::add_option(t, {.key = "part_metals", .meaning = "metals of the projectile's parts: "
      "numbers or names of parts in a mesh, else jacket, filler and core; parts that are not listed have "
      "--projectile-metal",
      .source = "none"}, options::Kind::texts, "PART=METAL,...");
  metals.range = "";
  metals.allowed_text = allowed_entries + materials::allowed_projectile_metals();
  metals.assign = [&o](const Given &given) {
    std::vector<std::string> seen;
    for (const Given &one : entries_given(given)) {
      const std::string entry = entry_given(one), name = part_metal_of(entry).part;
      if (std::find(seen.begin(), seen.end(), name) != seen.end()) refuse(given.where, name, "must be given once");
      seen.push_back(name);
      // Parts that are not named keep the metals that their projectile gives them.
      std::erase_if(o.part_metals, [&](const std::string &earlier) { return part_metal_of(earlier).part == name; });
      o.part_metals.push_back(entry);
    }
  };
  metals.toml = [&o] {
    std::vector<std::string> entries;
    for (const auto &entry : o.part_metals) entries.push_back(options::toml_string(entry));
    return entries.empty() ? "" : "[" + options::joined(entries) + "]";
  };
  add(t, o.parts, {.key = "parts", .meaning = "connection of the projectile's parts: tied parts share the nodes where "
      "they meet, touching ones slide on each other and may separate", .source = "ours"});
  add(t, o.part_friction, {.key = "part_friction", .meaning = "Coulomb friction between parts that touch",
      .source = "assumed", .limits = {0, 2, ""}});
  add(t, o.bore_radius_mm, {.key = "bore_radius_mm", .meaning = "radius of a bore from the rear; 0: none",
      .source = "ours", .limits = {0, 100, "mm"}});
  add(t, o.bore_depth_mm, {.key = "bore_depth_mm", .meaning = "depth of the bore; the length of a blunt projectile "
      "makes a tube", .source = "none", .limits = {0, 2000, "mm"}});
  add(t, o.filler_profile_mm, {.key = "filler_profile_mm", .meaning = "z from the tip and r in turn of points of the "
      "surface between jacket and filler, closed by flats at both ends", .source = "none", .limits = {0, 2000, "mm"}});
  add(t, o.core_profile_mm, {.key = "core_profile_mm", .meaning = "z from the tip and r in turn of points of the "
      "surface of the core, in a filler or in the jacket", .source = "none", .limits = {0, 2000, "mm"}});
}
// clang-format on

Given part_metals_given(const Given &tables) {
  Given metals{"part_metals", tables.where, "", Given::list};
  const auto bad = [&](const Given &given) {
    refuse(given.where, given.value, "must be a table [part.NAME] with metal = \"NAME or FILE.toml\"");
  };
  if (tables.entries.empty()) bad(tables);
  for (const Given &part : tables.entries) {
    if (part.entries.size() != 1 || part.entries.front().key != "metal" || part.entries.front().kind != Given::text)
      bad(part);
    const Given &metal = part.entries.front();
    metals.entries.push_back({"part_metals", metal.where, entry_of({part.key, metal.value}), Given::text});
  }
  return metals;
}

std::vector<std::string> parts_of(const Options &o) {
  if (o.own_mesh.read) return o.own_mesh.read->projectile.body.parts;
  return ogive::part_names(shape_of(o));
}

std::vector<std::string> part_materials(const Options &o) {
  std::vector<std::string> metals;
  for (const std::string &name : parts_of(o)) {
    metals.push_back(o.projectile_metal);
    for (const std::string &entry : o.part_metals)
      if (const PartMetal part = part_metal_of(entry); part.part == name) metals.back() = part.metal;
  }
  return metals;
}

void settle_parts(Options &o, const options::Origins &origins) {
  const auto names = parts_of(o);
  for (const std::string &entry : o.part_metals) {
    const PartMetal part = part_metal_of(entry);
    if (std::find(names.begin(), names.end(), part.part) == names.end())
      refuse(options::origin_of(origins, "part_metals"), part.part,
             names.size() == 1 && names.front() == "1" && !o.own_mesh.read
                 ? "needs a projectile with parts: --core-profile-mm, or a mesh with several"
                 : "must be one of the parts " + options::joined(names));
  }
  if (o.parts == Parts::touching && names.size() == 1)
    refuse_value(origins, "parts", o.parts,
                 "needs a projectile with several parts: --core-profile-mm, or a mesh with them");
  if (o.parts == Parts::touching && o.rigid)
    refuse_value(origins, "parts", o.parts, "must be tied in a --rigid projectile, which moves as one");
  // A file that no part is made of has no copy in the folder of the results.
  const auto metals = part_materials(o);
  if (std::find(metals.begin(), metals.end(), o.projectile_metal) == metals.end() &&
      materials::is_material_file(o.projectile_metal))
    o.projectile_metal = Options{}.projectile_metal;
}

std::string part_metals_label(const Options &o) {
  std::vector<std::string> labels;
  for (const std::string &metal : part_materials(o)) labels.push_back(materials::label_of(metal));
  return options::joined(labels, "+");
}

std::vector<std::string> part_metal_files(const Options &o) {
  const auto names = parts_of(o);
  if (names.size() == 1) return {"projectile_metal.toml"};
  std::vector<std::string> files;
  for (const std::string &name : names) files.push_back("projectile_" + name + "_metal.toml");
  return files;
}

} // namespace shot
