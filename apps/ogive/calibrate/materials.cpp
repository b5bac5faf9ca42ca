// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "materials/material_file.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"

#include <cctype>
#include <set>

namespace calibrate {

namespace {

/// Names of the options without which there is no material.toml.
std::string missing_options(const Options &o) {
  std::string missing;
  const auto need = [&](bool there, const char *flag) {
    if (!there) missing += (missing.empty() ? "" : ", ") + std::string(flag);
  };
  need(o.young_GPa.has_value(), "--young-GPa");
  need(o.poisson.has_value(), "--poisson");
  need(o.density_kg_per_m3.has_value(), "--density-kg-per-m3");
  need(o.specific_heat_J_per_kgK.has_value(), "--specific-heat-J-per-kgK");
  return missing;
}

template <class Law>
materials::AnyMetal metal_with(const Options &o, Law flow, const std::string &name, const std::string &method) {
  ogive::Metal<double, Law> m;
  m.name = name.substr(0, 80);
  m.source = std::string("ogive calibrate ") + ogive::version + ", " + method + ", from";
  for (const auto &file : o.data) m.source += " " + options::printable(file.filename().string());
  m.source.resize(std::min<std::size_t>(m.source.size(), 2000));
  m.density = *o.density_kg_per_m3;
  m.elasticity = {*o.young_GPa * 1e9, *o.poisson};
  m.flow = flow;
  m.specific_heat = *o.specific_heat_J_per_kgK;
  m.taylor_quinney = o.beta;
  m.room_temperature = o.room_K;
  m.melting_temperature = *o.melting_K;
  return m;
}

/// Writes the metal with hardening `h`. Returns why it is left out, if it is.
std::string write_material(const Options &o, const std::string &file, const ogive::Calibration &c, std::size_t h,
                           const char *method) {
  const std::string name = o.name + (c.hardenings.size() > 1 ? " " + c.hardenings[h] : "");
  const auto metal = c.frame.form == ogive::FlowForm::modified
                         ? metal_with(o, modified_law(c.hardening[h], c.C, c.b), name, method)
                         : metal_with(o, classical_law(c.frame, c.hardening[h], c.C, c.b), name, method);
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

/// A plate's name as part of a file's name.
std::string file_part(std::string plate) {
  for (char &c : plate)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  return plate;
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
