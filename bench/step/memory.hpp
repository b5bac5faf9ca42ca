// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"
#include "ogive/material/points.hpp"

#include <cstddef>
#include <vector>

/// \file
/// Memory of the particles, from the capacity of their arrays, and that of the process.

namespace bench {

/// Bytes of the arrays of a disc of particles.
struct Memory {
  double nodes = 0;  ///< the disc's share of the nodes
  double points = 0; ///< material points, mass, viscous energy
  double pair_data = 0;
  double neighbours = 0; ///< order, images, positions at building
  double lists = 0;
  double process = 0; ///< largest resident set after the model was made and stepped, less that before
};

inline double sum(const Memory &m) { return m.nodes + m.points + m.pair_data + m.neighbours + m.lists; }

template <class V> double bytes(const std::vector<V> &v) { return static_cast<double>(v.capacity() * sizeof(V)); }
template <class... Arrays> double bytes_of(const Arrays &...arrays) { return (bytes(arrays) + ...); }

template <class Body, class T> Memory memory_of(const Body &body, const ogive::Nodes<T> &nodes) {
  Memory m;
  m.nodes =
      bytes_of(nodes.position, nodes.velocity, nodes.force, nodes.mass, nodes.held) * body.nodes.size() / nodes.size();
  const auto &p = body.points;
  ogive::for_each_point_field(p, [&](const char *, const char *, const auto &field) { m.points += bytes(field); });
  m.points += bytes_of(p.velocity_gradient, p.quasi_static_yield, p.yield_strain, p.yield_temperature, body.point_mass,
                       body.viscous_energy);
  const auto &d = body.pair_data;
  m.pair_data = bytes_of(d.x, d.y, d.z, d.vx, d.vy, d.vz, d.volume, d.density, d.smoothing);
  for (const auto &component : d.correction) m.pair_data += bytes(component);
  for (const auto &component : d.flux) m.pair_data += bytes(component);
  const auto &n = body.neighbours;
  m.neighbours = bytes_of(n.order, n.images, n.built_at);
  m.lists = bytes_of(n.cluster_begin, n.list);
  return m;
}

/// Resident set of this process, bytes; memory that is free is given back first.
double resident_bytes();

/// Lets the largest resident set begin anew from the present one.
void restart_peak();

/// The largest resident set since then, bytes; that of the whole process where the system does not allow a new begin.
double peak_bytes();

} // namespace bench
