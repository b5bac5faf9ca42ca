// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ogive {

/// Points sorted into cubic cells, x fastest, so that cells which are neighbours in x are one contiguous range.
template <class T> struct CellGrid {
  Vec3<T> origin;                ///< least coordinates of the cells, m
  T inverse_size = T(0);         ///< 1 over the edge of a cell, 1/m
  std::array<Index, 3> cells{};  ///< number along x, y and z
  std::vector<Index> cell_begin; ///< number of cells + 1
  std::vector<Index> order;      ///< point of each sorted place
  std::vector<T> x, y, z;        ///< sorted positions, m
};

/// Sorts `positions` into cells not smaller than `size` (m); few, larger cells where the points are spread widely.
template <class T> CellGrid<T> sort_into_cells(const std::vector<Vec3<T>> &positions, T size) {
  const auto n = positions.size();
  Vec3<T> low = positions[0], high = positions[0];
  for (const auto &p : positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  CellGrid<T> grid;
  grid.origin = low;
  const double limit = 8.0 * static_cast<double>(n) + 4096.0;
  for (;; size *= T(1.5)) {
    double total = 1;
    for (int d = 0; d < 3; ++d) total *= std::floor(double(high[d] - low[d]) / double(size)) + 1.0;
    if (!(total > limit)) break;
  }
  grid.inverse_size = T(1) / size;
  for (int d = 0; d < 3; ++d) grid.cells[d] = static_cast<Index>((high[d] - low[d]) * grid.inverse_size) + 1;

  std::vector<Index> cell(n);
  grid.cell_begin.assign(static_cast<std::size_t>(grid.cells[0]) * grid.cells[1] * grid.cells[2] + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Index, 3> c;
    for (int d = 0; d < 3; ++d)
      c[d] = std::min(static_cast<Index>((positions[i][d] - low[d]) * grid.inverse_size), grid.cells[d] - 1);
    cell[i] = c[0] + grid.cells[0] * (c[1] + grid.cells[1] * c[2]);
    ++grid.cell_begin[cell[i] + 1];
  }
  for (std::size_t c = 1; c < grid.cell_begin.size(); ++c) grid.cell_begin[c] += grid.cell_begin[c - 1];
  std::vector<Index> next(grid.cell_begin.begin(), grid.cell_begin.end() - 1);
  grid.order.resize(n), grid.x.resize(n), grid.y.resize(n), grid.z.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Index k = next[cell[i]]++;
    grid.order[k] = static_cast<Index>(i);
    grid.x[k] = positions[i][0], grid.y[k] = positions[i][1], grid.z[k] = positions[i][2];
  }
  return grid;
}

/// Calls `f(k)` for each point k of the grid whose cell lies within `reach` (m) of the position `p` (m) in y and z, and
/// in x overlaps that range.
template <class T, class F> void for_each_candidate(const CellGrid<T> &grid, const Vec3<T> &p, T reach, F &&f) {
  std::array<Index, 3> first, last;
  for (int d = 0; d < 3; ++d) {
    const auto cell = [&](T x) {
      return static_cast<Index>(std::clamp((x - grid.origin[d]) * grid.inverse_size, T(0), T(grid.cells[d] - 1)));
    };
    first[d] = cell(p[d] - reach), last[d] = cell(p[d] + reach);
  }
  const T size = T(1) / grid.inverse_size;
  const auto gap = [&](int d, Index c) {
    const T from = grid.origin[d] + T(c) * size;
    return std::max({p[d] - (from + size), from - p[d], T(0)});
  };
  for (Index cz = first[2]; cz <= last[2]; ++cz)
    for (Index cy = first[1]; cy <= last[1]; ++cy) {
      // The last cell of a row may hold points beyond its own size only through round-off: a thousandth is room enough.
      if (gap(1, cy) * gap(1, cy) + gap(2, cz) * gap(2, cz) > T(1.002) * reach * reach) continue;
      const Index line = grid.cells[0] * (cy + grid.cells[1] * cz);
      for (Index k = grid.cell_begin[line + first[0]]; k < grid.cell_begin[line + last[0] + 1]; ++k) f(grid.order[k]);
    }
}

} // namespace ogive
