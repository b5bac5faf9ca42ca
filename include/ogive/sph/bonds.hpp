// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/search/neighbours.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ogive {

/// Resistance of bonds against zero-energy modes, see control.hpp; off by default, as in the paper.
template <class T> struct ZeroEnergyControl {
  T stiffness = T(0);       ///< over the shear modulus; 0: no bonds
  T strength = T(0.2);      ///< over the flow stress
  T while_flowing = T(0.1); ///< factor of the stiffness while either particle flows plastically
  T reach = T(1.6);         ///< of the bonds in the undeformed body, over the particle distance
};

/// One end of a bond: the particle at the other end, or its mirror image.
struct Bond {
  Index other = 0;         ///< particle at the other end
  Reflection reflection{}; ///< in which it is seen
};

/// Bonds of particles, in groups of as many particles as a pack holds: group g has the particles from g * lanes on and
/// the rows begin[g] <= row < begin[g + 1]; each row has one bond of each. A particle with fewer bonds than others of
/// its group is bonded to itself in the rest, which does nothing.
template <class T, class Width = SimdWidth> struct Bonds {
  std::vector<std::int64_t> begin; ///< of each group, and the end; empty without bonds
  std::vector<Bond> ends;          ///< at row * lanes + lane
  std::vector<T> moment;           ///< Pa m; of each row the x, then the y, then the z of all lanes
  std::vector<T> energy;           ///< J, taken by each particle's half of its bonds

  std::vector<T> volume;   ///< m3, of each particle in this step
  std::vector<T> growth;   ///< Pa, modulus times time step of each particle in this step
  std::vector<T> strength; ///< Pa, of each particle in this step
};

/// Bonds each two particles that are closer together than `reach` (m), mirror images included.
template <class T> Bonds<T> make_bonds(std::span<const Vec3<T>> positions, SymmetryPlanes planes, T reach) {
  Neighbours<T> n;
  build_neighbours(n, positions, planes, reach, T(0));
  const Index count = static_cast<Index>(positions.size()), places = static_cast<Index>(n.order.size());
  std::vector<std::vector<Bond>> of(count);
  for (Index k = 0; k < count; ++k) {
    const Index i = n.order[k];
    for (const Index place : row(n, k / lanes<T>)) {
      const bool image = place >= places;
      const MirrorImage mirror = image ? n.images[place - places] : MirrorImage{n.order[place], place, {}};
      if ((image || mirror.parent != i) &&
          (reflected(positions[mirror.parent], mirror.reflection) - positions[i]).squaredNorm() < reach * reach)
        of[i].push_back({mirror.parent, mirror.reflection});
    }
  }
  Bonds<T> bonds;
  bonds.begin.push_back(0);
  for (Index first = 0; first < count; first += lanes<T>) {
    const auto member = [&](Index lane) { return std::min(first + lane, count - 1); };
    std::size_t rows = 0;
    for (Index lane = 0; lane < lanes<T>; ++lane) rows = std::max(rows, of[member(lane)].size());
    for (std::size_t r = 0; r < rows; ++r)
      for (Index lane = 0; lane < lanes<T>; ++lane) {
        const Index i = member(lane);
        bonds.ends.push_back(r < of[i].size() ? of[i][r] : Bond{i, {}});
      }
    bonds.begin.push_back(bonds.begin.back() + static_cast<std::int64_t>(rows));
  }
  bonds.moment.assign(3 * bonds.ends.size(), T(0));
  for (auto *values : {&bonds.energy, &bonds.volume, &bonds.growth, &bonds.strength}) values->assign(count, T(0));
  return bonds;
}

} // namespace ogive
