// SPDX-License-Identifier: BSD-3-Clause
#include "options_layers.hpp"

#include "options_material.hpp"

#include <numeric>

namespace perforate {

std::string material_label(const Options &o) {
  std::vector<std::string> labels;
  for (const std::string &material : o.layer_materials) labels.push_back(label_of(material));
  return labels.empty() ? label_of(o.material) : joined(labels, "+");
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
  const auto refuse_list = [&](const char *key, const auto &list, const std::string &allowed) {
    refuse(origin_of(origins, key), joined(list, ","), allowed);
  };
  const std::size_t count = o.layers_mm.size();
  if (!origins.contains("layers_mm")) {
    if (!o.gaps_mm.empty()) refuse_list("gaps_mm", o.gaps_mm, "needs --layers-mm");
    if (!o.layer_materials.empty()) refuse_list("layer_materials", o.layer_materials, "needs --layers-mm");
    return;
  }
  if (count < 1 || count > ogive::most_layers)
    refuse_list("layers_mm", o.layers_mm, "must be 1 to " + std::to_string(ogive::most_layers) + " thicknesses");
  if (origins.contains("thickness_mm"))
    refuse_list("layers_mm", o.layers_mm, "contradicts thickness_mm: give one of them");

  const std::size_t gaps = count - 1;
  if (o.gaps_mm.size() == 1 && gaps > 0) o.gaps_mm.resize(gaps, o.gaps_mm.front());
  if (!origins.contains("gaps_mm")) o.gaps_mm.assign(gaps, 0);
  if (o.gaps_mm.size() != gaps)
    refuse_list("gaps_mm", o.gaps_mm,
                gaps == 0
                    ? "needs --layers-mm with at least 2 thicknesses"
                    : "must be 1 number, or " + std::to_string(gaps) + " between " + std::to_string(count) + " plates");
  if (origins.contains("layer_materials")) {
    if (o.layer_materials.size() != count)
      refuse_list("layer_materials", o.layer_materials,
                  "must be " + std::to_string(count) + ", one for each plate of --layers-mm");
    if (origins.contains("material"))
      refuse_list("layer_materials", o.layer_materials, "contradicts material: give one of them");
    o.material = o.layer_materials.front();
    if (std::all_of(o.layer_materials.begin(), o.layer_materials.end(),
                    [&](const std::string &material) { return material == o.material; }))
      o.layer_materials.clear();
  }
  o.thickness_mm = std::accumulate(o.layers_mm.begin(), o.layers_mm.end(), 0.0);
  if (count == 1) o.layers_mm.clear(), o.gaps_mm.clear();
}

} // namespace perforate
