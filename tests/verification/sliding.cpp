// SPDX-License-Identifier: BSD-3-Clause
#include "contact/sledge.hpp"
#include "record.hpp"

#include <cmath>

namespace verification {

namespace {

using namespace contact_test;

constexpr double friction = 0.2, speed = 20; ///< -, m/s

/// How a block that slides on its own comes to rest.
struct Stop {
  double distance, heat; ///< m, J
};

Stop slide(double dt) {
  Sledge sledge(friction, dt);
  set_velocity(sledge.nodes, sledge.runners, V(speed, 0, 0));
  const double start = sledge.nodes.position[sledge.runners.begin][0];
  for (double time = 0; time < 2 * speed / (friction * Sledge::gravity); time += dt) sledge.advance(0);
  return {sledge.nodes.position[sledge.runners.begin][0] - start, friction_energy(sledge.contact)};
}

/// Acceleration of a block that is pulled with `times` the largest friction, m/s2, between the times T/2 and T, T = 40
/// us.
double acceleration(double times) {
  Sledge sledge(friction);
  const int half = 200;
  const auto velocity = [&] { return sledge.nodes.velocity[sledge.runners.begin][0]; };
  const double pull = times * friction * Sledge::mass * Sledge::gravity;
  for (int i = 0; i < half; ++i) sledge.advance(pull);
  const double before = velocity();
  for (int i = 0; i < half; ++i) sledge.advance(pull);
  return (velocity() - before) / (half * sledge.dt);
}

} // namespace

Rung sliding() {
  Rung rung;
  rung.name = "sliding";
  const double limit = friction * Sledge::gravity, distance = speed * speed / (2 * limit);
  std::vector<double> errors;
  for (const double dt : {2e-7, 1e-7, 0.5e-7}) {
    const Stop stop = slide(dt);
    compare(rung, "distance to rest in " + number(std::round(speed / limit / dt)) + " steps, mm", distance * 1e3,
            stop.distance * 1e3, 0.012 * dt / 1e-7);
    errors.push_back(stop.distance - distance);
  }
  converges(rung, "distance to rest, order", 1, errors, 0.8);
  compare(rung, "heat of friction, J", 4 * 0.5 * Sledge::mass * speed * speed, slide(0.5e-7).heat, 0.005);
  compare(rung, "pulled with 1.5 µ N: acceleration, m/s²", 0.5 * limit, acceleration(1.5), 1e-5);
  vanishes(rung, "pulled with 0.5 µ N: acceleration over µ g", acceleration(0.5) / limit, 1e-6);
  return rung;
}

} // namespace verification
