// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "shared/command_line.hpp"

#include <array>

/// \file
/// The one table of the options: names, limits, units, meaning, and where the default comes from. Command line, TOML
/// files, --help and the checks all read it.

namespace calibrate {

using input::Limits;

/// One option. Its flag is `key` with hyphens and two in front.
struct Entry {
  const char *group;
  const char *key;
  const char *meaning;
  const char *fallback;   ///< the default where it is no plain value; empty: the value, nullptr: required
  Limits limits{};        ///< of numbers only
  const char *alias = ""; ///< a shorter flag, without hyphens in front
};

inline constexpr auto flow_models =
    std::to_array<input::Choice<FlowModel>>({{FlowModel::mjc, "mjc"}, {FlowModel::jc, "jc"}});
inline constexpr auto rate_terms =
    std::to_array<input::Choice<RateTerm>>({{RateTerm::logarithmic, "logarithmic"}, {RateTerm::power, "power"}});
constexpr const auto &choices(FlowModel) { return flow_models; }
constexpr const auto &choices(RateTerm) { return rate_terms; }

/// Calls `f(entry, value)` for each option, in the order of --help.
template <class O, class F> void for_each_option(O &o, F &&f) {
  constexpr Limits rate{1e-9, 1e9, "1/s"}, strain{0, 10, ""}, kelvin{1, 10000, "K"};

  const char *const tests = "Tests";
  f(Entry{tests, "data", "tables of tensile curves in CSV: docs/calibration.md", nullptr}, o.data);
  f(Entry{tests, "engineering", "they hold engineering stress and strain; cut at necking, needs --young-GPa", ""},
    o.engineering);
  f(Entry{tests, "name", "of the metal", "that of the first table"}, o.name);

  const char *const law = "Law";
  f(Entry{law, "model", "modified or classical Johnson-Cook; all laws are fitted, this one becomes material.toml", ""},
    o.model);
  f(Entry{law, "rate_factor", "of the classical law: 1 + C ln(rate/reference) or (1 + rate/reference)^C", ""},
    o.rate_factor);
  f(Entry{law, "reference_rate_per_s", "of the classical law", "rate of the quasi-static curve", rate},
    o.reference_rate_per_s);
  f(Entry{law, "C", "known value, not fitted", "fitted", {-1, 1, ""}}, o.C);
  f(Entry{law, "b", "known value, not fitted (m of the classical law)", "fitted", {0.01, 20, ""}}, o.b);

  const char *const metal = "Metal";
  f(Entry{metal, "melting_K", "melting temperature", nullptr, kelvin}, o.melting_K);
  f(Entry{metal,
          "density_kg_per_m3",
          "for the heating of fast tests",
          "required unless --isothermal",
          {100, 30000, "kg/m3"},
          "density"},
    o.density_kg_per_m3);
  f(Entry{metal,
          "specific_heat_J_per_kgK",
          "for the heating of fast tests",
          "required unless --isothermal",
          {1, 20000, "J/(kg K)"},
          "specific-heat"},
    o.specific_heat_J_per_kgK);
  f(Entry{metal, "room_K", "room temperature; tests within 10 K of it count as being there", "", kelvin}, o.room_K);
  f(Entry{metal, "beta", "fraction of plastic work that heats", "", {0, 1, ""}}, o.beta);
  f(Entry{metal, "young_GPa", "Young's modulus", "none: no material.toml", {0.1, 2000, "GPa"}}, o.young_GPa);
  f(Entry{metal, "poisson", "Poisson's ratio", "none: no material.toml", {0, 0.495, ""}}, o.poisson);

  const char *const fit = "Fit";
  f(Entry{fit, "isothermal", "no test heats itself", ""}, o.isothermal);
  f(Entry{fit, "adiabatic_above_per_s", "rate from which a test keeps its heat", "", rate}, o.adiabatic_above_per_s);
  f(Entry{fit, "rate_window_from", "plastic strain from which C is taken", "", strain}, o.rate_window_from);
  f(Entry{fit, "rate_window_to", "and to which", "none", strain}, o.rate_window_to);
  f(Entry{fit, "thermal_window_from", "plastic strain from which b is taken", "", strain}, o.thermal_window_from);
  f(Entry{fit, "thermal_window_to", "and to which", "", strain}, o.thermal_window_to);
  f(Entry{fit, "leave_out_from_K", "tests between this and --leave-out-to-K do not count: blue brittleness", "none",
          kelvin},
    o.leave_out_from_K);
  f(Entry{fit, "leave_out_to_K", "see --leave-out-from-K", "none", kelvin}, o.leave_out_to_K);
  f(Entry{fit, "simultaneous", "afterwards fit all parameters at once to all tests, robustly", ""}, o.simultaneous);

  const char *const output = "Output";
  f(Entry{output, "predict_rates_per_s", "rates in prediction.svg, at room temperature", "those of the tests", rate},
    o.predict_rates_per_s);
  f(Entry{output, "out", "folder for the results", "calibration_out/NAME"}, o.out);
  f(Entry{output, "plots", "draw the pictures", ""}, o.plots);
}

/// Calls `f(entry, value)` for the option with this key, if there is one.
template <class O, class F> bool with_option(O &o, std::string_view key, F &&f) {
  bool found = false;
  for_each_option(o, [&](const Entry &entry, auto &value) {
    if (key != entry.key) return;
    found = true;
    f(entry, value);
  });
  return found;
}

} // namespace calibrate
