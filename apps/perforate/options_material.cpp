// SPDX-License-Identifier: BSD-3-Clause
#include "options_material.hpp"

#include "ogive/material/library.hpp"
#include "options_table.hpp"

namespace perforate {

namespace {

using input::broken;
using material_file::AnyMetal;
using material_file::Group;
using material_file::Key;
namespace library = ogive::library;

AnyMetal weldox_460e(FlowModel model) {
  if (model == FlowModel::jc) return library::weldox_460e_jc<double>();
  return library::weldox_460e_mjc<double>();
}

AnyMetal aa5083_h116(FlowModel model) {
  if (model == FlowModel::jc) return library::aa5083_h116_jc<double>();
  return library::aa5083_h116_mjc<double>();
}

/// The classical law has no constants of its own for the weaker plate.
AnyMetal aa5083_h116_25mm(FlowModel model) {
  if (model == FlowModel::jc) return aa5083_h116(model);
  return library::aa5083_h116_mjc<double>(0.85);
}

constexpr auto metals = std::to_array<LibraryMetal>({{"weldox_460e", "Weldox 460 E", 0.08, weldox_460e},
                                                     {"aa5083_h116", "AA5083-H116", 0.02, aa5083_h116},
                                                     {"aa5083_h116_25mm", "AA5083-H116", 0.02, aa5083_h116_25mm}});

/// A metal with the name that the user knows it by.
AnyMetal made(const LibraryMetal &entry, FlowModel model) {
  AnyMetal any = entry.make(model);
  std::visit([&](auto &metal) { metal.name = entry.name; }, any);
  return any;
}

/// The comment between the metals of two plates.
constexpr char next_plate[] = "next plate";

/// The metals of metals_text(), one by one.
std::vector<std::string> metal_texts(std::string_view all) {
  const std::string mark = "\n# " + std::string(next_plate) + "\n";
  std::vector<std::string> texts;
  for (std::size_t end = all.find(mark); end != std::string_view::npos; end = all.find(mark)) {
    texts.emplace_back(all.substr(0, end + 1));
    all.remove_prefix(end + 1);
  }
  texts.emplace_back(all);
  return texts;
}

/// The constants of a group, or of all but damage.
template <class M> std::string constants(const M &metal, std::initializer_list<Group> groups) {
  std::string text;
  material_file::for_each_key(metal, [&]<class V>(const Key &key, const V &value) {
    if (std::find(groups.begin(), groups.end(), key.group) == groups.end() || !has(metal, key.group)) return;
    if constexpr (!std::is_same_v<V, std::string> && !std::is_same_v<V, FlowModel>)
      text += (text.empty() ? "" : ", ") + std::string(key.name) + "=" + material_file::text_of(key, value);
  });
  return text;
}

template <class M> std::string described(const M &metal, const std::string &title) {
  std::string text = broken("  " + title + ": ", metal.source, 4);
  text += broken("    ", constants(metal, {Group::always, Group::shock}), 4);
  const std::string damage = constants(metal, {Group::strain, Group::work});
  return text + broken("    ", damage.empty() ? "no constants for --damage" : "for --damage: " + damage, 4);
}

} // namespace

const LibraryMetal *find_library_metal(std::string_view name) {
  for (const LibraryMetal &metal : metals)
    if (metal.name == name) return &metal;
  return nullptr;
}

bool is_material_file(std::string_view material) { return material.ends_with(".toml"); }

std::string allowed_materials() { return "one of " + input::names_in(metals) + ", or a file that ends in .toml"; }

std::string label_of(const std::string &material) {
  return is_material_file(material) ? std::filesystem::path(material).stem().string() : material;
}

double default_friction(Nose nose, const std::string &material) {
  if (nose == Nose::blunt) return 0;
  const LibraryMetal *metal = find_library_metal(material);
  return metal == nullptr ? 0.08 : metal->sharp_friction;
}

AnyMetal read_metal(const Options &o, const std::string &material, const std::string &origin) {
  const LibraryMetal *metal = find_library_metal(material);
  return metal == nullptr ? material_file::read(material, origin) : made(*metal, o.model);
}

AnyMetal read_metal(const Options &o, const std::string &origin) { return read_metal(o, o.material, origin); }

std::vector<std::string> materials_of(const Options &o) {
  if (!o.layer_materials.empty()) return o.layer_materials;
  return std::vector(std::max<std::size_t>(1, o.layers_mm.size()), o.material);
}

std::vector<AnyMetal> plates_of(const Options &o) {
  std::vector<AnyMetal> plates;
  if (o.restart) {
    const std::string name = "metal in " + o.restart->file.string();
    for (const std::string &text : metal_texts(o.restart->metal_toml))
      plates.push_back(material_file::parse(text, name));
    if (plates.size() == 1) plates.resize(materials_of(o).size(), plates.front());
  } else {
    const char *origin = o.layer_materials.empty() ? "--material" : "--layer-materials";
    for (const std::string &material : materials_of(o)) plates.push_back(read_metal(o, material, origin));
  }
  for (AnyMetal &any : plates)
    std::visit(
        [&](auto &metal) {
          metal.eos.law = o.pressure;
          metal.damage.law = o.damage;
          metal.damage.effect = o.failure;
          metal.damage.softening = o.damage_softening;
          metal.damage.length = o.damage_length_mm ? *o.damage_length_mm * 1e-3 : metal.damage.shear_length;
          metal.damage.length_exponent = o.damage_length_exponent;
          metal.damage.length_scope = o.damage_length_scope;
        },
        any);
  return plates;
}

AnyMetal plate_of(const Options &o) { return plates_of(o).front(); }

std::string metals_text(const Options &o, const std::vector<AnyMetal> &plates) {
  std::string text = material_file::to_toml(plates.front(), "");
  for (std::size_t k = 1; k < plates.size() && !o.layer_materials.empty(); ++k)
    text += material_file::to_toml(plates[k], next_plate);
  return text;
}

std::string library_list() {
  std::string text =
      "Metals for --material. A file of your own has the same names: change a copy of the material.toml\n"
      "that lies beside the results of a run. Damage is off unless --damage chooses it.\n";
  for (const LibraryMetal &entry : metals) {
    text += "\n" + std::string(entry.name) + "\n";
    for (const auto &model : material_file::models)
      text += std::visit([&](const auto &metal) { return described(metal, std::string(model.name)); },
                         made(entry, model.value));
  }
  const auto projectile = library::arne_tool_steel<double>();
  return text + "\n" + projectile.name + ", of the projectiles, not for --material\n" +
         described(projectile, "bilinear");
}

} // namespace perforate
