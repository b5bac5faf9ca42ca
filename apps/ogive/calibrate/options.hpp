// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/command_line.hpp"

#include "ogive/fit/johnson_cook_form.hpp"

/// \file
/// The options of `ogive calibrate`, from the command line and from a TOML file.

namespace calibrate {

enum class FlowModel { mjc, jc };
enum class RateTerm { logarithmic, power };
constexpr auto choices(FlowModel) {
  return options::named<FlowModel>({{FlowModel::mjc, "mjc"}, {FlowModel::jc, "jc"}});
}
constexpr auto choices(RateTerm) {
  return options::named<RateTerm>({{RateTerm::logarithmic, "logarithmic"}, {RateTerm::power, "power"}});
}

/// One calibration, in the units of the names. What is unset has no default, or one that follows from the tests.
struct Options {
  std::vector<std::filesystem::path> data; ///< tables of tensile curves
  bool engineering = false;                ///< they hold engineering stress and strain
  bool unusual = false;                    ///< they may be colder than 150 K and yield outside 10 MPa to 5 GPa
  std::string name;                        ///< of the metal; parse() takes the first table's where none is given

  FlowModel model = FlowModel::mjc;
  RateTerm rate_factor = RateTerm::logarithmic; ///< of the classical law
  std::optional<double> reference_rate_per_s;   ///< of the classical law; unset: the quasi-static curve's
  std::optional<double> C, b;                   ///< known values

  double thermal_conductivity_W_per_mK = 0;
  std::optional<double> density_kg_per_m3, specific_heat_J_per_kgK, melting_K;
  double room_K = 293;
  double beta = 0.9;
  std::optional<double> young_GPa, poisson;

  bool isothermal = false;
  double adiabatic_above_per_s = 10;
  double rate_window_from = 0.05;
  std::optional<double> rate_window_to;
  double thermal_window_from = 0.03, thermal_window_to = 0.15;
  std::optional<double> leave_out_from_K, leave_out_to_K;
  bool simultaneous = false;

  std::vector<double> predict_rates_per_s; ///< of prediction.svg; empty: those of the tests
  std::filesystem::path out;               ///< parse() takes calibration_out/<name> where none is given
  bool plots = true;
};

/// The options of the program, bound to `o`.
options::Table table_of(Options &o);

/// A name as part of a file's name.
std::string file_part(std::string name);

/// The form of the chosen law.
ogive::FlowForm form_of(const Options &options);

/// Reads the command line and the TOML file that --config names; the command line wins. Returns nothing if --help or
/// --version was given and has been written to `text`. Throws ogive::SetupError, one line that names the option (or
/// file, line and key), the value and what is allowed. Touches no file but --config's.
std::optional<Options> parse(const options::Arguments &arguments, std::ostream &text);

} // namespace calibrate
