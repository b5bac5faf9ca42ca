// SPDX-License-Identifier: BSD-3-Clause
#include "library.hpp"

#include "material_keys.hpp"
#include "options/data_folder.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/projectile_metals.hpp"

namespace materials {

namespace {

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

/// Coulomb friction of noses that are not blunt, by the paper: on steel, and on aluminium. Other metals have none that
/// is known; those heavier than aluminium get that of steel.
constexpr double steel = 0.08, aluminium = 0.02;

constexpr auto metals = std::to_array<LibraryMetal>({{"weldox_460e", "Weldox 460 E", steel, weldox_460e},
                                                     {"aa5083_h116", "AA5083-H116", aluminium, aa5083_h116},
                                                     {"aa5083_h116_25mm", "AA5083-H116", aluminium, aa5083_h116_25mm},
                                                     {"weldox_500e", "Weldox 500 E", steel},
                                                     {"weldox_700e", "Weldox 700 E", steel},
                                                     {"weldox_900e", "Weldox 900 E", steel},
                                                     {"hardox_400", "Hardox 400", steel},
                                                     {"armox_500t", "Armox 500T", steel},
                                                     {"armox_560t", "Armox 560T", steel},
                                                     {"domex_protect_500", "Domex Protect 500", steel},
                                                     {"mild_steel", "Mild steel", steel},
                                                     {"steel_1006", "Steel 1006", steel},
                                                     {"steel_4340", "Steel 4340", steel},
                                                     {"armco_iron", "Armco iron", steel},
                                                     {"aa2024_t351", "AA2024-T351", aluminium},
                                                     {"aa6061_t6", "AA6061-T6", aluminium},
                                                     {"aa6061_t651", "AA6061-T651", aluminium},
                                                     {"aa6082_t6", "AA6082-T6", aluminium},
                                                     {"aa7039", "AA7039", aluminium},
                                                     {"aa7075_t651", "AA7075-T651", aluminium},
                                                     {"ti_6al_4v", "Ti-6Al-4V", steel},
                                                     {"ofhc_copper", "OFHC copper", steel},
                                                     {"cartridge_brass", "Cartridge brass", steel},
                                                     {"gilding_metal", "Gilding metal", steel},
                                                     {"lead", "Lead", steel}});

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

/// "Johnson-Cook", "W_cr", both or a dash.
std::string damage_of(const AnyMetal &metal) {
  std::vector<std::string> laws;
  if (has(metal, Group::strain)) laws.emplace_back("D1-D5");
  if (has(metal, Group::work)) laws.emplace_back("W_cr");
  return laws.empty() ? "-" : options::joined(laws);
}

/// A row of the list.
std::string row(const std::string &name, const std::string &laws, const std::string &damage, const std::string &how) {
  const std::string start = options::printed("%-18s %-10s %-12s ", name.c_str(), laws.c_str(), damage.c_str());
  return options::broken(start, how, start.size());
}
std::string row(const AnyMetal &metal, const std::string &laws) {
  const std::string &how = std::visit([](const auto &any) -> const std::string & { return any.confidence; }, metal);
  return row(name_of(metal), laws, damage_of(metal), how.substr(0, how.find(':')));
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

bool has_own_model(std::string_view material) {
  const LibraryMetal *metal = find_library_metal(material);
  return metal == nullptr || metal->make == nullptr;
}

std::filesystem::path file_of(const LibraryMetal &metal) {
  return options::data_folder() / "metals" / (std::string(metal.name) + ".toml");
}

std::vector<std::string> projectile_metal_names() {
  std::vector<std::string> names;
  for (const auto &steel : projectile_metals()) names.push_back(steel.name);
  return names;
}

bool is_known(std::string_view material) {
  const auto steels = projectile_metals();
  return is_material_file(material) || find_library_metal(material) != nullptr ||
         std::any_of(steels.begin(), steels.end(), [&](const auto &one) { return one.name == material; });
}

std::string allowed_projectile_metals() {
  return "one of " + options::joined(projectile_metal_names()) + ", or " + allowed_materials();
}

std::string allowed_materials() { return "a metal that ogive materials lists, or a file that ends in .toml"; }

std::string label_of(const std::string &material) {
  return is_material_file(material) ? std::filesystem::path(material).stem().string() : material;
}

AnyMetal find_metal(const std::string &material, Model model, const std::string &origin) {
  const LibraryMetal *metal = find_library_metal(material);
  if (metal != nullptr) return metal->make == nullptr ? read(file_of(*metal), origin) : made(*metal, model);
  for (const auto &projectile : projectile_metals())
    if (projectile.name == material) return projectile;
  return read(material, origin);
}

std::string library_list() {
  std::string text =
      "Metals for --material. \"ogive materials show NAME\" prints constants and sources, as a file to copy.\n\n" +
      row("name", "flow law", "damage", "confidence");
  for (const LibraryMetal &entry : metals) {
    const AnyMetal metal = find_metal(std::string(entry.name), Model::mjc, "list");
    text += row(metal, entry.make == nullptr ? name_of(model_of(metal)) : "mjc, jc");
  }
  text += "\nSteels of projectiles, for --projectile-metal only; it takes all others as well:\n\n";
  for (const auto &projectile : projectile_metals()) text += row(projectile, name_of(Model::bilinear));
  return text + "\nWhat is from memory has low confidence: check it against its source before you rely on it.\n";
}

} // namespace materials
