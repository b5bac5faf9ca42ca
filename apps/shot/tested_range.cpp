// SPDX-License-Identifier: BSD-3-Clause
#include "tested_range.hpp"

#include "materials/library.hpp"
#include "named_projectile.hpp"
#include "plates.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace shot {

namespace {

struct Range {
  double low, high;
};

constexpr Range calibres_mm{6.17, 20};
constexpr Range thicknesses_in_calibres{0.3, 4.2};
constexpr Range distances_mm{0.45, 1};            // of particles
constexpr Range distances_of_blunt_mm{0.45, 0.8}; // limits of flat noses fall with them
constexpr Range velocities_mps{145, 730};         // from the lowest limit to the fastest measured shot
constexpr Range obliquities_deg{0, 30};
constexpr std::array<std::string_view, 6> metals{"weldox_460e",      "weldox_700e",    "aa5083_h116",
                                                 "aa5083_h116_25mm", "aa6061_t651_jc", "aa6082_t6"};

} // namespace

std::string outside_tested_range(const Options &o) {
  std::vector<std::string> all;
  const auto within = [&](const char *name, double value, const Range &range) {
    constexpr double slack = 1e-9;
    if (value < range.low * (1 - slack) || value > range.high * (1 + slack))
      all.push_back(options::printed("%s (tests: %g to %g)", name, range.low, range.high));
  };
  within("diameter_mm", o.diameter_mm, calibres_mm);
  within("thickness over diameter", o.thickness_mm / o.diameter_mm, thicknesses_in_calibres);
  const bool is_flat = o.nose == Nose::blunt && o.profile_mm.empty() && !o.own_mesh.read;
  within("spacing_mm", o.spacing_mm, is_flat ? distances_of_blunt_mm : distances_mm);
  within("velocity_mps", o.velocity_mps, velocities_mps);
  within("obliquity_deg", o.obliquity_deg, obliquities_deg);
  if (o.pitch_deg != 0 || o.yaw_deg != 0) all.emplace_back("pitch or yaw (tests: none)");
  if (o.layers_mm.size() > 1) all.emplace_back("several plates (tests: one)");
  if (o.nose == Nose::sphere) all.emplace_back("nose sphere");
  if (o.bore_depth_mm > 0) all.emplace_back("a hollow projectile");
  if (!o.profile_mm.empty() || o.own_mesh.read)
    all.push_back(is_library_projectile(o.projectile) ? "projectile " + o.projectile : "a projectile of your own");
  for (const std::string &material : materials_of(o)) {
    const std::string metal = materials::label_of(material);
    const bool known = std::find(metals.begin(), metals.end(), metal) != metals.end();
    // The metal of the worked cases is a file; all others are of the library.
    const bool compared = known && materials::is_material_file(material) == (metal == "aa6061_t651_jc");
    if (!compared) all.push_back("metal " + metal + (known ? " of another source" : ""));
  }
  std::string text;
  for (auto one = all.begin(); one != all.end(); ++one)
    if (std::find(all.begin(), one, *one) == one) text += (text.empty() ? "" : "; ") + *one;
  return text.empty() ? "" : "outside of what was compared with tests: " + text;
}

} // namespace shot
