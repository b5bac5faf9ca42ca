// SPDX-License-Identifier: BSD-3-Clause
#include "title.hpp"

#include "materials/library.hpp"
#include "named_projectile.hpp"
#include "options/text.hpp"

#include <nlohmann/json.hpp>

namespace shot {

namespace {

/// The names of the trade of metals with " + " between them; files have the name that they give.
std::string metals_title(const std::string &names) {
  const std::string plus = " + ";
  std::string title;
  for (std::size_t at = 0; at <= names.size();) {
    const std::size_t end = std::min(names.find(plus, at), names.size());
    const std::string name = names.substr(at, end - at);
    const auto *metal = materials::find_library_metal(name);
    title += (at == 0 ? "" : plus) + (metal == nullptr ? name : std::string(metal->title));
    at = end + plus.size();
  }
  return title;
}

std::string projectile_text(const std::string &name, const std::string &nose) {
  if (name != nose) return projectile_title(name);
  const bool is_whole = nose == "sphere" || nose == "profile" || nose == "mesh";
  return is_whole ? nose : nose + " nose";
}

} // namespace

std::string title_of(const nlohmann::ordered_json &summary) {
  const auto text = [&](const char *key) { return summary.at(key).get<std::string>(); };
  const auto shown = [](const nlohmann::ordered_json &number) { return options::shortest(number.get<double>()); };
  std::string sizes = shown(summary.at("thickness_mm")) + " mm";
  if (summary.contains("layers")) {
    std::string thicknesses, gaps;
    bool apart = false;
    for (const auto &layer : summary["layers"]) {
      const bool first = thicknesses.empty();
      thicknesses += (first ? "" : " + ") + shown(layer.at("thickness_mm"));
      if (first) continue;
      gaps += (gaps.empty() ? "" : ", ") + shown(layer.at("gap_before_mm"));
      apart = apart || layer.at("gap_before_mm").get<double>() > 0;
    }
    sizes = thicknesses + " mm" + (apart ? ", " + gaps + " mm apart" : "");
  }
  const bool oblique = summary.at("obliquity_deg").get<double>() != 0;
  return metals_title(text("material")) + ", " + materials::title_of_model(text("model")) + ", " +
         projectile_text(text("projectile_name"), text("nose")) + ", " + sizes + ", " +
         shown(summary.at("initial_velocity_mps")) + " m/s" +
         (oblique ? " at " + shown(summary.at("obliquity_deg")) + " deg" : "") + ", method " + text("method");
}

} // namespace shot
