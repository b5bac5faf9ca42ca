// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "sim/pulse.hpp"

#include <cmath>

namespace verification {

namespace {

using namespace sim_test;

/// Weak, so that all is linear to 1e-5.
constexpr PulseShape pulse{.push = 0.01};
constexpr double length = 240e-3, path = 120e-3; ///< m
constexpr std::array<double, 3> spacings{2e-3, 1e-3, 0.5e-3};

double sound() { return sound_speed(fem_test::steel<double>()); }

std::string mm(double size) { return number(size * 1e3) + " mm"; }

/// The speed converges with the order `order`.
template <class Make> void add_speed(Rung &rung, const std::string &bar, double order, Make &&make) {
  std::vector<double> errors;
  for (const double spacing : spacings) {
    const double speed = speed_of_pulse(make(spacing), path);
    compare(rung, bar + ", " + mm(spacing) + ": speed, m/s", sound(), speed, 0.01 * std::pow(spacing / 1e-3, 2));
    errors.push_back(speed - sound());
  }
  converges(rung, bar + ": speed, order", order, errors, 0.9 * order);
}

/// A pulse that comes back from the free end of a bar, against the same pulse in a bar without end.
struct Reflection {
  double path, amplitude; ///< m too long, ratio
};

template <class Make> Reflection reflection(double spacing, Make &&make) {
  const double end = 150e-3;
  auto model = make(spacing, end), endless = make(spacing, 300e-3);
  travel(model, 180e-3 / sound());
  travel(endless, 180e-3 / sound());
  const Pulse back = pulse_between(model.nodes, 0, 1), on = pulse_between(endless.nodes, 0, 1);
  return {2 * end - back.centre - on.centre, back.highest / on.highest};
}

template <class Make> void add_reflection(Rung &rung, const std::string &bar, double bound, Make &&make) {
  std::vector<double> errors;
  for (const double spacing : spacings) {
    const Reflection r = reflection(spacing, make);
    compare(rung, bar + ", " + mm(spacing) + ", free end: amplitude", 1, r.amplitude, bound * spacing / 1e-3);
    errors.push_back(r.path);
  }
  vanishes(rung, bar + ", 1 mm, free end: change of path, distances", errors[1] / spacings[1], 0.5);
}

void add_tie(Rung &rung, bool particles_first, double least) {
  const std::string way = particles_first ? "tie, particles to hexes" : "tie, hexes to particles";
  std::vector<double> returned;
  for (const double spacing : spacings) {
    auto model = tied_bar_with_pulse(spacing, particles_first, pulse);
    const double before = total(energy(model));
    travel(model, path / sound());
    const double joint = 120e-3;
    const Pulse passed = pulse_between(model.nodes, joint, 1), back = pulse_between(model.nodes, 0, 90e-3);
    returned.push_back(std::max(back.highest, -back.lowest) / pulse.push);
    vanishes(rung, way + ", " + mm(spacing) + ": reflected, %", 100 * returned.back(),
             5 * std::pow(spacing / 1e-3, 1.5));
    if (spacing == 1e-3) {
      compare(rung, way + ", 1 mm: amplitude that passes", 1, passed.highest / pulse.push, 0.1);
      compare(rung, way + ", 1 mm: energy, J", before, total(energy(model)), 5e-3);
    }
  }
  converges(rung, way + ": reflected, order", 2, returned, least);
}

} // namespace

Rung waves() {
  Rung rung;
  rung.name = "waves";
  SphOptions<double> inviscid_particles;
  inviscid_particles.linear_viscosity = inviscid_particles.quadratic_viscosity = 0;
  const auto inviscid_hexes = fem_test::inviscid<double>();
  add_speed(rung, "particles", 1, [](double s) { return particle_bar_with_pulse(s, length, pulse); });
  add_speed(rung, "particles without viscosity", 2,
            [&](double s) { return particle_bar_with_pulse(s, length, pulse, inviscid_particles); });
  add_speed(rung, "hexes", 1, [](double s) { return hex_bar_with_pulse(s, length, pulse); });
  add_speed(rung, "hexes without viscosity", 2,
            [&](double s) { return hex_bar_with_pulse(s, length, pulse, inviscid_hexes); });
  add_reflection(rung, "particles without viscosity", 0.02,
                 [&](double s, double l) { return particle_bar_with_pulse(s, l, pulse, inviscid_particles); });
  add_reflection(rung, "hexes without viscosity", 0.02,
                 [&](double s, double l) { return hex_bar_with_pulse(s, l, pulse, inviscid_hexes); });
  add_tie(rung, true, 1);
  add_tie(rung, false, 1);
  return rung;
}

} // namespace verification
