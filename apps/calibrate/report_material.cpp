// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "shared/input.hpp"
#include "shared/material_file.hpp"

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

template <class Law> ogive::Metal<double, Law> metal_with(const Options &o, Law flow) {
  ogive::Metal<double, Law> m;
  m.density = *o.density_kg_per_m3;
  m.elasticity = {*o.young_GPa * 1e9, *o.poisson};
  m.flow = flow;
  m.specific_heat = *o.specific_heat_J_per_kgK;
  m.taylor_quinney = o.beta;
  m.room_temperature = o.room_K;
  m.melting_temperature = *o.melting_K;
  return m;
}

material_file::AnyMetal metal_of(const Options &o, const ogive::Calibration &c, std::size_t h,
                                 const std::string &method) {
  material_file::AnyMetal any;
  if (c.frame.form == ogive::FlowForm::modified)
    any = metal_with(o, modified_law(c.hardening[h], c.C, c.b));
  else
    any = metal_with(o, classical_law(c.frame, c.hardening[h], c.C, c.b));
  std::string source = std::string("calibrate ") + ogive::version + ", " + method + ", from";
  for (const auto &file : o.data) source += " " + input::printable(file.filename().string());
  std::visit(
      [&](auto &metal) {
        metal.name = o.name;
        if (c.hardenings.size() > 1) metal.name += " " + c.hardenings[h];
        metal.name.resize(std::min<std::size_t>(metal.name.size(), 80));
        metal.source = source.substr(0, 2000);
      },
      any);
  return any;
}

/// A plate's name as part of a file's name.
std::string file_part(std::string plate) {
  for (char &c : plate)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  return plate;
}

} // namespace

std::string write_materials(const Options &o, const Results &r) {
  // A metal of an earlier calibration must not stand beside the new numbers.
  for (const char *name : {"material.toml", "material_simultaneous.toml"}) {
    std::error_code ignored;
    std::filesystem::remove(o.out / name, ignored);
  }
  const std::string missing = missing_options(o);
  if (!missing.empty()) return "material.toml: it also needs " + missing;
  const auto write = [&](const std::string &name, const ogive::Calibration &c, std::size_t h, const char *method) {
    const std::string text =
        material_file::to_toml(metal_of(o, c, h, method), "Written by calibrate; fit.json beside it holds the "
                                                          "uncertainties.");
    try {
      material_file::parse(text, name);
    } catch (const ogive::SetupError &error) {
      return std::string(error.what());
    }
    ogive::write_atomically(o.out / name, text);
    return std::string();
  };
  const char *const steps = "three steps of Liu et al. 2012", *const at_once = "all parameters at once";
  std::string left_out = write("material.toml", r.chosen.steps.law, 0, steps);
  const auto &plates = r.chosen.steps.law.hardenings;
  std::set<std::string> used;
  for (std::size_t h = 0; plates.size() > 1 && h < plates.size() && left_out.empty(); ++h) {
    std::string part = file_part(plates[h]);
    if (!used.insert(part).second) part += "_" + std::to_string(h + 1);
    left_out = write("material_" + part + ".toml", r.chosen.steps.law, h, steps);
  }
  if (left_out.empty() && r.chosen.simultaneous)
    left_out = write("material_simultaneous.toml", r.chosen.simultaneous->law, 0, at_once);
  return left_out;
}

} // namespace calibrate
