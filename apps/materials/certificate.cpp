// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.hpp"

#include "library.hpp"
#include "material_keys.hpp"

#include "ogive/version.hpp"

namespace materials {

namespace {

using options::printed;

ogive::JohnsonCookFactors<double> factors_of(const ogive::JohnsonCook<double> &law) {
  return {law.C, law.m, law.reference_rate, law.rate_factor};
}
ogive::JohnsonCookFactors<double> factors_of(const ogive::Voce<double> &law) { return law.factors; }
ogive::JohnsonCookFactors<double> factors_of(const ogive::PowerLaw<double> &law) { return law.factors; }
ogive::JohnsonCookFactors<double> factors_of(const ogive::ModifiedJohnsonCook<double> &law) {
  return {law.C, law.b, 1, ogive::RateFactor::power};
}
/// Empty: bilinear hardening has no such factors, and metal_of() refuses it.
ogive::JohnsonCookFactors<double> factors_of(const ogive::Bilinear<double> &) { return {}; }

/// All of a metal but its flow law and damage.
template <class To> ogive::Metal<double, To> like(const AnyMetal &other) {
  return std::visit(
      [](const auto &metal) {
        ogive::Metal<double, To> m;
        m.density = metal.density, m.elasticity = metal.elasticity, m.eos = metal.eos;
        m.specific_heat = metal.specific_heat, m.thermal_conductivity = metal.thermal_conductivity;
        m.taylor_quinney = metal.taylor_quinney;
        m.room_temperature = metal.room_temperature, m.melting_temperature = metal.melting_temperature;
        m.rate_floor = metal.rate_floor;
        m.flow.factors = factors_of(metal.flow);
        return m;
      },
      other);
}

/// The law with the factors of rate and temperature that the metal has.
template <class Law> void set_hardening(ogive::Metal<double, Law> &metal, Law law) {
  law.factors = metal.flow.factors;
  metal.flow = law;
}

/// The numbers of the certificate, for the source.
std::string text_of(const Certificate &c) {
  std::string text = printed("yield %g MPa, tensile strength %g MPa, Young's modulus %g GPa", c.numbers.yield / 1e6,
                             c.numbers.strength / 1e6, c.numbers.young / 1e9);
  if (c.elongation) text += printed(", elongation %g %%", *c.elongation * 100);
  if (c.uniform_elongation) text += printed(", uniform elongation %g %%", *c.uniform_elongation * 100);
  if (c.reduction_of_area) text += printed(", reduction of area %g %%", *c.reduction_of_area * 100);
  return text;
}

/// Sets what both laws share, and the strain at which the neck begins.
template <class Law>
CertifiedMetal finished(ogive::Metal<double, Law> m, const Certificate &c, const std::string &law, double uniform,
                        const std::string &other, const std::string &name) {
  CertifiedMetal all;
  m.name = name;
  m.elasticity.young = c.numbers.young;
  m.source = "ogive materials from-tensile " + std::string(ogive::version) + ": " + text_of(c) + "; " + law +
             "; density, Poisson's ratio, heat, temperatures, effects of rate and temperature of " + other;
  m.confidence = "medium: hardening from a certificate; the rest is from " + other;
  all.notes.push_back("hardening: " + law);
  all.notes.push_back("from " + other +
                      ": density, Poisson's ratio, heat, temperatures, effects of rate and temperature");
  if (c.reduction_of_area) {
    const double strain = -std::log1p(-*c.reduction_of_area);
    m.damage.critical_work = work_of_tension(m, strain);
    all.notes.push_back(
        printed("damage: W_cr = %.4g MPa, the work up to a true strain of %.3g in the neck, without the "
                "stress that a neck adds",
                m.damage.critical_work / 1e6, strain));
  } else {
    all.notes.emplace_back("damage: none, a certificate has no failure strain; --reduction-of-area-pct gives W_cr");
  }
  if (c.elongation && *c.elongation < uniform)
    all.warnings.push_back(
        printed("elongation %g %% is below the %.3g %% at which the law begins to neck: the metal breaks "
                "before, or the numbers are of different tests",
                *c.elongation * 100, uniform * 100));
  all.metal = m;
  return all;
}

} // namespace

std::string kind_of(double young) {
  if (young >= 60e9 && young <= 85e9) return "aa6061_t651";
  if (young >= 180e9 && young <= 225e9) return "weldox_460e";
  return "";
}

CertifiedMetal metal_of(const Certificate &c, Model law, const std::string &other, const std::string &name) {
  const AnyMetal metal = find_metal(other, Model::jc, "--like");
  if (model_of(metal) == Model::bilinear)
    options::refuse("--like", other, "must have effects of rate and temperature, its model is bilinear");
  if (law == Model::voce) {
    auto m = like<ogive::Voce<double>>(metal);
    set_hardening(m, ogive::voce_of(c.numbers, *c.uniform_elongation));
    return finished(m, c, "Voce's law by Considere, neck at the uniform elongation", *c.uniform_elongation, other,
                    name);
  }
  auto m = like<ogive::PowerLaw<double>>(metal);
  set_hardening(m, ogive::power_law_of(c.numbers));
  return finished(m, c, printed("power law by Considere, neck at a true strain of n = %.4g", m.flow.n),
                  std::expm1(m.flow.n), other, name);
}

} // namespace materials
