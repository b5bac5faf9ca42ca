// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"

#include <nlohmann/json.hpp>

namespace calibrate {

namespace {

using Json = nlohmann::ordered_json;

Json named(const std::vector<std::string> &names, const Eigen::VectorXd &values) {
  Json j;
  for (std::size_t i = 0; i < names.size(); ++i) j[names[i]] = values[static_cast<Eigen::Index>(i)];
  return j;
}

Json matrix(const Eigen::MatrixXd &m) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index k = 0; k < m.cols(); ++k) row.push_back(m(i, k));
    rows.push_back(row);
  }
  return rows;
}

/// Parameters of one hardening, with errors and correlations.
Json parameters(const ogive::Calibration &c, std::size_t h, bool with_correlation) {
  const auto names = parameter_names(c.frame.form);
  const Eigen::MatrixXd covariance = covariance_of(c, h);
  Json j = named(names, parameter_values(c, h));
  j["standard_error"] = named(names, ogive::standard_errors(covariance).cwiseProduct(parameter_units()));
  if (with_correlation) j["correlation"] = {{"order", names}, {"matrix", matrix(ogive::correlation(covariance))}};
  return j;
}

Json with_misfit(Json j, const ogive::Misfit &m) {
  j["rms_MPa"] = m.rms * 1e-6;
  j["rms_percent"] = m.relative * 100;
  return j;
}

Json curve_entry(const ogive::SortedCurve &s, const ogive::Calibration &c) {
  const auto m = ogive::misfit(s, c);
  return {{"plate", s.curve.plate},
          {"specimen", s.curve.specimen},
          {"strain_rate_per_s", s.curve.rate},
          {"temperature_K", s.curve.temperature},
          {"points", m.points},
          {"used_for", name(s.use)},
          {"adiabatic", s.adiabatic},
          {"final_temperature_K", s.temperature.back()},
          {"rms_MPa", m.rms * 1e-6},
          {"largest_misfit_MPa", m.largest * 1e-6},
          {"at_plastic_strain", m.strain}};
}

Json optional(const std::optional<double> &value) { return value ? Json(*value) : Json(nullptr); }

Json options_entry(const Options &o) {
  Json files = Json::array();
  for (const auto &file : o.data) files.push_back(file.filename().string());
  return {{"data", files},
          {"engineering", o.engineering},
          {"melting_K", *o.melting_K},
          {"room_K", o.room_K},
          {"density_kg_per_m3", optional(o.density_kg_per_m3)},
          {"specific_heat_J_per_kgK", optional(o.specific_heat_J_per_kgK)},
          {"beta", o.beta},
          {"isothermal", o.isothermal},
          {"adiabatic_above_per_s", o.adiabatic_above_per_s},
          {"rate_window_from", o.rate_window_from},
          {"rate_window_to", optional(o.rate_window_to)},
          {"thermal_window_from", o.thermal_window_from},
          {"thermal_window_to", o.thermal_window_to},
          {"leave_out_from_K", optional(o.leave_out_from_K)},
          {"leave_out_to_K", optional(o.leave_out_to_K)},
          {"given_C", optional(o.C)},
          {"given_b", optional(o.b)}};
}

Json plates_entry(const ogive::Calibration &c) {
  Json plates;
  for (std::size_t h = 0; h < c.hardenings.size(); ++h) plates[c.hardenings[h]] = parameters(c, h, false);
  return plates;
}

} // namespace

void write_json(const Options &o, const Results &r) {
  const auto &law = r.chosen.steps.law;
  const bool classical = law.frame.form != ogive::FlowForm::modified;
  const bool several = law.hardenings.size() > 1;
  Json j = parameters(law, 0, true);
  j["version"] = ogive::version;
  j["name"] = o.name;
  j["model"] = classical ? "jc" : "mjc";
  if (classical) {
    j["rate_factor"] = law.frame.form == ogive::FlowForm::power ? "power" : "logarithmic";
    j["reference_rate_per_s"] = law.frame.reference_rate;
  }
  if (several) j["plate"] = law.hardenings.front();
  j["quasi_static"] = {{"A_MPa", law.quasi_static[0].A * 1e-6},
                       {"B_MPa", law.quasi_static[0].B * 1e-6},
                       {"rate_per_s", r.series.quasi_static_rate}};
  j = with_misfit(std::move(j), r.chosen.steps.misfit);
  if (several) j["plates"] = plates_entry(law);
  if (r.chosen.simultaneous) {
    const auto &s = *r.chosen.simultaneous;
    j["simultaneous"] = with_misfit(parameters(s.law, 0, true), s.misfit);
    if (several) j["simultaneous"]["plates"] = plates_entry(s.law);
  }
  j["curves"] = Json::array();
  for (const auto &s : r.series.curves) j["curves"].push_back(curve_entry(s, law));
  for (const auto &other : r.laws) {
    Json entry = with_misfit(parameters(other.steps.law, 0, false), other.steps.misfit);
    if (other.form != ogive::FlowForm::modified) entry["reference_rate_per_s"] = other.steps.law.frame.reference_rate;
    if (other.simultaneous)
      entry["simultaneous"] = with_misfit(parameters(other.simultaneous->law, 0, false), other.simultaneous->misfit);
    j["comparison"][long_name(other.form)] = entry;
  }
  j["options"] = options_entry(o);
  j["messages"] = r.messages;
  // Names of specimens may be in any encoding.
  ogive::write_atomically(o.out / "fit.json", j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace calibrate
