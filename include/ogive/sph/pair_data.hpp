// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <array>
#include <vector>

namespace ogive {

/// What particles and their mirror images show to their neighbours, one array for each quantity, by places.
template <class T> struct PairData {
  std::vector<T> x, y, z;                   ///< m
  std::vector<T> vx, vy, vz;                ///< m/s
  std::vector<T> volume;                    ///< m3
  std::vector<T> density;                   ///< kg/m3
  std::vector<T> pressure;                  ///< Pa, used where damage follows that of the neighbours only
  std::vector<T> smoothing;                 ///< m, used with variable smoothing length only
  std::array<std::vector<T>, 9> correction; ///< B, row first; of particles only, empty for the standard form
  std::array<std::vector<T>, 9> flux;       ///< corrected stress G = sigma B times the volume, row first, N m
};

/// Makes room for `n` places in all arrays but `correction`.
template <class T> void resize(PairData<T> &d, std::size_t n) {
  for (auto *v : {&d.x, &d.y, &d.z, &d.vx, &d.vy, &d.vz, &d.volume, &d.density, &d.pressure, &d.smoothing})
    v->resize(n);
  for (auto &v : d.flux) v.resize(n);
}

} // namespace ogive
