// SPDX-License-Identifier: BSD-3-Clause
#include "results.hpp"

#include <cstdio>

namespace calibrate {

namespace {

void print_parameters(const ogive::Calibration &c, std::size_t h) {
  const auto names = parameter_names(c.frame.form);
  const Eigen::VectorXd value = parameter_values(c, h);
  const Eigen::VectorXd error = ogive::standard_errors(covariance_of(c, h)).cwiseProduct(parameter_units());
  for (Eigen::Index i = 0; i < value.size(); ++i)
    if (i < 2)
      std::printf("  %-6.1s %10.2f ± %-8.2f MPa\n", names[static_cast<std::size_t>(i)].c_str(), value[i], error[i]);
    else
      std::printf("  %-6s %10.5f ± %-8.5f\n", names[static_cast<std::size_t>(i)].c_str(), value[i], error[i]);
}

} // namespace

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
