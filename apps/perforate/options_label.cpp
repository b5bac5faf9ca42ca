// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "options_layers.hpp"
#include "options_projectile.hpp"
#include "options_table.hpp"

#include <cmath>
#include <string_view>
#include <type_traits>
#include <utility>

namespace perforate {

namespace {

/// A value in the name of a folder, numbers without the last digits of a conversion; nothing for lists, texts and
/// folders, which the name has already.
template <class V> std::string label(const V &value) {
  if constexpr (std::is_floating_point_v<V>)
    return shortest(std::round(value * 1e6) / 1e6);
  else if constexpr (std::is_same_v<V, std::optional<double>>)
    return value ? label(*value) : "";
  else if constexpr (std::is_enum_v<V>)
    return choice_name(value);
  else
    return "";
}

std::vector<std::pair<std::string, std::string>> labels(const Options &options) {
  std::vector<std::pair<std::string, std::string>> all;
  for_each_option(options, [&](const Entry &entry, const auto &value) {
    if (entry.group != std::string_view(run_group)) all.emplace_back(entry.key, label(value));
  });
  return all;
}

/// The case of which the folder's name says all before the differences.
Options usual(const Options &o) {
  Options usual;
  usual.material = o.material;
  usual.model = o.model;
  usual.method = o.method;
  usual.thickness_mm = o.thickness_mm;
  usual.nose = o.nose;
  usual.diameter_mm = o.diameter_mm;
  usual.velocity_mps = o.velocity_mps;
  usual.obliquity_deg = o.obliquity_deg;
  usual.damage = o.damage;
  take_defaults(usual, {{"damage", ""}});
  usual.damage = default_damage(o.method);
  usual.nose_length_mm = o.nose_length_mm;
  usual.length_mm = default_length_mm(usual);
  usual.nose_length_mm = default_nose_length_mm(usual);
  return usual;
}

/// "_key=value" of each option that makes the case another one than the usual.
std::string differences(const Options &o) {
  std::string text;
  const auto here = labels(o), there = labels(usual(o));
  for (std::size_t i = 0; i < here.size(); ++i)
    if (here[i] != there[i]) text += "_" + here[i].first + "=" + here[i].second;
  return text;
}

} // namespace

std::string thickness_label(const Options &o) {
  if (o.layers_mm.empty()) return shortest(o.thickness_mm) + "mm";
  const bool apart = std::any_of(o.gaps_mm.begin(), o.gaps_mm.end(), [](double gap) { return gap > 0; });
  const bool equal =
      apart && std::count(o.gaps_mm.begin(), o.gaps_mm.end(), o.gaps_mm.front()) == std::ssize(o.gaps_mm);
  return joined(o.layers_mm, "+") + "mm" +
         (!apart  ? ""
          : equal ? "_" + shortest(o.gaps_mm.front()) + "mm_apart"
                  : "_" + joined(o.gaps_mm, "+") + "mm_apart");
}

std::filesystem::path default_out(const Options &o) {
  return std::filesystem::path("vtk_out") /
         (material_label(o) + "_" + choice_name(o.model) + "_" + choice_name(o.nose) + "_" +
          (o.diameter_mm == Options{}.diameter_mm ? "" : shortest(o.diameter_mm) + "mm_on_") + thickness_label(o) +
          "_" + shortest(o.velocity_mps) + "mps" +
          (o.obliquity_deg == 0 ? "" : "_" + shortest(o.obliquity_deg) + "deg") +
          (o.method == Method::sfm ? "" : "_" + choice_name(o.method)) + differences(o));
}

std::string name_of(Method method) { return choice_name(method); }
std::string name_of(DamageLaw damage) { return choice_name(damage); }
std::string name_of(FailureEffect failure) { return choice_name(failure); }

} // namespace perforate
