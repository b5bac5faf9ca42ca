// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/facets.hpp"

#include <cstddef>
#include <cstdint>

namespace ogive {

/// When hexes turn into particles.
template <class T> struct ConversionOptions {
  int every = 4;                   ///< steps between two checks; a failed hex carries nothing in the meantime
  T largest_compression = T(2);    ///< density over that of the undeformed metal; a hex beyond it is about to invert
  T smallest_step = T(0.15);       ///< of a hex, over particle distance/sound speed; below it it is too distorted
  T least_checked_strain = T(0.2); ///< plastic; hexes with less are not so distorted
};

/// A plate whose hexes turn into particles where they fail: hex i into particle i of its body of particles, which are
/// unborn before. See sim/convert.hpp.
template <class T> struct Conversion {
  std::size_t plate = 0;          ///< its number among the plates
  std::size_t surface = 0;        ///< number of the contact whose facets are the exposed faces of the hexes
  ConversionOptions<T> options{}; ///< when
  FaceNeighbours neighbours;      ///< of the hexes
  T energy{};                     ///< J, kinetic energy of the corners against each other that was lost
  std::int64_t failed = 0;        ///< number of hexes that had failed
  std::int64_t distorted = 0;     ///< number of those that had not, but were too distorted
};

/// Calls `f(name, value)` for each value of a conversion that a run changes.
template <class C, class F> void for_each_conversion_field(C &&conversion, F &&f) {
  f("energy", conversion.energy);
  f("failed", conversion.failed);
  f("distorted", conversion.distorted);
}

} // namespace ogive
