// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "ogive/fit/fitted_law.hpp"

namespace calibrate {

/// A law fitted in one of the two ways.
struct Fitted {
  ogive::Calibration law;
  ogive::Misfit misfit;
};

/// A law: by the three steps, and with --simultaneous by all tests at once.
struct LawResult {
  ogive::FlowForm form{};
  Fitted steps;
  std::optional<Fitted> simultaneous;
};

/// The result of a calibration.
struct Results {
  ogive::TestSeries series;
  LawResult chosen;
  std::vector<LawResult> laws; ///< all that could be fitted, in the order of ogive::all_flow_forms
  std::vector<std::string> messages;
};

/// A fitted parameter, in the unit of its name.
struct Parameter {
  std::string name;
  double value = 0, standard_error = 0;
};

/// The parameters of hardening `h`, with the names of material files: A_MPa, B_MPa, a, C, b, or n and m.
std::vector<Parameter> parameters_of(const ogive::Calibration &c, std::size_t h);

/// `f` of the flow law of hardening `h`.
template <class F> auto with_law(const ogive::Calibration &c, std::size_t h, F &&f) {
  if (c.frame.form == ogive::FlowForm::modified) return f(modified_law(c.hardening[h], c.C, c.b));
  return f(classical_law(c.frame, c.hardening[h], c.C, c.b));
}

/// "modified Johnson-Cook", ...
std::string long_name(ogive::FlowForm form);

/// beta/(rho cp), K/Pa; 0 if isothermal.
double heat_per_work(const Options &options);

/// Reads the tables. Throws ogive::SetupError for one that cannot be read.
std::vector<ogive::StressCurve> read_tables(const Options &options, std::vector<std::string> &messages);

/// Fits all laws to the curves and adds to `messages`. Throws ogive::SetupError if the chosen one cannot be fitted.
Results fitted(const Options &options, std::vector<ogive::StressCurve> curves, std::vector<std::string> messages);

/// Writes fit.json. Throws ogive::WriteError.
void write_json(const Options &options, const Results &results);

/// Writes material.toml. Returns the reason if it is left out. Throws ogive::WriteError.
std::string write_materials(const Options &options, const Results &results);

/// Writes the tables behind the pictures and draws these. Returns a line for each picture that cannot be drawn. Throws
/// ogive::WriteError for a table.
std::string write_plots(const Options &options, const Results &results);

/// Prints the closing table.
void print_table(const Options &options, const Results &results);

} // namespace calibrate
