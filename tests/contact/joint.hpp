// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/box.hpp"

#include "ogive/contact/tie.hpp"
#include "ogive/sph/force.hpp"

#include <cmath>

namespace contact_test {

/// A distorted brick of 3 x 3 x 3 hexes of about 1 mm and a block of particles on its face x = 3 mm, with an irregular
/// gap of about half a particle distance.
struct Joint {
  static constexpr double spacing = 0.4e-3; ///< m
  Nodes<double> nodes;
  SphBody<double, Bilinear<double>> particles;
  HexBody<double, Bilinear<double>> hexes;
  std::vector<Facet> face;

  Joint() {
    // Particles are displaced by so little that corners, too, have the corrected gradient in full.
    fem_test::Noise noise{5};
    ParticleLayout<double> layout{spacing, {}, {}};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 7; ++j)
        for (int k = 0; k < 7; ++k) {
          layout.positions.emplace_back(V(3e-3, 0.1e-3, 0.1e-3) +
                                        spacing * (V(i + 0.6, j + 0.5, k + 0.5) + 0.05 * noise.vector()));
          layout.volumes.push_back(std::pow(spacing, 3));
        }
    const auto mesh = fem_test::distorted_brick(3, 1e-3, 0.08);
    particles = add_sph_body(nodes, layout, fem_test::steel<double>(), "particles");
    hexes = add_hex_body(nodes, mesh, fem_test::steel<double>(), "hexes");
    face = shifted(facets_where(boundary_facets(mesh), mesh.positions, [](const V &p) { return p[0] > 2.8e-3; }),
                   hexes.nodes.begin);
  }
  Tie<double> tie() { return make_tie(nodes, particles.nodes, face, hexes.hexes, spacing); }
};

} // namespace contact_test
