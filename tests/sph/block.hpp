// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/sph/body.hpp"

#include <random>

namespace sph_test {

using namespace ogive;

/// A block of particles whose corner is at zero, each displaced at random by up to `jitter` distances.
inline ParticleLayout<double> block(int nx, int ny, int nz, double jitter, double spacing = 1e-3) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-jitter * spacing, jitter * spacing);
  ParticleLayout<double> layout;
  layout.spacing = spacing;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        // One after another: arguments of a function have no order.
        const double x = (i + 0.5) * spacing + shift(random), y = (j + 0.5) * spacing + shift(random),
                     z = (k + 0.5) * spacing + shift(random);
        layout.positions.emplace_back(x, y, z);
        layout.volumes.push_back(spacing * spacing * spacing);
      }
  return layout;
}

inline Mat3<double> some_gradient() {
  Mat3<double> L;
  L << 100, 250, -80, -30, 60, 20, 45, -15, -90;
  return L;
}

} // namespace sph_test
