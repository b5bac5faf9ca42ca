// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/brick.hpp"

namespace fem_test {

/// A clamped-free beam along z that bends along x.
struct Beam {
  double length, height, width; ///< m, along z, x and y
  Index along, through, across; ///< hexes
};

template <class Rule>
Solid<Rule> clamped_beam(const Beam &beam, const Metal<double, Bilinear<double>> &metal = steel<double>(),
                         const HexOptions<double> &options = {}) {
  auto s = solid<Rule>(brick<double>(beam.through, beam.across, beam.along, V(beam.height, beam.width, beam.length)),
                       options, metal);
  for (Index n = 0; n < (beam.through + 1) * (beam.across + 1); ++n) s.nodes.held[n] = held_all;
  return s;
}

/// Euler's first mode at the height z of a clamped-free beam: beta L = 1.875104.
inline double first_mode(double z, double length) {
  const double k = 1.875104 / length, ratio = 0.734096;
  return std::cosh(k * z) - std::cos(k * z) - ratio * (std::sinh(k * z) - std::sin(k * z));
}

/// Angular frequency of that mode for a thin beam, 1/s.
template <class Metal> double euler_frequency(const Beam &beam, const Metal &metal) {
  const double k = 1.875104 / beam.length;
  return k * k * beam.height * std::sqrt(metal.elasticity.young / (12 * metal.density));
}

/// Half a period of the motion along `axis` that begins with the velocities speed * mode(position): when the nodes'
/// displacements, weighted with mode and mass, come back to zero. `advance()` makes a step and returns it, s. Ends with
/// `longest` (s) if they never do.
template <class Mode, class Advance>
double half_period(Nodes<double> &nodes, int axis, double speed, double longest, Mode &&mode, Advance &&advance) {
  const std::vector<V> start = nodes.position;
  for (Index n = 0; n < nodes.size(); ++n)
    if (!(nodes.held[n] & (1 << axis))) nodes.velocity[n][axis] = speed * mode(start[n]);
  double time = 0, before = 0;
  for (;;) {
    const double dt = advance();
    double now = 0;
    for (Index n = 0; n < nodes.size(); ++n)
      now += nodes.mass[n] * mode(start[n]) * (nodes.position[n] - start[n])[axis];
    if (now <= 0) return time + dt * before / (before - now);
    time += dt, before = now;
    if (time > longest) return longest;
  }
}

} // namespace fem_test
