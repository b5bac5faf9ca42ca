// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/johnson_cook_form.hpp"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

/// \file
/// What a user can choose for `calibrate`, from the command line and from a TOML file.

namespace calibrate {

enum class FlowModel { mjc, jc };
enum class RateTerm { logarithmic, power };

/// One calibration, in the units that the names say. What is unset has no default, or one that follows from the tests.
struct Options {
  std::vector<std::filesystem::path> data; ///< tables of tensile curves
  bool engineering = false;                ///< they hold engineering stress and strain
  std::string name = "metal";              ///< parse() takes the first table's where none is given

  FlowModel model = FlowModel::mjc;
  RateTerm rate_factor = RateTerm::logarithmic; ///< of the classical law
  std::optional<double> reference_rate_per_s;   ///< of the classical law; unset: the quasi-static curve's
  std::optional<double> C, b;                   ///< known values

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

  std::vector<double> predict_rates_per_s;             ///< of prediction.svg; empty: those of the tests
  std::filesystem::path out = "calibration_out/metal"; ///< default_out() where none is given
  bool plots = true;

  bool operator==(const Options &) const = default;
};

/// calibration_out/<name>
std::filesystem::path default_out(const Options &options);

/// The form of the chosen law.
ogive::FlowForm form_of(const Options &options);

/// Reads the command line (argv[0] is skipped) and the TOML file that --config names; the command line wins. Returns
/// nothing if --help or --version was asked for and has been written to `text`. Throws ogive::SetupError, one line that
/// names the option (or file, line and key), the value and what is allowed. Touches no file but --config's.
std::optional<Options> parse(int argc, const char *const *argv, std::ostream &text);

/// The text of --help.
std::string help();

} // namespace calibrate
