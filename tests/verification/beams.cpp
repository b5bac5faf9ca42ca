// SPDX-License-Identifier: BSD-3-Clause
#include "fem/beam.hpp"
#include "record.hpp"
#include "timoshenko.hpp"

#include "ogive/sim/run.hpp"

#include <cmath>
#include <numbers>

namespace verification {

namespace {

using namespace fem_test;

/// A solid as a model, so that it moves by the steps of a run: their start is of second order.
template <class Rule> auto model_of(Solid<Rule> s) {
  using Body = decltype(s.body);
  return Model{std::move(s.nodes), std::tuple<Body>(std::move(s.body)), SymmetryPlanes{}};
}

template <class Rule, class Mode>
double half_period_of(Solid<Rule> solid, int axis, double speed, double longest, Mode &&mode) {
  auto model = model_of(std::move(solid));
  const double dt = stable_time_step(model);
  return half_period(model.nodes, axis, speed, longest, mode, [&] { return ogive::step(model, dt), dt; });
}

/// A bar fixed at one end and held laterally; half a period of its first mode is 2 L/c.
template <class Rule> double bar_half_period(Index count, double length) {
  auto s = solid<Rule>(brick<double>(1, 1, count, V(length / count, length / count, length)), inviscid<double>());
  for (Index n = 0; n < s.nodes.size(); ++n)
    s.nodes.held[n] = s.nodes.position[n][2] < 1e-9 ? held_all : held_x | held_y;
  const double expected = 2 * length / sound_speed(s.body.metal);
  return half_period_of<Rule>(std::move(s), 2, 1e-3, 2 * expected,
                              [&](const V &p) { return std::sin(0.5 * std::numbers::pi * p[2] / length); });
}

/// Without lateral contraction, because beam theory leaves out what the clamp does to it.
Metal<double, Bilinear<double>> beam_steel() {
  auto metal = steel<double>();
  metal.elasticity.poisson = 0;
  return metal;
}

/// A beam eight heights long of cubic hexes, `through` of them in its height.
template <class Rule> double cantilever_half_period(Index through, double height) {
  const double edge = height / through;
  const Beam beam{8 * height, height, edge, 8 * through, through, 1};
  auto s = clamped_beam<Rule>(beam, beam_steel(), inviscid<double>());
  for (auto &held : s.nodes.held) held |= held_y;
  const double expected = std::numbers::pi / euler_frequency(beam, s.body.metal);
  return half_period_of<Rule>(std::move(s), 0, 1e-3, 2 * expected,
                              [&](const V &p) { return first_mode(p[2], beam.length); });
}

template <class Period>
void add_series(Rung &rung, const std::string &what, double theory, double bound, double least, Period &&period) {
  std::vector<double> errors;
  for (const Index n : {2, 4, 8}) {
    const double found = period(n);
    compare(rung, what + ", " + std::to_string(n) + " hexes: half a period, µs", theory * 1e6, found * 1e6,
            bound * 16.0 / (n * n));
    errors.push_back(found - theory);
  }
  converges(rung, what + ", order", 2, errors, least);
}

template <class Rule> void add_rule(Rung &rung, const std::string &rule) {
  constexpr double length = 40e-3, height = 4e-3;
  const auto metal = beam_steel();
  add_series(rung, rule + ", bar along its axis", 2 * length / sound_speed(steel<double>()), 0.02, 1.8,
             [&](Index n) { return bar_half_period<Rule>(n, length); });
  const BeamSection section{8 * height, height, metal.elasticity.young, shear_modulus(metal.elasticity), metal.density};
  add_series(rung, rule + ", cantilever", std::numbers::pi / timoshenko_frequency(section), 0.02, 1.8,
             [&](Index n) { return cantilever_half_period<Rule>(n, height); });
}

} // namespace

Rung beams() {
  Rung rung;
  rung.name = "beams";
  add_rule<OnePoint>(rung, "one point");
  add_rule<SelectiveReduced>(rung, "2×2×2 points");
  return rung;
}

} // namespace verification
