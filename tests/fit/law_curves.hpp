// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/fitted_law.hpp"
#include "ogive/fit/stress_curve.hpp"
#include "ogive/material/library.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

/// Weldox 460 E of Liu et al. 2012, Table 1: density, specific heat and beta as heat per work, K/Pa.
inline constexpr double steel_heat_per_work = 0.9 / (7850.0 * 452.0);

/// Of the same steel.
inline constexpr ogive::ReferenceTemperatures<double> steel_temperatures{293, 1800};

/// Normal scatter that is the same with every standard library (Box & Muller 1958).
struct Scatter {
  std::mt19937_64 engine;

  double normal() {
    const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
};

/// Tests that a law would give.
template <class Law> struct LawCurves {
  Law law;
  double noise = 0; ///< standard deviation over stress
  Scatter scatter{std::mt19937_64(1)};
  double heat_per_work = steel_heat_per_work;
  int points = 60;
  std::vector<ogive::StressCurve> curves{};

  /// A test up to plastic strain `to`, adiabatic from 10 1/s on.
  void add(double rate, double temperature, double to, const std::string &plate = "") {
    std::vector<double> strains;
    for (int i = 0; i < points; ++i) strains.push_back(0.002 + (to - 0.002) * i / (points - 1));
    ogive::StressCurve c{plate, "", rate, temperature, strains, {}};
    for (const auto &p :
         adiabatic_curve(law, steel_temperatures, rate, temperature, rate >= 10 ? heat_per_work : 0.0, strains))
      c.stress.push_back(p.stress * (1 + noise * scatter.normal()));
    curves.push_back(std::move(c));
  }
  /// The tests of the paper's section 2.1 on Weldox 460 E.
  void add_all() {
    add(7.4e-4, 293, 0.3);
    add(2.16, 293, 0.2);
    add(1522, 293, 0.2);
    for (const double hot : {373.0, 473.0, 573.0, 673.0, 773.0}) add(7.4e-4, hot, 0.2);
  }
};

inline ogive::SeriesSettings steel_settings() {
  ogive::SeriesSettings s;
  s.melting = 1800;
  s.heat_per_work = steel_heat_per_work;
  return s;
}

/// A choice of law with this reference rate, for steel.
inline ogive::FlowChoice steel_choice(ogive::FlowForm form, double reference_rate = 1) {
  return {{form, reference_rate, 293, 1800}, {}, {}};
}

/// A, B, a of the first hardening, C, b.
inline Eigen::VectorXd parameters(const ogive::Calibration &c) {
  return (Eigen::VectorXd(5) << c.hardening[0].A, c.hardening[0].B, c.hardening[0].a, c.C, c.b).finished();
}
