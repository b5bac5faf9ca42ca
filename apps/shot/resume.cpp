// SPDX-License-Identifier: BSD-3-Clause
#include "resume.hpp"

#include "materials/library.hpp"
#include "ogive/version.hpp"
#include "options/toml_file.hpp"
#include "plates.hpp"
#include "saved_case.hpp"
#include "table.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace shot {

namespace {

using options::Given;
using options::refuse;

/// The options that a run may change when it resumes: nothing in the physics depends on them.
constexpr std::array<std::string_view, 8> changeable{"end_us", "out",     "output_every_us", "checkpoint_every_us",
                                                     "vtk",    "picture", "quiet",           "threads"};

bool is_changeable(const std::string &key) {
  return std::find(changeable.begin(), changeable.end(), key) != changeable.end();
}

/// The options of a checkpoint.
Options options_in(const SavedCase &saved, const std::filesystem::path &file) {
  Options o;
  const options::Table table = table_of(o);
  options::Origins origins;
  for (const Given &given : options::entries_of(table, saved.case_toml, "case in " + file.string(), toml_example))
    options::apply(table, origins, given);
  o.out = file.has_parent_path() ? file.parent_path() : ".";
  if (!o.layers_mm.empty()) o.thickness_mm = std::accumulate(o.layers_mm.begin(), o.layers_mm.end(), 0.0);
  o.restart = {file, saved.metal_toml, saved.time_us};
  if (!o.projectile_mesh.empty()) {
    o.projectile_mesh = (o.out / mesh_copy_name(o.projectile_mesh)).string();
    o.own_mesh = read_own_mesh(o.projectile_mesh, o.mesh_unit, o.extent, o.parts, "mesh of " + file.string());
  }
  return o;
}

} // namespace

Options restarted(const std::string &name, const std::vector<Given> &all) {
  std::string flags;
  for (const auto key : changeable) flags += (flags.empty() ? "" : ", ") + options::flag_of(key);
  for (const Given &given : all)
    if (!is_changeable(given.key)) refuse(given, "the case is that of --restart; only these may be given: " + flags);

  const std::filesystem::path file = name;
  const SavedCase saved = read_saved_case(file);
  Options o = options_in(saved, file);
  options::Origins origins;
  for (const Given &given : all) options::apply(table_of(o), origins, given);
  check(o, origins);
  if (origins.contains("end_us") && o.end_us < saved.time_us)
    refuse("--end-us", options::shortest(o.end_us),
           "must not lie before the time of the checkpoint, " + options::shortest(saved.time_us) + " us");
  return o;
}

Resumed resumed(const Options &options) {
  const auto file = options.out / checkpoint_name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {options};
  const bool has_ended = std::filesystem::exists(options.out / "summary.json", ignored);
  const auto unless_ended = [&](const std::string &obstacle) { return Resumed{options, has_ended ? "" : obstacle}; };
  try {
    const SavedCase saved = read_saved_case(file);
    Options left = options_in(saved, file);
    if (has_ended && saved.time_us < left.end_us * (1 - 1e-9)) return {options};
    if (saved.version != ogive::version) return unless_ended("it is of ogive " + saved.version);
    if (saved.metal_toml != metals_text(options, plates_of(options))) return unless_ended("it is of another metal");
    if (options.end_us < saved.time_us)
      return unless_ended("its time, " + options::shortest(saved.time_us) + " us, is after --end-us");
    if (has_ended && options.end_us <= saved.time_us) return {options};
    const auto restart = std::exchange(left.restart, std::nullopt);
    left.out = options.out;
    left.projectile_mesh = options.projectile_mesh; // the mesh itself is compared
    left.end_us = options.end_us;
    left.checkpoint_every_us = options.checkpoint_every_us;
    left.picture = options.picture;
    left.quiet = options.quiet;
    left.threads = options.threads;
    if (left != options) {
      Options mine = options;
      const auto here = table_of(mine).options, there = table_of(left).options;
      for (std::size_t k = 0; k < here.size(); ++k)
        if (here[k].toml() != there[k].toml())
          return unless_ended("it is of a run with another " + options::flag_of(here[k].key));
      return unless_ended("it is of another case");
    }
    left.restart = restart;
    return {left};
  } catch (const ogive::SetupError &error) {
    return unless_ended(error.what());
  }
}

std::vector<std::pair<std::string, std::string>> case_values(const Options &options) {
  Options o = options;
  std::vector<std::pair<std::string, std::string>> values;
  for (const options::Option &option : table_of(o).options) {
    const std::string_view key = option.key;
    const bool of_metal =
        key == "material" || key == "layer_materials" || key == "projectile_metal" || key == "part_metals";
    const bool of_file = key == "profile" || key == "projectile_mesh" ||
                         (key == "projectile" && materials::is_material_file(o.projectile));
    const bool counts = key == "settle_us" || option.group != run_group;
    if (counts && !of_metal && !of_file) values.emplace_back(key, option.toml());
  }
  return values;
}

std::string all_metals_text(const Options &options) {
  std::string text = metals_text(options, plates_of(options));
  for (const auto &metal : projectile_metals_of(options)) text += materials::to_toml(metal, "");
  return text;
}

std::optional<std::string> other_case(const Options &options) {
  const auto file = options.out / "case.toml";
  try {
    Options theirs;
    const auto entries =
        options::entries_of(table_of(theirs), options::text_of_file(file, "case"), file.string(), toml_example);
    theirs = settled({{entries, options.out}});
    const auto there = case_values(theirs);
    for (const auto &[key, value] : case_values(options)) {
      const auto other =
          std::find_if(there.begin(), there.end(), [&name = key](const auto &one) { return one.first == name; });
      if (other != there.end() && other->second != value) return key;
    }
    if (metals_text(options, plates_of(options)) != metals_text(theirs, plates_of(theirs))) return "material";
    if (options.own_mesh != theirs.own_mesh) return "projectile_mesh";
    return all_metals_text(options) == all_metals_text(theirs) ? "" : "projectile_metal";
  } catch (const ogive::SetupError &) {
    return std::nullopt;
  }
}

} // namespace shot
