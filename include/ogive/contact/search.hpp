// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/near_slaves.hpp"
#include "ogive/contact/node_to_surface.hpp"
#include "ogive/search/box.hpp"
#include "ogive/search/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// Box around a facet, grown by `margin` (m).
template <class T> Box<T> facet_box(const Facet &facet, const Nodes<T> &nodes, T margin) {
  Box<T> box;
  for (Index n : facet.nodes) extend(box, nodes.position[n]);
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

/// Box around the displacements of the nodes of `list` from the positions `then` of all nodes (m).
template <class T>
Box<T> box_of_moves(const Nodes<T> &nodes, const std::vector<Vec3<T>> &then, const std::vector<Index> &list) {
  return box_of_moves<T>(static_cast<Index>(list.size()),
                         [&](Index i) { return Vec3<T>(nodes.position[list[i]] - then[list[i]]); });
}

/// True if a slave and a facet may have come closer by more than the search margin since the last search.
template <class T> bool is_search_due(const NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  if (contact.state.searched_at.size() != nodes.position.size()) return true;
  Box<T> moved = box_of_moves(nodes, contact.state.searched_at, contact.slaves);
  const Box<T> masters = box_of_moves(nodes, contact.state.searched_at, contact.masters);
  extend(moved, masters.low), extend(moved, masters.high);
  const T relative = (moved.high - moved.low).norm();
  return std::isfinite(relative) && relative > contact.search_margin;
}

/// Position (m) of a slave that is at `p`; of its mirror image if it was pushed across a mirror plane, where there are
/// no facets.
template <class T> Vec3<T> on_model_side(const NodeToSurface<T> &contact, const Vec3<T> &p) {
  return reflected(p, to_model_side(p, contact.symmetry));
}

/// on_model_side() of slave `s` among the positions of all nodes (m).
template <class T>
Vec3<T> on_model_side(const NodeToSurface<T> &contact, const std::vector<Vec3<T>> &positions, Index s) {
  return on_model_side(contact, positions[contact.slaves[s]]);
}

/// Finds, for each slave, the facets it can touch before the next search. Slaves that have some become near ones.
template <class T> void search(NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  contact.state.searched_at = nodes.position;
  contact.candidates.active.clear();
  contact.candidates.begin.clear();
  contact.candidates.facets.clear();

  T largest_offset{};
  for (T o : contact.offset) largest_offset = std::max(largest_offset, o);
  const T reach = std::max(largest_offset, contact.search_margin) + contact.search_margin;
  Box<T> surface;
  for (const Facet &f : contact.facets) {
    const Box<T> box = facet_box(f, nodes, reach);
    extend(surface, box.low), extend(surface, box.high);
  }
  std::vector<Index> near;
  std::vector<Vec3<T>> near_position;
  for (Index s = 0; s < static_cast<Index>(contact.slaves.size()); ++s) {
    if (const Vec3<T> p = on_model_side(contact, nodes.position, s); is_inside(surface, p)) {
      near.push_back(s);
      near_position.push_back(p);
    }
  }
  if (!near.empty()) {
    const CellGrid<T> grid = sort_into_cells(near_position, reach);
    struct Pair {
      Index slave, facet;
    };
    std::vector<Pair> pairs;
    for (Index f = 0; f < static_cast<Index>(contact.facets.size()); ++f) {
      const Box<T> box = facet_box(contact.facets[f], nodes, reach);
      std::array<Index, 3> c0, c1;
      for (int d = 0; d < 3; ++d) {
        const auto cell = [&](T x) {
          return static_cast<Index>(std::clamp((x - grid.origin[d]) * grid.inverse_size, T(-1), T(grid.cells[d])));
        };
        c0[d] = std::max(cell(box.low[d]), Index(0));
        c1[d] = std::min(cell(box.high[d]), grid.cells[d] - 1);
      }
      for (Index cz = c0[2]; cz <= c1[2]; ++cz)
        for (Index cy = c0[1]; cy <= c1[1]; ++cy) {
          const Index line = grid.cells[0] * (cy + grid.cells[1] * cz);
          if (c0[0] > c1[0]) continue;
          for (Index k = grid.cell_begin[line + c0[0]]; k < grid.cell_begin[line + c1[0] + 1]; ++k)
            if (is_inside(box, Vec3<T>(grid.x[k], grid.y[k], grid.z[k]))) pairs.push_back({near[grid.order[k]], f});
        }
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair &a, const Pair &b) { return a.slave != b.slave ? a.slave < b.slave : a.facet < b.facet; });
    for (const Pair &p : pairs) {
      if (contact.candidates.active.empty() || contact.candidates.active.back() != p.slave) {
        contact.candidates.active.push_back(p.slave);
        contact.candidates.begin.push_back(static_cast<Index>(contact.candidates.facets.size()));
      }
      contact.candidates.facets.push_back(p.facet);
    }
  }
  contact.candidates.begin.push_back(static_cast<Index>(contact.candidates.facets.size()));
  keep_near(contact);
}

} // namespace ogive
