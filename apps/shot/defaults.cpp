// SPDX-License-Identifier: BSD-3-Clause
#include "defaults.hpp"

#include "materials/library.hpp"
#include "named_projectile.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/sim/hash.hpp"
#include "parts.hpp"
#include "plates.hpp"
#include "projectile.hpp"
#include "table.hpp"

namespace shot {

namespace {

/// Coulomb friction: 0 for blunt noses, and so for chisels; for the others that of the method. The paper gives it for
/// conical and ogival noses on Weldox 460 E and for conical ones on AA5083-H116: with its method the metals of the
/// library have one each, and the metal of a file is taken for steel.
double default_friction(const Options &o, double of_method) {
  if (is_blunt(o)) return 0;
  const materials::LibraryMetal *metal = materials::find_library_metal(o.material);
  return metal == nullptr || o.method != Method::paper ? of_method : metal->sharp_friction;
}

/// "1=lead+2=mine" of the metals of parts.
std::string label_of_parts(const Options &o) {
  std::vector<std::string> labels;
  for (const std::string &entry : o.part_metals) {
    const PartMetal part = part_metal_of(entry);
    labels.push_back(entry_of({part.part, materials::label_of(part.metal)}));
  }
  return options::joined(labels, "+");
}

/// A short text that differs for other points.
std::string label_of_points(const std::vector<double> &points) {
  return points.empty() ? "" : options::printed("%08x", static_cast<unsigned>(ogive::hash_values(0, points)));
}

/// The value of an option in the name of a folder, numbers without the last digits of a conversion; empty for lists,
/// texts and files, which the name has already.
std::string label_of(const Options &o, const options::Option &option) {
  if (option.key == std::string_view("part_metals")) return label_of_parts(o);
  if (option.key == std::string_view("core_profile_mm")) return label_of_points(o.core_profile_mm);
  if (option.key == std::string_view("filler_profile_mm")) return label_of_points(o.filler_profile_mm);
  if (option.key == std::string_view("projectile_metal")) {
    const std::string metal = shown(option);
    return materials::label_of(metal);
  }
  if (option.kind == options::Kind::truth) return option.toml();
  if (option.kind == options::Kind::whole) return option.toml();
  if (option.kind == options::Kind::number) {
    const auto number = ogive::number_from(option.toml());
    return number ? options::shortest(std::round(*number * 1e6) / 1e6) : "";
  }
  return option.kind == options::Kind::choice ? shown(option) : "";
}

/// The options of the projectile that the folder's name states: of a named one what the library gives, of one from a
/// file all of it.
Options usual_projectile(const Options &o) {
  Options usual;
  const options::Table table = table_of(usual);
  options::Origins origins;
  if (is_library_projectile(o.projectile)) {
    for (const options::Given &given : level_of_projectile({"projectile", "projectile", o.projectile}, "").given)
      options::apply(table, origins, given);
  } else if (!o.projectile.empty()) {
    copy_projectile(o, usual);
  }
  return usual;
}

/// The case of which the folder's name states everything before the differences.
Options usual(const Options &o) {
  const Options named = usual_projectile(o);
  Options usual = named;
  usual.material = o.material;
  usual.model = o.model;
  usual.method = o.method;
  usual.thickness_mm = o.thickness_mm;
  usual.nose = o.nose;
  usual.diameter_mm = o.diameter_mm;
  usual.velocity_mps = o.velocity_mps;
  usual.obliquity_deg = o.obliquity_deg;
  usual.pitch_deg = o.pitch_deg, usual.yaw_deg = o.yaw_deg;
  usual.damage = o.damage;
  usual.own_mesh = o.own_mesh;
  take_defaults(usual, {{"damage", ""}});
  usual.damage = default_damage(o);
  usual.nose_length_mm = o.nose_length_mm;
  usual.tip_diameter_mm = o.tip_diameter_mm;
  usual.profile_mm = o.profile_mm;
  usual.projectile_mesh = o.projectile_mesh, usual.own_mesh = o.own_mesh;
  usual.length_mm = default_length_mm(usual);
  usual.nose_length_mm = default_nose_length_mm(usual);
  usual.tip_diameter_mm = default_tip_diameter_mm(usual);
  if (!o.projectile.empty()) {
    usual.nose = named.nose, usual.diameter_mm = named.diameter_mm, usual.length_mm = named.length_mm;
    usual.nose_length_mm = named.nose_length_mm, usual.tip_diameter_mm = named.tip_diameter_mm;
  }
  return usual;
}

/// "_key=value" of each option that makes the case another one than the usual.
std::string differences(Options here) {
  Options there = usual(here);
  const auto mine = table_of(here).options, others = table_of(there).options;
  std::string text;
  for (std::size_t i = 0; i < mine.size(); ++i)
    if (const std::string label = label_of(here, mine[i]);
        mine[i].group != run_group && label != label_of(there, others[i]))
      text += "_" + std::string(mine[i].key) + "=" + label;
  return text;
}

} // namespace

DamageLaw default_damage(const Options &o) {
  const DamageLaw law = ogive::choices_of<double>(o.method).damage;
  return law == DamageLaw::johnson_cook && !have_failure_strains(o) ? DamageLaw::none : law;
}

FailureEffect default_failure(DamageLaw damage) {
  return damage == DamageLaw::none ? FailureEffect::none : FailureEffect::no_tension;
}

double default_end_us(const Options &o) {
  const bool blunt = is_blunt(o);
  const double passage_us = (o.length_mm + target_depth_mm(o)) / o.velocity_mps * 1e3;
  const double least_us = (blunt ? 500 : 1500) * std::max(1.0, o.diameter_mm / 20);
  return std::clamp(10 * std::ceil((blunt ? 3 : 6) * passage_us / 10), least_us, longest_us);
}

void take_defaults(Options &o, const options::Origins &origins) {
  const auto is_open = [&](const char *key) { return !origins.contains(key); };
  const auto choices = ogive::choices_of<double>(o.method);
  if (is_open("lattice")) o.lattice = choices.lattice;
  if (is_open("damage")) o.damage = default_damage(o);
  if (is_open("band_onset")) o.band_onset = choices.band_onset;
  if (o.damage != DamageLaw::none) {
    if (is_open("damage_softening")) o.damage_softening = choices.softening;
    if (is_open("damage_pressure")) o.damage_pressure = choices.numerics.sph.damage_pressure;
  } else {
    if (is_open("damage_softening")) o.damage_softening = 0;
    if (is_open("damage_pressure")) o.damage_pressure = DamagePressure::own;
  }
  if (is_open("control_stiffness")) o.control_stiffness = choices.numerics.sph.control.stiffness;
  if (is_open("failure")) o.failure = default_failure(o.damage);
  if (is_open("friction")) o.friction = default_friction(o, choices.sharp_friction);
}

std::string thickness_label(const Options &o) {
  if (o.layers_mm.empty()) return options::shortest(o.thickness_mm) + "mm";
  const bool apart = std::any_of(o.gaps_mm.begin(), o.gaps_mm.end(), [](double gap) { return gap > 0; });
  const bool equal =
      apart && std::count(o.gaps_mm.begin(), o.gaps_mm.end(), o.gaps_mm.front()) == std::ssize(o.gaps_mm);
  return joined(o.layers_mm, "+") + "mm" +
         (!apart  ? ""
          : equal ? "_" + options::shortest(o.gaps_mm.front()) + "mm_apart"
                  : "_" + joined(o.gaps_mm, "+") + "mm_apart");
}

std::string case_label(const Options &o) {
  return material_label(o) + "_" + name_of(o.model) + "_" + projectile_label(o) + "_" +
         (o.diameter_mm == Options{}.diameter_mm || !o.projectile.empty()
              ? ""
              : options::shortest(o.diameter_mm) + "mm_on_") +
         thickness_label(o) + (o.velocity_mps < 0 ? "" : "_" + options::shortest(o.velocity_mps) + "mps") +
         (o.obliquity_deg == 0 ? "" : "_" + options::shortest(o.obliquity_deg) + "deg") +
         (o.pitch_deg == 0 ? "" : "_pitch" + options::shortest(o.pitch_deg) + "deg") +
         (o.yaw_deg == 0 ? "" : "_yaw" + options::shortest(o.yaw_deg) + "deg") +
         (o.method == Options{}.method ? "" : "_" + name_of(o.method)) + differences(o);
}

std::filesystem::path default_out(const Options &o) { return std::filesystem::path("vtk_out") / case_label(o); }

} // namespace shot
