// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/search/build_neighbours.hpp"

#include <algorithm>
#include <array>
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

/// A particle that a bond leads to, or its mirror image.
struct BondedTo {
  Index particle = 0;      ///< at the other end
  Reflection reflection{}; ///< in which it is seen
};

/// The data of the particle at one end of a bond, in this step.
struct BondEnd {
  std::array<float, 3> x; ///< m
  std::array<float, 3> v; ///< m/s
  std::array<float, 9> L; ///< velocity gradient, row first, 1/s
  float volume;           ///< m3
  float growth;           ///< Pa, modulus times time step
  float strength;         ///< Pa
};

/// Bonds of particles, in groups of as many particles as a pack holds: group g has the particles from g * lanes<float>
/// on and the rows begin[g] <= row < begin[g + 1]; each row has one bond of each. A particle with fewer bonds than
/// others of its group is bonded to itself in the rest, which does nothing. In single precision: both ends of a bond
/// compute the same numbers with opposite signs.
template <class T, class Width = SimdWidth> struct Bonds {
  std::vector<std::int64_t> begin; ///< of each group, and the end; empty without bonds
  std::vector<Index> other;        ///< particle, or number of particles + image, at row * lanes<float> + lane
  std::vector<BondedTo> images;    ///< that bonds lead to
  std::vector<float> moment;       ///< Pa m; of each row the x, then the y, then the z of all lanes
  std::vector<T> energy;           ///< J, taken by each particle's half of its bonds
  std::vector<BondEnd> ends;       ///< of particles and images in this step
};

/// Bonds each two particles that are closer together than `reach` (m), mirror images included.
template <class T> Bonds<T> make_bonds(std::span<const Vec3<T>> positions, SymmetryPlanes planes, T reach) {
  Neighbours<T> n;
  build_neighbours(n, positions, planes, reach, T(0));
  const Index count = static_cast<Index>(positions.size());
  std::vector<std::vector<Index>> of(count);
  Bonds<T> bonds;
  std::array<std::vector<Index>, 4> image;
  for (auto &number : image) number.assign(count, -1);
  for (Index c = 0; c < clusters(n); ++c)
    for_each_listed_pair(n, c, [&](Index i, Index j, Reflection in) {
      const bool mirrored = in.x || in.y;
      if ((!mirrored && i == j) || !((reflected(positions[j], in) - positions[i]).squaredNorm() < reach * reach))
        return;
      Index &number = image[in.x + 2 * in.y][j];
      if (mirrored && number < 0) {
        number = count + static_cast<Index>(bonds.images.size());
        bonds.images.push_back({j, in});
      }
      of[i].push_back(mirrored ? number : j);
    });
  bonds.begin.push_back(0);
  for (Index first = 0; first < count; first += lanes<float>) {
    const auto member = [&](Index lane) { return std::min(first + lane, count - 1); };
    std::size_t rows = 0;
    for (Index lane = 0; lane < lanes<float>; ++lane) rows = std::max(rows, of[member(lane)].size());
    for (std::size_t r = 0; r < rows; ++r)
      for (Index lane = 0; lane < lanes<float>; ++lane) {
        const Index i = member(lane);
        bonds.other.push_back(r < of[i].size() ? of[i][r] : i);
      }
    bonds.begin.push_back(bonds.begin.back() + static_cast<std::int64_t>(rows));
  }
  bonds.moment.assign(3 * bonds.other.size(), 0.0F);
  bonds.energy.assign(count, T(0));
  bonds.ends.resize(positions.size() + bonds.images.size());
  return bonds;
}

} // namespace ogive
