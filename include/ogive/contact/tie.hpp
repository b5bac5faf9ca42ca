// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/closest_point.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/mesh/hex_geometry.hpp"
#include "ogive/mesh/hex_mesh.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace ogive {

/// A slave node that follows the hex behind the facet it is tied to: x = sum w_a x_a over the hex's eight corners. The
/// weights reproduce linear fields, so that a constant strain passes.
template <class T> struct TiedNode {
  Index slave = 0;                ///< node that follows
  std::array<Index, 8> masters{}; ///< nodes of the hex
  std::array<T, 8> weights{};     ///< of the masters; they add up to one
};

/// A master node and the slaves that hang on it: tied node `first` to `last` of the list `tied`.
struct TieMaster {
  Index node = 0;            ///< the master
  Index first = 0, last = 0; ///< of Tie::shares, last excluded
};

/// One slave of a master: the tied node and the corner of its hex.
struct TieShare {
  Index tied = 0; ///< index into Tie::nodes
  int corner = 0; ///< of that hex, 0 to 7
};

/// Kinematic tie: slaves follow, their forces and masses go to the masters.
template <class T> struct Tie {
  std::vector<TiedNode<T>> nodes; ///< the slaves
  std::vector<TieMaster> masters; ///< nodes that carry them
  std::vector<TieShare> shares;   ///< grouped by master, so that each master gathers its own
};

/// Ties every node of `slaves` that lies within `distance` (m) of one of the `facets` to the hex behind the nearest
/// one, and moves its mass to the hex's nodes. `hexes` are the corners of all hexes that the facets name. Throws
/// SetupError if no node is near, or if a master would lose more than half of its mass.
template <class T>
Tie<T> make_tie(Nodes<T> &nodes, NodeRange slaves, const std::vector<Facet> &facets,
                const std::vector<std::array<Index, 8>> &hexes, T distance) {
  std::vector<Index> nearest(slaves.size(), -1);
  parallel_for(slaves.size(), [&](Index i) {
    const Vec3<T> &p = nodes.position[slaves.begin + i];
    T best = distance * distance;
    for (Index f = 0; f < static_cast<Index>(facets.size()); ++f) {
      std::array<Vec3<T>, 4> corner;
      T far2{};
      for (int c = 0; c < 4; ++c) corner[c] = nodes.position[facets[f].nodes[c]];
      for (int c = 0; c < 4; ++c) far2 = std::max(far2, (corner[c] - corner[0]).squaredNorm());
      const T limit = distance + std::sqrt(far2);
      if ((p - corner[0]).squaredNorm() > limit * limit) continue;
      if (const T d2 = closest_on_facet(p, corner).distance_squared; d2 <= best) {
        if (d2 == best && nearest[i] >= 0) continue;
        best = d2;
        nearest[i] = f;
      }
    }
  });

  Tie<T> tie;
  for (Index i = 0; i < slaves.size(); ++i) {
    if (nearest[i] < 0) continue;
    TiedNode<T> tied;
    tied.slave = slaves.begin + i;
    tied.masters = hexes[facets[nearest[i]].hex];
    Corners<T> corners;
    for (int c = 0; c < 8; ++c) corners.row(c) = nodes.position[tied.masters[c]].transpose();
    const auto weights = shape_functions<T>(natural_coordinates<T>(corners, nodes.position[tied.slave]));
    for (int c = 0; c < 8; ++c) tied.weights[c] = weights[c];
    tie.nodes.push_back(tied);
  }
  require(!tie.nodes.empty(), "tie distance (m)", distance, "no slave node lies that near to the facets");

  struct Entry {
    Index master;
    TieShare share;
  };
  std::vector<Entry> entries;
  for (Index t = 0; t < static_cast<Index>(tie.nodes.size()); ++t)
    for (int c = 0; c < 8; ++c) entries.push_back({tie.nodes[t].masters[c], {t, c}});
  std::stable_sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) { return a.master < b.master; });
  for (const Entry &e : entries) {
    const Index at = static_cast<Index>(tie.shares.size());
    if (tie.masters.empty() || tie.masters.back().node != e.master) tie.masters.push_back({e.master, at, at});
    tie.shares.push_back(e.share);
    ++tie.masters.back().last;
  }
  for (const TieMaster &m : tie.masters) {
    T gained{};
    for (Index s = m.first; s < m.last; ++s)
      gained +=
          tie.nodes[tie.shares[s].tied].weights[tie.shares[s].corner] * nodes.mass[tie.nodes[tie.shares[s].tied].slave];
    require(gained > T(-0.5) * nodes.mass[m.node], "tie distance (m)", distance,
            "too large for the hexes behind the facets: a master node would lose more than half of its mass");
    nodes.mass[m.node] += gained;
  }
  for (const TiedNode<T> &t : tie.nodes) nodes.mass[t.slave] = T(0);
  return tie;
}

/// Moves the forces of the slaves to their masters.
template <class T> void hand_over_forces(const Tie<T> &tie, Nodes<T> &nodes) {
  parallel_for(static_cast<Index>(tie.masters.size()), [&](Index m) {
    Vec3<T> f = Vec3<T>::Zero();
    for (Index s = tie.masters[m].first; s < tie.masters[m].last; ++s) {
      const TiedNode<T> &t = tie.nodes[tie.shares[s].tied];
      f += t.weights[tie.shares[s].corner] * nodes.force[t.slave];
    }
    nodes.force[tie.masters[m].node] += f;
  });
  parallel_for(static_cast<Index>(tie.nodes.size()),
               [&](Index t) { nodes.force[tie.nodes[t].slave] = Vec3<T>::Zero(); });
}

/// Puts the slaves where their masters carry them, with the masters' velocity.
template <class T> void move_slaves(const Tie<T> &tie, Nodes<T> &nodes) {
  parallel_for(static_cast<Index>(tie.nodes.size()), [&](Index i) {
    const TiedNode<T> &t = tie.nodes[i];
    Vec3<T> x = Vec3<T>::Zero(), v = Vec3<T>::Zero();
    for (int c = 0; c < 8; ++c) {
      x += t.weights[c] * nodes.position[t.masters[c]];
      v += t.weights[c] * nodes.velocity[t.masters[c]];
    }
    nodes.position[t.slave] = x;
    nodes.velocity[t.slave] = v;
  });
}

} // namespace ogive
