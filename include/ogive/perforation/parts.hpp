// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/setup.hpp"

#include <numeric>
#include <vector>

/// \file
/// The parts of a projectile in a model, and the one that represents it where they may come apart.

namespace ogive {

/// The nodes of the whole projectile, of all parts.
template <class M> NodeRange projectile_nodes(const M &model) {
  return {model.bodies.projectile.front().nodes.begin, model.bodies.projectile.back().nodes.end};
}

/// Whether the parts of the projectile have nodes of their own, so that they only touch.
template <class M> bool parts_touch(const M &model) {
  return projectile_nodes(model).size() != projectile(model).nodes.size();
}

/// Number of the part that represents the projectile: the heaviest one at the start if parts touch, else the first.
template <class M> std::size_t main_part(const M &model) {
  std::size_t heaviest = 0;
  if (!parts_touch(model)) return heaviest;
  const auto mass_of = [&](std::size_t k) { return whole_mass(projectile(model, k).point_mass, model.symmetry); };
  for (std::size_t k = 1; k < model.bodies.projectile.size(); ++k)
    if (mass_of(k) > mass_of(heaviest)) heaviest = k;
  return heaviest;
}

/// True if a node of the projectile belongs to removed hexes alone: it flies on as a point.
template <class M> bool is_loose_node(const M &model, Index n) {
  bool is_loose = false;
  for (const auto &part : model.bodies.projectile) {
    if (n < part.nodes.begin || n >= part.nodes.end) continue;
    const Index own = n - part.nodes.begin;
    const std::vector<Index> &begin = part.corners_of_nodes.begin;
    if (begin[own] == begin[own + 1]) continue;
    if (!is_node_removed(part, own)) return false;
    is_loose = true;
  }
  return is_loose;
}

/// The nodes whose motion counts as that of part `k`: its own if parts touch, else those of the whole projectile; but
/// none that flies on as a point, unless all do.
template <class M> std::vector<Index> nodes_of_part(const M &model, std::size_t k) {
  const NodeRange range = projectile(model, k).nodes;
  std::vector<Index> list;
  list.reserve(static_cast<std::size_t>(range.size()));
  for (Index n = range.begin; n < range.end; ++n)
    if (!is_loose_node(model, n)) list.push_back(n);
  if (list.empty()) {
    list.resize(static_cast<std::size_t>(range.size()));
    std::iota(list.begin(), list.end(), range.begin);
  }
  return list;
}

/// The nodes whose motion counts as the projectile's: those of main_part(). A jacket may stay in the plate.
template <class M> std::vector<Index> followed_nodes(const M &model) { return nodes_of_part(model, main_part(model)); }

} // namespace ogive
