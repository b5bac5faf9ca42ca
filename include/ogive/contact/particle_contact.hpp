// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ogive {

/// A particle that another one may touch, as that one sees it.
struct ParticleNearby {
  Index particle = 0;      ///< its number in the contact
  Reflection reflection{}; ///< in which it is seen, if it is a mirror image
};

/// The data of one body of particles in a contact.
template <class T> struct ContactBody {
  NodeRange nodes{};      ///< of its particles
  std::vector<T> volumes; ///< m3, one for each
  T spacing{};            ///< particle distance, m
  T to_touch{};           ///< m along z, the way to where the bodies touch and nothing presses yet
};

/// Particles of different bodies against each other. A particle feels how full its surroundings are of other bodies,
/// c_i = sum_j V_j W_ij: a smooth measure of depth that sees no single spheres, so that stacked lattices slide. Energy
/// V_i K/2 (c_i - t_i)^2 where c_i exceeds the threshold t_i, the fullness at touch; its derivative is the force, equal
/// and opposite for each pair. No friction. Akin to the contact potential of Vignjevic, De Vuyst & Campbell 2006.
template <class T> struct ParticleContact {
  std::string name;               ///< for messages
  SymmetryPlanes symmetry{};      ///< mirror planes of the model
  NodeRange nodes{};              ///< the particles of all bodies, one body behind the other
  std::vector<std::uint8_t> body; ///< of each particle
  std::vector<T> volume;          ///< m3, undeformed; 0: deactivated
  std::vector<T> threshold;       ///< fullness at which a particle begins to press
  T smoothing_length{};           ///< m, of W
  T stiffness{};                  ///< Pa, K
  T search_margin{};              ///< m, how far particles may approach before the next search

  std::vector<Vec3<T>> forces;      ///< N, on each particle
  std::vector<T> normal_energy;     ///< J, work taken from each particle
  Index lost = -1;                  ///< the first particle deep within another body; -1: none
  std::vector<Vec3<T>> searched_at; ///< positions at the last search, m

  std::vector<Index> row_begin;       ///< of each particle in `nearby`, and the end
  std::vector<ParticleNearby> nearby; ///< particles of other bodies, by row
  std::vector<T> fullness;            ///< of this step
};

/// Most bodies in a contact of particles.
inline constexpr std::size_t most_contact_bodies = 8;

/// Fullness beyond which a particle counts as lost within another body: on a plane surface it is 0.5, half a particle
/// distance below about 0.75.
inline constexpr double lost_fullness = 0.75;

} // namespace ogive
