// SPDX-License-Identifier: BSD-3-Clause
#include "plates.hpp"

#include "materials/library.hpp"
#include "materials/material_keys.hpp"
#include "parts.hpp"
#include "table.hpp"
#include "tested_range.hpp"

#include <numeric>
#include <utility>

namespace shot {

namespace {

using materials::AnyMetal;
using materials::is_material_file;
using options::origin_of;
using options::Origins;
using options::printable;
using options::refuse;

/// The comment between the metals of two plates.
constexpr char next_plate[] = "next plate";

/// The one before that of the projectile.
constexpr char next_projectile[] = "the projectile";

/// The one between the metals of two parts.
constexpr char next_part[] = "next part";

/// A comment of metals_text() with the line ends around it.
std::string mark_of(const char *comment) { return "\n# " + std::string(comment) + "\n"; }

/// The metals in a text of metals_text(), one by one, that have this comment between them.
std::vector<std::string> metal_texts(std::string_view all, const char *comment) {
  const std::string mark = mark_of(comment);
  std::vector<std::string> texts;
  for (std::size_t end = all.find(mark); end != std::string_view::npos; end = all.find(mark)) {
    texts.emplace_back(all.substr(0, end + 1));
    all.remove_prefix(end + 1);
  }
  texts.emplace_back(all);
  return texts;
}

/// Takes the model of a material file and checks that it has the constants that the options need. Throws SetupError.
void settle_material(Options &o, const std::string &material, bool is_model_fixed, const Origins &origins) {
  const std::string origin = origin_of(origins, o.layer_materials.empty() ? "material" : "layer_materials");
  const auto plate = materials::find_metal(material, o.model, origin);
  const FlowModel model = materials::model_of(plate);
  if (o.model != model && origins.contains("model"))
    refuse_value(origins, "model", o.model,
                 "contradicts " + printable(material) + ", which has model = " + name_of(model));
  if (o.model != model && is_model_fixed)
    refuse(origin, printable(material),
           "has model = " + name_of(model) + ", the other plates " + name_of(o.model) +
               ": all plates must have the same");
  o.model = model;

  using materials::Group;
  const auto need = [&](const char *key, auto choice, Group group) {
    if (!has(plate, group))
      refuse_value(origins, key, choice, "needs " + keys_of(group) + " in " + printable(material));
  };
  if (o.pressure == PressureLaw::mie_gruneisen) need("pressure", o.pressure, Group::shock);
  if (o.damage == DamageLaw::johnson_cook) need("damage", o.damage, Group::strain);
  if (o.damage == DamageLaw::cockcroft_latham) need("damage", o.damage, Group::work);
}

} // namespace

std::string material_label(const Options &o) {
  std::vector<std::string> labels;
  for (const std::string &material : o.layer_materials) labels.push_back(materials::label_of(material));
  return labels.empty() ? materials::label_of(o.material) : joined(labels, "+");
}

void override_layers(Options &o, Origins &origins, const std::string &key) {
  const auto forget = [&](const char *other, auto clear) {
    if (origins.erase(other) > 0) clear();
  };
  if (key == "thickness_mm") {
    forget("layers_mm", [&] { o.layers_mm.clear(); });
    forget("gaps_mm", [&] { o.gaps_mm.clear(); });
    forget("layer_materials", [&] { o.layer_materials.clear(); });
  }
  if (key == "material") forget("layer_materials", [&] { o.layer_materials.clear(); });
  if (key == "layers_mm") forget("thickness_mm", [&] { o.thickness_mm = Options{}.thickness_mm; });
  if (key == "layer_materials") forget("material", [&] { o.material = Options{}.material; });
}

void settle_layers(Options &o, const Origins &origins) {
  const std::size_t count = o.layers_mm.size();
  if (!origins.contains("layers_mm")) {
    if (!o.gaps_mm.empty()) refuse_value(origins, "gaps_mm", o.gaps_mm, "needs --layers-mm");
    if (!o.layer_materials.empty()) refuse_value(origins, "layer_materials", o.layer_materials, "needs --layers-mm");
    return;
  }
  if (count < 1 || count > ogive::most_layers)
    refuse_value(origins, "layers_mm", o.layers_mm,
                 "must be 1 to " + std::to_string(ogive::most_layers) + " thicknesses");
  if (origins.contains("thickness_mm"))
    refuse_value(origins, "layers_mm", o.layers_mm, "contradicts thickness_mm: give one of them");

  const std::size_t gaps = count - 1;
  if (o.gaps_mm.size() == 1 && gaps > 0) o.gaps_mm.resize(gaps, o.gaps_mm.front());
  if (!origins.contains("gaps_mm")) o.gaps_mm.assign(gaps, 0);
  if (o.gaps_mm.size() != gaps)
    refuse_value(origins, "gaps_mm", o.gaps_mm,
                 gaps == 0 ? "needs --layers-mm with at least 2 thicknesses"
                           : "must be 1 number, or " + std::to_string(gaps) + " between " + std::to_string(count) +
                                 " plates");
  if (origins.contains("layer_materials")) {
    if (o.layer_materials.size() != count)
      refuse_value(origins, "layer_materials", o.layer_materials,
                   "must be " + std::to_string(count) + ", one for each plate of --layers-mm");
    if (origins.contains("material"))
      refuse_value(origins, "layer_materials", o.layer_materials, "contradicts material: give one of them");
    o.material = o.layer_materials.front();
    if (std::all_of(o.layer_materials.begin(), o.layer_materials.end(),
                    [&](const std::string &material) { return material == o.material; }))
      o.layer_materials.clear();
  }
  o.thickness_mm = std::accumulate(o.layers_mm.begin(), o.layers_mm.end(), 0.0);
  if (count == 1) o.layers_mm.clear(), o.gaps_mm.clear();
}

std::vector<std::string> materials_of(const Options &o) {
  if (!o.layer_materials.empty()) return o.layer_materials;
  return std::vector(std::max<std::size_t>(1, o.layers_mm.size()), o.material);
}

bool have_failure_strains(const Options &o) {
  const auto has_one = [&](const std::string &material) {
    try {
      return has(materials::find_metal(material, o.model, ""), materials::Group::strain);
    } catch (const ogive::SetupError &) {
      return true;
    }
  };
  const auto materials = materials_of(o);
  return o.restart || std::all_of(materials.begin(), materials.end(), has_one);
}

Plates plates_of(const Options &o) {
  Plates plates;
  if (o.restart) {
    const std::string name = "metal in " + o.restart->file.string();
    const std::string_view all = o.restart->metal_toml;
    for (const std::string &text : metal_texts(all.substr(0, all.find(mark_of(next_projectile))), next_plate))
      plates.push_back(materials::parse(text, name));
    if (plates.size() == 1) plates.resize(materials_of(o).size(), plates.front());
  } else {
    const char *origin = o.layer_materials.empty() ? "--material" : "--layer-materials";
    for (const std::string &material : materials_of(o))
      plates.push_back(materials::find_metal(material, o.model, origin));
  }
  for (AnyMetal &any : plates)
    std::visit(
        [&](auto &metal) {
          metal.eos.law = o.pressure;
          metal.damage.law = o.damage;
          metal.damage.effect = o.failure;
          metal.damage.softening = o.damage_softening;
          metal.shear_band.onset_ratio = o.band_onset;
        },
        any);
  return plates;
}

Plates projectile_metals_of(const Options &o) {
  const auto names = part_materials(o);
  const bool of_file = std::any_of(names.begin(), names.end(), is_material_file);
  Plates metals;
  if (o.restart && of_file) {
    const std::string where = "metal in " + o.restart->file.string();
    const std::string_view all = o.restart->metal_toml;
    const std::size_t at = all.find(mark_of(next_projectile));
    for (const std::string &text : metal_texts(at == std::string::npos ? "" : all.substr(at + 1), next_part))
      metals.push_back(materials::parse(text, where));
    if (metals.size() != names.size()) refuse(where, std::to_string(metals.size()), "must be one for each part");
  } else {
    for (const std::string &name : names)
      metals.push_back(
          materials::find_metal(name, o.model, name == o.projectile_metal ? "--projectile-metal" : "--part-metals"));
  }
  // A projectile's hexes do not fail.
  for (AnyMetal &metal : metals)
    std::visit([](auto &any) { any.damage.law = DamageLaw::none, any.damage.effect = FailureEffect::none; }, metal);
  return metals;
}

/// Those with a flow law of their own first: the others get the same.
void settle_materials(Options &o, const Origins &origins) {
  bool is_model_fixed = false;
  for (const bool files : {true, false})
    for (const std::string &material : materials_of(o))
      if (materials::has_own_model(material) == files)
        settle_material(o, material, std::exchange(is_model_fixed, true), origins);
  if (is_material_file(o.projectile_metal))
    materials::find_metal(o.projectile_metal, o.model, origin_of(origins, "projectile_metal"));
  for (const std::string &entry : o.part_metals)
    if (const PartMetal part = part_metal_of(entry); is_material_file(part.metal))
      materials::find_metal(part.metal, o.model, origin_of(origins, "part_metals") + ", " + part.part);
}

std::vector<std::string> doubts_of(const Options &o, const Plates &plates) {
  std::vector<std::string> all;
  if (o.velocity_mps > fastest_deformable_mps && !o.rigid)
    all.push_back("velocity_mps = " + options::shortest(o.velocity_mps) + ": above " +
                  options::shortest(fastest_deformable_mps) + " m/s a deformable projectile may stop the run");
  const auto add = [&](std::vector<std::string> doubts) {
    for (std::string &doubt : doubts)
      if (std::find(all.begin(), all.end(), doubt) == all.end()) all.push_back(std::move(doubt));
  };
  for (const AnyMetal &metal : plates) {
    add(materials::doubts_of_flow(metal));
    if (o.damage == DamageLaw::johnson_cook) add(materials::doubts_of_damage(metal));
    if (o.damage == DamageLaw::none && o.method == Method::stabilised && !has(metal, materials::Group::strain))
      add({materials::name_of(metal) + ": has no D1 to D5, so that no damage grows and plugs are held too long"});
    if (o.band_onset > 0 && std::visit([](const auto &m) { return ogive::instability_strain(m, 1e4) < 0.01; }, metal))
      add({materials::name_of(metal) + ": its adiabatic flow stress falls from the first strain on, so that bands of "
                                       "shear form wherever it is sheared"});
    if (o.band_onset > 0 && std::visit([](const auto &m) { return ogive::thermal_diffusivity(m) == 0; }, metal))
      add({materials::name_of(metal) +
           ": has no specific heat or no thermal_conductivity_W_per_mK, so that no bands of "
           "shear form and plugs are held too long"});
  }
  if (std::string outside = outside_tested_range(o); !outside.empty()) all.push_back(std::move(outside));
  return all;
}

std::string metals_text(const Options &o, const Plates &plates) {
  std::string text = materials::to_toml(plates.front(), "");
  for (std::size_t k = 1; k < plates.size() && !o.layer_materials.empty(); ++k)
    text += materials::to_toml(plates[k], next_plate);
  const auto names = part_materials(o);
  if (std::none_of(names.begin(), names.end(), is_material_file)) return text;
  const char *comment = next_projectile;
  for (const AnyMetal &metal : projectile_metals_of(o))
    text += materials::to_toml(metal, std::exchange(comment, next_part));
  return text;
}

} // namespace shot
