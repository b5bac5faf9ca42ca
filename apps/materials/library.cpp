// SPDX-License-Identifier: BSD-3-Clause
#include "library.hpp"

#include "material_keys.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/projectile_metals.hpp"

namespace materials {

namespace {

using options::broken;
namespace library = ogive::library;

AnyMetal weldox_460e(Model model) {
  return model == Model::jc ? AnyMetal(library::weldox_460e_jc<double>()) : library::weldox_460e_mjc<double>();
}

AnyMetal aa5083_h116(Model model) {
  return model == Model::jc ? AnyMetal(library::aa5083_h116_jc<double>()) : library::aa5083_h116_mjc<double>();
}

/// The classical law has no constants of its own for the weaker plate.
AnyMetal aa5083_h116_25mm(Model model) {
  return model == Model::jc ? aa5083_h116(model) : library::aa5083_h116_mjc<double>(0.85);
}

constexpr auto metals = std::to_array<LibraryMetal>({{"weldox_460e", "Weldox 460 E", 0.08, weldox_460e},
                                                     {"aa5083_h116", "AA5083-H116", 0.02, aa5083_h116},
                                                     {"aa5083_h116_25mm", "AA5083-H116", 0.02, aa5083_h116_25mm}});

/// The steels of the projectiles.
std::vector<ogive::Metal<double, ogive::Bilinear<double>>> projectile_metals() {
  return {library::arne_tool_steel<double>(), library::apm2_core_steel<double>(), library::fsp_steel<double>()};
}

/// A metal with the name that the user knows it by.
AnyMetal made(const LibraryMetal &entry, Model model) {
  AnyMetal any = entry.make(model);
  std::visit([&](auto &metal) { metal.name = entry.name; }, any);
  return any;
}

/// The constants of a group, or of all but damage.
template <class M> std::string constants(const M &metal, std::initializer_list<Group> groups) {
  std::vector<std::string> texts;
  for_each_key(metal, [&]<class V>(const Key &key, const V &value) {
    if (std::find(groups.begin(), groups.end(), key.group) == groups.end() || !has(metal, key.group)) return;
    if constexpr (!std::is_same_v<V, std::string> && !std::is_same_v<V, Model>)
      texts.push_back(std::string(key.name) + "=" + text_of(key, value));
  });
  return options::joined(texts);
}

template <class M> std::string described(const M &metal, const std::string &title) {
  std::string text = broken("  " + title + ": ", metal.source, 4);
  text += broken("    ", constants(metal, {Group::always, Group::shock}), 4);
  const std::string damage = constants(metal, {Group::strain, Group::work});
  return text + broken("    ", damage.empty() ? "no constants of damage" : "damage: " + damage, 4);
}

} // namespace

const LibraryMetal *find_library_metal(std::string_view name) {
  for (const LibraryMetal &metal : metals)
    if (metal.name == name) return &metal;
  return nullptr;
}

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  for (const LibraryMetal &metal : metals) names.emplace_back(metal.name);
  return names;
}

bool is_material_file(std::string_view material) { return material.ends_with(".toml"); }

std::vector<std::string> projectile_metal_names() {
  std::vector<std::string> names;
  for (const auto &steel : projectile_metals()) names.push_back(steel.name);
  return names;
}

std::string allowed_projectile_metals() {
  return "one of " + options::joined(projectile_metal_names()) + ", " + options::names_in(metals) +
         ", or a file that ends in .toml";
}

std::string allowed_materials() { return "one of " + options::names_in(metals) + ", or a file that ends in .toml"; }

std::string label_of(const std::string &material) {
  return is_material_file(material) ? std::filesystem::path(material).stem().string() : material;
}

AnyMetal find_metal(const std::string &material, Model model, const std::string &origin) {
  const LibraryMetal *metal = find_library_metal(material);
  if (metal != nullptr) return made(*metal, model);
  for (const auto &steel : projectile_metals())
    if (steel.name == material) return steel;
  return read(material, origin);
}

std::string described(const AnyMetal &any) {
  return std::visit([&](const auto &metal) { return described(metal, name_of(model_of(any))); }, any);
}

std::string library_list() {
  std::string text =
      "Metals for --material. A file of your own has the same keys: change a copy of the material.toml in a\n"
      "folder of results. Damage is off unless --damage or --method chooses it.\n";
  for (const LibraryMetal &entry : metals) {
    text += "\n" + std::string(entry.name) + "\n";
    for (const auto &model : models)
      if (const AnyMetal metal = made(entry, model.value); model_of(metal) == model.value) text += described(metal);
  }
  for (const auto &steel : projectile_metals())
    text += "\n" + steel.name + ", for --projectile-metal\n" + described(steel, "bilinear");
  return text;
}

} // namespace materials
