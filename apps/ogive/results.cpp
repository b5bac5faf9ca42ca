// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "materials/library.hpp"
#include "options/text.hpp"
#include "shot/table.hpp"
#include "study/row.hpp"

#include <nlohmann/json.hpp>

namespace commands {

namespace fs = std::filesystem;
using options::refuse;

std::string folder_name(const fs::path &file) {
  return fs::absolute(file).lexically_normal().parent_path().filename().string();
}

fs::path find_pvd(const fs::path &given, const char *flag) {
  std::error_code ignored;
  if (!fs::is_directory(given, ignored)) return given;
  std::vector<fs::path> found;
  for (const auto &entry : fs::directory_iterator(given, ignored))
    if (entry.path().extension() == ".pvd") found.push_back(entry.path());
  if (found.size() != 1)
    refuse(flag, given.string(),
           found.empty() ? "must be a folder with a .pvd file, or a .pvd file"
                         : "must be a folder with one .pvd file, or the one that is meant");
  return found.front();
}

void add_extent(options::Table &table, std::optional<ogive::Extent> &extent) {
  const options::Entry entry{.key = "extent",
                             .meaning = "of results whose files lack it: quarter, half or full",
                             .allowed = "one of quarter, half, full"};
  add_option(table, entry, options::Kind::choice, "NAME").assign = [&extent](const options::Given &given) {
    extent = choice_given(given, choices(ogive::Extent{}));
  };
}

std::optional<ogive::SymmetryPlanes> symmetry_of(const std::optional<ogive::Extent> &extent) {
  return extent ? std::optional(ogive::symmetry_planes(*extent)) : std::nullopt;
}

std::string case_title(const fs::path &folder) {
  try {
    const auto summary = study::read_summary(folder);
    const auto text = [&](const char *key) { return summary.at(key).get<std::string>(); };
    const auto number = [&](const char *key) { return options::shortest(summary.at(key).get<double>()); };
    const auto *metal = materials::find_library_metal(text("material"));
    const bool oblique = summary.at("obliquity_deg").get<double>() != 0;
    std::vector<double> layers_mm;
    if (summary.contains("layers"))
      for (const auto &layer : summary["layers"]) layers_mm.push_back(layer.at("thickness_mm").get<double>());
    return (metal ? std::string(metal->title) : text("material")) + ", " +
           summary.value("projectile_name", text("nose")) + ", " +
           (layers_mm.empty() ? number("thickness_mm") : options::joined(layers_mm, " + ")) + " mm, " +
           number("initial_velocity_mps") + " m/s" + (oblique ? " at " + number("obliquity_deg") + " deg" : "") +
           ", " + text("method");
  } catch (const std::exception &) {
    return folder_name(folder / "file");
  }
}

} // namespace commands
