// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/blocks.hpp"

#include "ogive/mesh/facets.hpp"

#include <numbers>

/// \file
/// A smooth compressive pulse in a bar along z that is held laterally, so that it travels at the longitudinal sound
/// speed. Bars are three particle distances wide.

namespace sim_test {

inline constexpr int particles_across = 3;

/// v = push cos^2(pi (z - centre)/width), half a width to either side.
struct PulseShape {
  double centre = 60e-3; ///< m
  double width = 36e-3;  ///< m
  double push = 1.0;     ///< m/s
};

/// What the nodes of a stretch of a bar show of a pulse.
struct Pulse {
  double centre;  ///< m, of the kinetic energy
  double highest; ///< m/s
  double lowest;  ///< m/s
};

inline Pulse pulse_between(const Nodes<double> &nodes, double from, double to) {
  double sum = 0, moment = 0, highest = 0, lowest = 0;
  for (Index n = 0; n < nodes.size(); ++n) {
    const double z = nodes.position[n][2], v = nodes.velocity[n][2];
    if (z < from || z > to) continue;
    sum += nodes.mass[n] * v * v, moment += nodes.mass[n] * v * v * z;
    highest = std::max(highest, v), lowest = std::min(lowest, v);
  }
  return {moment / sum, highest, lowest};
}

/// Lets a body carry a pulse that travels to +z: the strain is -v/c. `point_z(i)` is where material point i lies.
template <class Body, class PointZ>
void give_pulse(Body &body, Nodes<double> &nodes, const PulseShape &shape, PointZ &&point_z) {
  const auto v = [&](double z) {
    const double s = (z - shape.centre) / shape.width;
    return std::abs(s) < 0.5 ? shape.push * std::pow(std::cos(std::numbers::pi * s), 2) : 0.0;
  };
  for (Index n = body.nodes.begin; n < body.nodes.end; ++n) nodes.velocity[n][2] = v(nodes.position[n][2]);
  for (Index i = 0; i < body.points.size(); ++i) {
    const double strain = -v(point_z(i)) / sound_speed(body.metal), shear = shear_modulus(body.metal.elasticity);
    body.points.density[i] = body.metal.density * (1 - strain);
    body.points.pressure[i] = -bulk_modulus(body.metal.elasticity) * strain;
    body.points.deviator[i] = deviator(Sym3<double>{0, 0, 2 * shear * strain, 0, 0, 0});
  }
}

inline void hold_laterally(Nodes<double> &nodes) {
  for (auto &held : nodes.held) held = held_x | held_y;
}

/// Steps a model until `time` (s).
template <class M> void travel(M &model, double time) {
  const double dt = stable_time_step(model);
  while (model.time < time) step(model, dt);
}

/// Mean speed of the pulse's middle over the time that a wave needs for `path` (m), m/s. The velocities that tell where
/// it is belong to the middle of the last step.
template <class M> double speed_of_pulse(M model, double path) {
  const double start = pulse_between(model.nodes, 0, 1).centre;
  travel(model, path / sound_speed(fem_test::steel<double>()));
  return (pulse_between(model.nodes, 0, 1).centre - start) / (model.time - 0.5 * model.last_step);
}

inline Sph particle_bar(Nodes<double> &nodes, Index count, double spacing, double z, SphOptions<double> options = {}) {
  return add_sph_body(nodes, lattice(particles_across, particles_across, count, spacing, V(0, 0, z)),
                      fem_test::steel<double>(), "particles", {}, options);
}

inline Hex hex_bar(Nodes<double> &nodes, Index count, double edge, double width, double z,
                   HexOptions<double> options = {}) {
  return add_hex_body(nodes, brick_at(1, 1, count, V(width, width, count * edge), V(0, 0, z)),
                      fem_test::steel<double>(), "hexes", options);
}

/// A bar of particles that carries the pulse, `length` (m) long from z = 0.
inline auto particle_bar_with_pulse(double spacing, double length, const PulseShape &shape,
                                    SphOptions<double> options = {}) {
  Nodes<double> nodes;
  auto bar = particle_bar(nodes, static_cast<Index>(std::lround(length / spacing)), spacing, 0, options);
  give_pulse(bar, nodes, shape, [&](Index i) { return nodes.position[i][2]; });
  hold_laterally(nodes);
  return model_of(std::move(nodes), std::move(bar));
}

/// A bar of hexes with edges of `edge` (m) that carries the pulse, `length` (m) long from z = 0.
inline auto hex_bar_with_pulse(double edge, double length, const PulseShape &shape, HexOptions<double> options = {}) {
  Nodes<double> nodes;
  auto bar = hex_bar(nodes, static_cast<Index>(std::lround(length / edge)), edge, particles_across * edge, 0, options);
  give_pulse(bar, nodes, shape, [&](Index i) { return (i + 0.5) * edge; });
  hold_laterally(nodes);
  return model_of(std::move(nodes), std::move(bar));
}

/// Half of a bar of 240 mm made of particles, the other half of hexes 2.5 particle distances long, as at the edge of a
/// plate's disc of particles, tied to each other. The pulse starts in the one or the other half.
inline auto tied_bar_with_pulse(double spacing, bool particles_first, const PulseShape &shape) {
  const double joint = 120e-3, edge = 2.5 * spacing, width = particles_across * spacing;
  const auto count = [&](double size) { return static_cast<Index>(std::lround(joint / size)); };
  Nodes<double> nodes;
  const double hex_z = particles_first ? joint : 0;
  auto particles = particle_bar(nodes, count(spacing), spacing, joint - hex_z);
  auto hexes = hex_bar(nodes, count(edge), edge, width, hex_z);
  if (particles_first)
    give_pulse(particles, nodes, shape, [&](Index i) { return nodes.position[particles.nodes.begin + i][2]; });
  else
    give_pulse(hexes, nodes, shape, [&](Index i) { return (i + 0.5) * edge; });
  hold_laterally(nodes);
  const auto mesh = brick_at(1, 1, count(edge), V(width, width, joint), V(0, 0, hex_z));
  const auto facets = shifted(
      facets_where(boundary_facets(mesh), mesh.positions, [&](const V &p) { return std::abs(p[2] - joint) < 1e-9; }),
      hexes.nodes.begin);
  auto tie = make_tie(nodes, particles.nodes, facets, hexes.hexes, spacing);
  auto model = model_of(std::move(nodes), std::move(particles), std::move(hexes));
  model.ties.push_back(std::move(tie));
  return model;
}

} // namespace sim_test
