// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "ogive/fit/calibration.hpp"
#include "ogive/fit/simultaneous.hpp"

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

/// A law fitted in one of the two ways.
struct Fitted {
  ogive::Calibration law;
  ogive::Misfit misfit;
};

/// A law: by the three steps, and where asked for by all tests at once.
struct LawResult {
  ogive::FlowForm form{};
  Fitted steps;
  std::optional<Fitted> simultaneous;
};

/// Everything that a calibration tells.
struct Results {
  ogive::TestSeries series;
  LawResult chosen;
  std::vector<LawResult> laws; ///< all that could be fitted, in the order of ogive::all_flow_forms
  std::vector<std::string> messages;
};

/// "modified Johnson-Cook", ...
std::string long_name(ogive::FlowForm form);

/// The parameters' names as files have them, MPa for the first two: A_MPa, B_MPa, a, C, b, or n and m.
std::vector<std::string> parameter_names(ogive::FlowForm form);

/// Their values for hardening `h`, and the factors by which SI values become them.
Eigen::VectorXd parameter_values(const ogive::Calibration &c, std::size_t h);
Eigen::VectorXd parameter_units();

/// beta/(rho cp), K/Pa; 0 if isothermal.
double heat_per_work(const Options &options);

/// Reads the tables. Throws ogive::SetupError for one that cannot be read.
std::vector<ogive::StressCurve> read_tables(const Options &options, std::vector<std::string> &messages);

/// Fits all laws to the curves and adds to `messages`. Throws ogive::SetupError if the chosen one cannot be fitted.
Results fitted(const Options &options, std::vector<ogive::StressCurve> curves, std::vector<std::string> messages);

/// Writes fit.json. Throws ogive::WriteError.
void write_json(const Options &options, const Results &results);

/// Writes material.toml, or says why it is left out in the text returned. Throws ogive::WriteError.
std::string write_materials(const Options &options, const Results &results);

/// Writes the tables behind the pictures and draws these; what cannot be drawn is said in the text returned. Throws
/// ogive::WriteError for a table.
std::string write_plots(const Options &options, const Results &results);

/// Prints the closing table.
void print_table(const Options &options, const Results &results);

} // namespace calibrate
