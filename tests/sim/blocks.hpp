// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/brick.hpp"

#include "ogive/sim/energy.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/sim/step.hpp"
#include "ogive/sph/body.hpp"

#include <tuple>
#include <vector>

namespace sim_test {

using namespace ogive;
using fem_test::V;
using Steel = Bilinear<double>;
using Sph = SphBody<double, Steel>;
using Hex = HexBody<double, Steel>;

/// A cubic lattice of nx x ny x nz particles whose block has its corner at `corner`.
inline ParticleLayout<double> lattice(Index nx, Index ny, Index nz, double spacing, const V &corner = V::Zero()) {
  ParticleLayout<double> layout{spacing, {}, {}};
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) {
        layout.positions.emplace_back(corner + spacing * V(i + 0.5, j + 0.5, k + 0.5));
        layout.volumes.push_back(spacing * spacing * spacing);
      }
  return layout;
}

/// A brick of hexes with its corner at `corner`.
inline HexMesh<double> brick_at(Index nx, Index ny, Index nz, const V &size, const V &corner) {
  HexMesh<double> mesh = fem_test::brick<double>(nx, ny, nz, size);
  for (V &p : mesh.positions) p += corner;
  return mesh;
}

/// A model of the bodies.
template <class... Bodies> Model<double, std::tuple<Bodies...>> model_of(Nodes<double> nodes, Bodies... bodies) {
  return {std::move(nodes), std::tuple<Bodies...>(std::move(bodies)...), SymmetryPlanes{}};
}

inline V momentum_of(const Nodes<double> &nodes, NodeRange range) {
  V p = V::Zero();
  for (Index n = range.begin; n < range.end; ++n) p += nodes.mass[n] * nodes.velocity[n];
  return p;
}

inline V spin_of(const Nodes<double> &nodes) {
  V spin = V::Zero();
  for (Index n = 0; n < nodes.size(); ++n) spin += nodes.mass[n] * cross<double>(nodes.position[n], nodes.velocity[n]);
  return spin;
}

} // namespace sim_test
