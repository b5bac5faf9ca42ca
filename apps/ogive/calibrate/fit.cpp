// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "instances/fits.hpp"

#include "ogive/fit/calibration.hpp"
#include "ogive/fit/curve_table.hpp"
#include "ogive/fit/simultaneous.hpp"

namespace calibrate {

namespace {

ogive::SeriesSettings settings_of(const Options &o) {
  ogive::SeriesSettings s;
  s.room = o.room_K;
  s.melting = *o.melting_K;
  s.heat_per_work = heat_per_work(o);
  s.adiabatic_above = o.adiabatic_above_per_s;
  s.rate_window.from = o.rate_window_from;
  if (o.rate_window_to) s.rate_window.to = *o.rate_window_to;
  s.thermal_window = {o.thermal_window_from, o.thermal_window_to};
  if (o.leave_out_from_K) s.left_out = ogive::Interval{*o.leave_out_from_K, *o.leave_out_to_K};
  return s;
}

LawResult fit_law(const Options &o, const ogive::TestSeries &series, ogive::FlowForm form) {
  const double reference = o.reference_rate_per_s.value_or(series.quasi_static_rate);
  const ogive::FlowChoice choice{{form, reference, o.room_K, *o.melting_K}, o.C, o.b};
  const auto with_misfit = [&](const ogive::Calibration &law) { return Fitted{law, ogive::misfit(series, law)}; };
  LawResult result{form, with_misfit(calibrated(series, choice)), {}};
  if (o.simultaneous) result.simultaneous = with_misfit(simultaneously_calibrated(series, choice, result.steps.law));
  return result;
}

} // namespace

double heat_per_work(const Options &o) {
  return o.isothermal ? 0 : o.beta / (*o.density_kg_per_m3 * *o.specific_heat_J_per_kgK);
}

std::string long_name(ogive::FlowForm form) {
  if (form == ogive::FlowForm::modified) return "modified Johnson-Cook";
  return form == ogive::FlowForm::power ? "Johnson-Cook, power" : "Johnson-Cook, logarithmic";
}

std::vector<Parameter> parameters_of(const ogive::Calibration &c, std::size_t h) {
  const bool modified = c.frame.form == ogive::FlowForm::modified;
  const Eigen::VectorXd error = ogive::standard_errors(covariance_of(c, h));
  const auto &hardening = c.hardening[h];
  return {{"A_MPa", hardening.A * 1e-6, error[0] * 1e-6},
          {"B_MPa", hardening.B * 1e-6, error[1] * 1e-6},
          {modified ? "a" : "n", hardening.a, error[2]},
          {"C", c.C, error[3]},
          {modified ? "b" : "m", c.b, error[4]}};
}

std::vector<ogive::StressCurve> read_tables(const Options &o, std::vector<std::string> &messages) {
  constexpr std::size_t most_mebibytes = 256;
  std::vector<std::string> texts;
  std::vector<ogive::CurveTable> tables;
  for (const auto &file : o.data) texts.push_back(options::text_of_file(file, "--data", "CSV", most_mebibytes));
  for (std::size_t i = 0; i < texts.size(); ++i) tables.push_back({options::printable(o.data[i].string()), texts[i]});
  return ogive::read_curves(tables, {o.engineering, o.young_GPa.value_or(0) * 1e9, *o.melting_K, o.unusual}, messages);
}

Results fitted(const Options &o, std::vector<ogive::StressCurve> curves, std::vector<std::string> messages) {
  Results results;
  results.messages = std::move(messages);
  results.series = ogive::sorted_series(std::move(curves), settings_of(o));
  const auto &notes = results.series.messages;
  results.messages.insert(results.messages.end(), notes.begin(), notes.end());
  results.chosen = fit_law(o, results.series, form_of(o));
  for (const auto form : ogive::all_flow_forms) {
    try {
      results.laws.push_back(form == results.chosen.form ? results.chosen : fit_law(o, results.series, form));
    } catch (const ogive::SetupError &error) {
      results.messages.push_back(long_name(form) + " is not compared: " + error.what());
    }
  }
  if (o.C || o.b) results.messages.emplace_back("given values of C and b are taken for all laws, without error");
  if (results.chosen.steps.law.C <= 0)
    results.messages.emplace_back("C is not positive: the faster tests are not stronger than the quasi-static one");
  return results;
}

} // namespace calibrate
