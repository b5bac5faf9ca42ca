// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include "ogive/fit/least_squares.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"

#include <nlohmann/json.hpp>

namespace calibrate {

namespace {

using Json = nlohmann::ordered_json;

/// Parameters of one hardening, with errors and correlations.
Json parameters(const ogive::Calibration &c, std::size_t h, bool with_correlation) {
  Json j, errors, names = Json::array(), matrix = Json::array();
  for (const Parameter &p : parameters_of(c, h)) {
    j[p.name] = p.value;
    errors[p.name] = p.standard_error;
    names.push_back(p.name);
  }
  j["standard_error"] = errors;
  if (!with_correlation) return j;
  const Eigen::MatrixXd correlation = ogive::correlation(covariance_of(c, h));
  for (const auto &row : correlation.rowwise()) matrix.push_back(std::vector<double>(row.begin(), row.end()));
  j["correlation"] = {{"order", names}, {"matrix", matrix}};
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

/// All options but where the results go; null where unset.
Json options_entry(Options o) {
  // The folders are those of one machine.
  for (auto &file : o.data) file = file.filename();
  Json j;
  for (const auto &option : table_of(o).options) {
    const std::string value = option.toml();
    if (option.key != std::string("out")) j[option.key] = value.empty() ? Json() : Json::parse(value, nullptr, false);
  }
  return j;
}

Json plates_entry(const ogive::Calibration &c) {
  Json plates;
  for (std::size_t h = 0; h < c.hardenings.size(); ++h) plates[c.hardenings[h]] = parameters(c, h, false);
  return plates;
}

void print_parameters(const ogive::Calibration &c, std::size_t h) {
  for (const auto &[name, value, error] : parameters_of(c, h))
    if (name.ends_with("_MPa"))
      std::printf("  %-6.1s %10.2f ± %-8.2f MPa\n", name.c_str(), value, error);
    else
      std::printf("  %-6s %10.5f ± %-8.5f\n", name.c_str(), value, error);
}

} // namespace

void write_json(const Options &o, const Results &r) {
  const auto &law = r.chosen.steps.law;
  const bool several = law.hardenings.size() > 1;
  Json j = parameters(law, 0, true);
  j["version"] = ogive::version;
  j["name"] = o.name;
  if (several) j["plate"] = law.hardenings.front();
  j["reference_rate_per_s"] = r.chosen.form == ogive::FlowForm::modified ? Json() : Json(law.frame.reference_rate);
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

void print_table(const Options &o, const Results &r) {
  const auto &law = r.chosen.steps.law;
  std::size_t points = 0;
  for (const auto &s : r.series.curves) points += s.curve.strain.size();
  std::printf("%s: %s, %zu curves, %zu points\n\n", o.name.c_str(), long_name(r.chosen.form).c_str(),
              r.series.curves.size(), points);
  for (std::size_t h = 0; h < law.hardenings.size(); ++h) {
    if (law.hardenings.size() > 1) std::printf("  plate %s\n", law.hardenings[h].c_str());
    print_parameters(law, h);
  }
  std::printf("  at the quasi-static rate, %g 1/s: %.2f MPa + %.2f MPa eps^%.4f\n", r.series.quasi_static_rate,
              law.quasi_static[0].A * 1e-6, law.quasi_static[0].B * 1e-6, law.quasi_static[0].a);
  if (law.frame.form != ogive::FlowForm::modified) std::printf("  reference rate %g 1/s\n", law.frame.reference_rate);
  if (r.chosen.simultaneous) {
    std::printf("\n  all parameters at once\n");
    print_parameters(r.chosen.simultaneous->law, 0);
  }

  std::printf("\n  %-40s %12s %7s %9s %13s %8s\n", "curve", "used for", "points", "rms, MPa", "largest, MPa", "at");
  for (const auto &s : r.series.curves) {
    const auto m = ogive::misfit(s, law);
    std::printf("  %-40s %12s %7d %9.2f %13.2f %8.4f\n", description(s.curve).c_str(), name(s.use), m.points,
                m.rms * 1e-6, m.largest * 1e-6, m.strain);
  }
  std::printf("\n  %-40s %12s %7s\n", "law", "rms, MPa", "rms, %");
  for (const auto &other : r.laws) {
    const auto row = [&](const std::string &name, const ogive::Misfit &m) {
      std::printf("  %-40s %12.2f %7.2f\n", name.c_str(), m.rms * 1e-6, m.relative * 100);
    };
    row(long_name(other.form), other.steps.misfit);
    if (other.simultaneous) row(long_name(other.form) + ", all at once", other.simultaneous->misfit);
  }
  if (!r.messages.empty()) std::printf("\n");
  for (const auto &message : r.messages) std::printf("  note: %s\n", message.c_str());
  std::printf("\n  files in %s\n", o.out.string().c_str());
}

} // namespace calibrate
