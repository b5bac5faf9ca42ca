// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material_file.hpp"
#include "options/given.hpp"

/// \file
/// The one table of a material file: names, meaning, limits, units and members. Reading, writing, errors and the list
/// of the library all read it.

namespace materials {

/// Keys that a file has together or not at all.
enum class Group {
  always, ///< independent of others
  shock,  ///< Mie-Grueneisen
  strain, ///< damage by Johnson-Cook
  work    ///< damage by Cockcroft-Latham
};

/// One key. Its unit is in its name; the member is in SI, 10^power times as large.
struct Key {
  const char *name;
  const char *meaning;
  options::Limits limits{}; ///< of numbers only, in the key's unit
  int power = 0;
  Group group = Group::always;
  bool required = true; ///< if its group is there
};

inline constexpr auto rate_factors = options::named<ogive::RateFactor>(
    {{ogive::RateFactor::logarithmic, "logarithmic"}, {ogive::RateFactor::power, "power"}});

inline constexpr auto rate_terms = options::named<ogive::FailureRateTerm>(
    {{ogive::FailureRateTerm::power, "power"}, {ogive::FailureRateTerm::logarithmic, "logarithmic"}});

inline constexpr auto models = options::named<Model>({{Model::mjc, "mjc"},
                                                      {Model::jc, "jc"},
                                                      {Model::voce, "voce"},
                                                      {Model::power_law, "power_law"},
                                                      {Model::bilinear, "bilinear"}});

constexpr auto choices(Model) { return models; }

constexpr Model model_of(const ogive::ModifiedJohnsonCook<double> &) { return Model::mjc; }
constexpr Model model_of(const ogive::JohnsonCook<double> &) { return Model::jc; }
constexpr Model model_of(const ogive::Voce<double> &) { return Model::voce; }
constexpr Model model_of(const ogive::PowerLaw<double> &) { return Model::power_law; }
constexpr Model model_of(const ogive::Bilinear<double> &) { return Model::bilinear; }

/// Calls `f(key, value)` for the constants of a rate factor and a thermal factor, of a law or of JohnsonCookFactors.
template <class Factors, class F> void for_each_factor_key(Factors &factors, F &&f) {
  f(Key{"C", "of the rate factor", {-0.1, 1}}, factors.C);
  f(Key{"m", "exponent of the homologous temperature", {0.01, 10}}, factors.m);
  f(Key{"reference_rate_per_s", "of the rate factor", {1e-12, 1e9, "1/s"}}, factors.reference_rate);
  f(Key{"rate_factor", "1 + C ln(rate/reference), or (1 + rate/reference)^C"}, factors.rate_factor);
}

/// Calls `f(key, value)` for each constant of a flow law.
template <class Law, class F> void for_each_flow_key(Law &law, F &&f) {
  using Plain = std::remove_const_t<Law>;
  constexpr options::Limits stress{0, 1e5, "MPa"}, change{-1e5, 1e5, "MPa"}, exponent{0.001, 10}, speed{0.001, 1e5};
  const Model model = model_of(law);
  f(Key{"model", "flow law: mjc, jc, voce, power_law or bilinear"}, model);
  if constexpr (std::is_same_v<Plain, ogive::Bilinear<double>>) {
    f(Key{"yield_MPa", "yield stress", stress, 6}, law.yield);
    f(Key{"hardening_MPa", "plastic modulus", {0, 1e6, "MPa"}, 6}, law.hardening);
  }
  if constexpr (std::is_same_v<Plain, ogive::ModifiedJohnsonCook<double>>) {
    f(Key{"A_MPa", "yield stress", stress, 6}, law.A);
    f(Key{"B_MPa", "hardening", stress, 6}, law.B);
    f(Key{"a", "exponent of the plastic strain", exponent}, law.a);
    f(Key{"C", "exponent of the plastic strain rate in 1/s", {-0.1, 1}}, law.C);
    f(Key{"b", "exponent of the homologous temperature", {0.01, 10}}, law.b);
  }
  if constexpr (std::is_same_v<Plain, ogive::JohnsonCook<double>>) {
    f(Key{"A_MPa", "yield stress", stress, 6}, law.A);
    f(Key{"B_MPa", "hardening", stress, 6}, law.B);
    f(Key{"n", "exponent of the plastic strain", exponent}, law.n);
    for_each_factor_key(law, f);
  }
  if constexpr (std::is_same_v<Plain, ogive::Voce<double>>) {
    f(Key{"A_MPa", "yield stress", stress, 6}, law.A);
    f(Key{"Q1_MPa", "hardening: Q1 (1 - exp(-C1 strain)) and the same with Q2, C2", change, 6}, law.Q1);
    f(Key{"C1", "of the plastic strain", speed}, law.C1);
    f(Key{"Q2_MPa", "", change, 6, Group::always, false}, law.Q2);
    f(Key{"C2", "", {0, 1e5}, 0, Group::always, false}, law.C2);
    for_each_factor_key(law.factors, f);
  }
  if constexpr (std::is_same_v<Plain, ogive::PowerLaw<double>>) {
    f(Key{"yield_MPa", "Y of Y (E strain/Y)^n, strain with its elastic part", {0.1, 1e5, "MPa"}, 6}, law.yield);
    f(Key{"n", "exponent of the strain", {0, 0.6}}, law.n);
    for_each_factor_key(law.factors, f);
  }
}

/// Calls `f(key, value)` for each key of a metal, in the order of a file.
template <class M, class F> void for_each_key(M &&m, F &&f) {
  constexpr auto always = Group::always, shock = Group::shock, strain = Group::strain, work = Group::work;
  f(Key{"name", ""}, m.name);
  f(Key{"source", "", {}, 0, always, false}, m.source);
  f(Key{"confidence", "", {}, 0, always, false}, m.confidence);
  f(Key{"density_kg_per_m3", "", {100, 30000, "kg/m3"}}, m.density);
  f(Key{"young_modulus_GPa", "", {0.1, 2000, "GPa"}, 9}, m.elasticity.young);
  f(Key{"poisson_ratio", "", {0, 0.495}}, m.elasticity.poisson);
  f(Key{"specific_heat_J_per_kgK", "0: plastic work does not heat", {0, 20000, "J/(kg K)"}}, m.specific_heat);
  f(Key{"thermal_conductivity_W_per_mK",
        "0: not known; no bands of shear form",
        {0, 3000, "W/(m K)"},
        0,
        always,
        false},
    m.thermal_conductivity);
  f(Key{"room_temperature_K", "at the start", {1, 5000, "K"}}, m.room_temperature);
  f(Key{"melting_temperature_K", "", {1, 10000, "K"}}, m.melting_temperature);
  f(Key{"taylor_quinney", "fraction of plastic work that heats", {0, 1}, 0, always, false}, m.taylor_quinney);

  for_each_flow_key(m.flow, f);
  f(Key{"rate_floor_per_s", "smallest rate given to the flow law", {1e-12, 1e6, "1/s"}, 0, always, false},
    m.rate_floor);

  f(Key{"hugoniot_slope", "s of Us = c0 + s up", {0.1, 10}, 0, shock}, m.eos.hugoniot_slope);
  f(Key{"gruneisen", "", {0, 10}, 0, shock}, m.eos.gruneisen);

  auto &failure = m.damage.failure_strain;
  f(Key{"D1", "failure strain", {-100, 100}, 0, strain}, failure.D1);
  f(Key{"D2", "and its dependence on triaxiality", {-100, 100}, 0, strain}, failure.D2);
  f(Key{"D3", "exponent of the triaxiality", {-100, 100}, 0, strain}, failure.D3);
  f(Key{"D4", "of the rate", {-10, 10}, 0, strain}, failure.D4);
  f(Key{"D5", "of the homologous temperature", {-100, 100}, 0, strain}, failure.D5);
  f(Key{"damage_reference_rate_per_s", "of D4", {1e-12, 1e9, "1/s"}, 0, strain, false}, failure.reference_rate);
  constexpr char term[] = "(rate/reference)^D4, or 1 + D4 ln(rate/reference)";
  f(Key{"damage_rate_term", term, {}, 0, strain, false}, failure.rate_term);
  f(Key{"critical_work_MPa", "Cockcroft-Latham", {0.001, 1e6, "MPa"}, 6, work}, m.damage.critical_work);
}

/// True if the metal has the constants of a group.
template <class M> bool has(const M &metal, Group group) {
  bool found = group == Group::always;
  for_each_key(metal, [&]<class V>(const Key &key, const V &value) {
    if constexpr (std::is_same_v<V, double>) found = found || (key.group == group && key.required && value != 0);
  });
  return found;
}

inline bool has(const AnyMetal &any, Group group) {
  return std::visit([&](const auto &metal) { return has(metal, group); }, any);
}

/// The keys that a group must have, separated by commas.
inline std::string keys_of(Group group) {
  std::vector<std::string> keys;
  for_each_key(std::variant_alternative_t<0, AnyMetal>{}, [&](const Key &key, const auto &) {
    if (key.group == group && key.required) keys.emplace_back(key.name);
  });
  return options::joined(keys);
}

/// The value of a constant as a file has it.
inline std::string text_of(const Key &key, double value) { return options::shortest(value, -key.power); }
inline std::string text_of(const Key &, const std::string &value) { return value; }
inline std::string text_of(const Key &, Model value) { return options::name_in(models, value); }
inline std::string text_of(const Key &, ogive::RateFactor value) { return options::name_in(rate_factors, value); }
inline std::string text_of(const Key &, ogive::FailureRateTerm value) { return options::name_in(rate_terms, value); }

} // namespace materials
