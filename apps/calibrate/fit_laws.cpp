// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "shared/input.hpp"

#include "ogive/fit/curve_table.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace calibrate {

namespace {

/// A larger file is no table of tests; a device such as /dev/zero has no end.
constexpr std::size_t largest_file = std::size_t(256) << 20;

std::string text_of_table(const std::filesystem::path &name) {
  const auto refuse_with = [&](const std::string &reason) {
    input::refuse("--data", name.string(), "must be a CSV file " + reason);
  };
  const auto refuse_error = [&](int error) {
    refuse_with("that can be read: " + std::generic_category().message(error));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) refuse_error(errno);
  std::string text;
  constexpr std::size_t block = 1 << 20;
  for (std::size_t got = block; got == block;) {
    const std::size_t size = text.size();
    text.resize(size + block);
    got = std::fread(text.data() + size, 1, block, file.get());
    text.resize(size + got);
    if (text.size() > largest_file) refuse_with("of at most 256 MiB");
  }
  if (std::ferror(file.get())) refuse_error(errno);
  return text;
}

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

std::vector<std::string> parameter_names(ogive::FlowForm form) {
  if (form == ogive::FlowForm::modified) return {"A_MPa", "B_MPa", "a", "C", "b"};
  return {"A_MPa", "B_MPa", "n", "C", "m"};
}

Eigen::VectorXd parameter_units() { return (Eigen::VectorXd(5) << 1e-6, 1e-6, 1, 1, 1).finished(); }

Eigen::VectorXd parameter_values(const ogive::Calibration &c, std::size_t h) {
  const auto &hardening = c.hardening[h];
  const Eigen::VectorXd si = (Eigen::VectorXd(5) << hardening.A, hardening.B, hardening.a, c.C, c.b).finished();
  return si.cwiseProduct(parameter_units());
}

std::vector<ogive::StressCurve> read_tables(const Options &o, std::vector<std::string> &messages) {
  std::vector<std::string> texts;
  std::vector<ogive::CurveTable> tables;
  for (const auto &file : o.data) texts.push_back(text_of_table(file));
  for (std::size_t i = 0; i < texts.size(); ++i) tables.push_back({input::printable(o.data[i].string()), texts[i]});
  return ogive::read_curves(tables, {o.engineering, o.young_GPa.value_or(0) * 1e9, *o.melting_K}, messages);
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
