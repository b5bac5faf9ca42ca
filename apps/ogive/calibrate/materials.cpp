// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "materials/material_file.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"

#include <set>

namespace calibrate {

namespace {

/// Names of the options without which there is no material.toml.
std::string missing_options(const Options &o) {
  std::vector<std::string> missing;
  if (!o.young_GPa) missing.emplace_back("--young-GPa");
  if (!o.poisson) missing.emplace_back("--poisson");
  if (!o.density_kg_per_m3) missing.emplace_back("--density-kg-per-m3");
  if (!o.specific_heat_J_per_kgK) missing.emplace_back("--specific-heat-J-per-kgK");
  return options::joined(missing);
}

template <class Law>
materials::AnyMetal metal_with(const Options &o, const Law &flow, const std::string &name, const std::string &method) {
  ogive::Metal<double, Law> m;
  m.name = name.substr(0, 80);
  m.source = std::string("ogive calibrate ") + ogive::version + ", " + method + ", from";
  for (const auto &file : o.data) m.source += " " + options::printable(file.filename().string());
  m.source.resize(std::min<std::size_t>(m.source.size(), 2000));
  m.density = *o.density_kg_per_m3;
  m.elasticity = {*o.young_GPa * 1e9, *o.poisson};
  m.flow = flow;
  m.specific_heat = *o.specific_heat_J_per_kgK;
  m.thermal_conductivity = o.thermal_conductivity_W_per_mK;
  m.taylor_quinney = o.beta;
  m.room_temperature = o.room_K;
  m.melting_temperature = *o.melting_K;
  return m;
}

/// Writes the metal with hardening `h`. Returns why it is left out, if it is.
std::string write_material(const Options &o, const std::string &file, const ogive::Calibration &c, std::size_t h,
                           const char *method) {
  const std::string name = o.name + (c.hardenings.size() > 1 ? " " + c.hardenings[h] : "");
  const auto metal = with_law(c, h, [&](const auto &law) { return metal_with(o, law, name, method); });
  const std::string text = materials::to_toml(metal, "Written by ogive calibrate; fit.json beside it holds the "
                                                     "uncertainties.");
  try {
    materials::parse(text, file);
  } catch (const ogive::SetupError &error) {
    return error.what();
  }
  ogive::write_atomically(o.out / file, text);
  return "";
}

} // namespace

std::string write_materials(const Options &o, const Results &r) {
  // A metal of an earlier calibration must not lie beside the new numbers.
  std::error_code ignored;
  for (const char *name : {"material.toml", "material_simultaneous.toml"})
    std::filesystem::remove(o.out / name, ignored);
  if (const std::string missing = missing_options(o); !missing.empty())
    return "material.toml: it also needs " + missing;
  const char *const steps = "three steps of Liu et al. 2012";
  const auto &law = r.chosen.steps.law;
  std::string left_out = write_material(o, "material.toml", law, 0, steps);
  const auto &plates = law.hardenings;
  std::set<std::string> used;
  for (std::size_t h = 0; plates.size() > 1 && h < plates.size() && left_out.empty(); ++h) {
    std::string part = file_part(plates[h]);
    if (!used.insert(part).second) part += "_" + std::to_string(h + 1);
    left_out = write_material(o, "material_" + part + ".toml", law, h, steps);
  }
  if (left_out.empty() && r.chosen.simultaneous)
    left_out = write_material(o, "material_simultaneous.toml", r.chosen.simultaneous->law, 0, "all parameters at once");
  return left_out;
}

} // namespace calibrate
