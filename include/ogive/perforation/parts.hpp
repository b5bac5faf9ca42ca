// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/setup.hpp"

#include <numeric>
#include <vector>

/// \file
/// The parts of a projectile in a model, and the one that stands for it where they may come apart.

namespace ogive {

/// The nodes of the whole projectile, of all parts.
template <class M> NodeRange projectile_nodes(const M &model) {
  return {model.bodies.projectile.front().nodes.begin, model.bodies.projectile.back().nodes.end};
}

/// Whether the parts of the projectile have nodes of their own, so that they only touch.
template <class M> bool parts_touch(const M &model) {
  return projectile_nodes(model).size() != projectile(model).nodes.size();
}

/// Number of the part that stands for the projectile: the heaviest one at the start if parts touch, else the first.
template <class M> std::size_t main_part(const M &model) {
  std::size_t heaviest = 0;
  if (!parts_touch(model)) return heaviest;
  const auto mass_of = [&](std::size_t k) { return whole_mass(projectile(model, k).point_mass, model.symmetry); };
  for (std::size_t k = 1; k < model.bodies.projectile.size(); ++k)
    if (mass_of(k) > mass_of(heaviest)) heaviest = k;
  return heaviest;
}

/// The nodes whose motion counts as that of part `k`: its own if parts touch, else those of the whole projectile.
template <class M> std::vector<Index> nodes_of_part(const M &model, std::size_t k) {
  const NodeRange range = projectile(model, k).nodes;
  std::vector<Index> list(static_cast<std::size_t>(range.size()));
  std::iota(list.begin(), list.end(), range.begin);
  return list;
}

/// The nodes whose motion counts as the projectile's: those of main_part(). A jacket may stay in the plate.
template <class M> std::vector<Index> followed_nodes(const M &model) { return nodes_of_part(model, main_part(model)); }

} // namespace ogive
