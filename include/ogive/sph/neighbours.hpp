#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ogive {

/// Mirror image of a particle: `flip_x` mirrors at x = 0, `flip_y` at y = 0.
struct MirrorImage {
  Index parent = 0;
  bool flip_x = false;
  bool flip_y = false;
};

/// Rows of a neighbour list are padded to a multiple of this with the particle itself, which contributes nothing.
inline constexpr Index row_multiple = 8;

/// Neighbour lists (CSR): row i lists all particles and mirror images within `reach` of particle i when the lists were
/// built; index n + g is mirror image g.
template <class T> struct Neighbours {
  std::vector<std::int64_t> row_begin; ///< n + 1
  std::vector<Index> list;
  std::vector<MirrorImage> images;
  std::vector<Vec3<T>> built_at; ///< positions at the time of building, m
  T support = T(0);              ///< distance within which the lists must be complete, m
  T reach = T(0);                ///< support plus skin, m
};

/// Row of particle i.
template <class T> std::span<const Index> row(const Neighbours<T> &n, Index i) {
  return {n.list.data() + n.row_begin[i], static_cast<std::size_t>(n.row_begin[i + 1] - n.row_begin[i])};
}

/// Position of a mirror image, m.
template <class T> Vec3<T> mirrored(const Vec3<T> &x, const MirrorImage &image) {
  return {image.flip_x ? -x[0] : x[0], image.flip_y ? -x[1] : x[1], x[2]};
}

/// Particles and images sorted into cubic cells, x fastest, so that three neighbouring cells are one contiguous range.
template <class T> struct CellGrid {
  Vec3<T> origin;
  T inverse_size = T(0);
  std::array<Index, 3> cells{};
  std::vector<Index> cell_begin; ///< number of cells + 1
  std::vector<Index> order;      ///< particle or image of each sorted place
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

/// Appends to `found` all points of the grid within `reach` of `p` except `self`, in the grid's order.
template <class T>
void append_within(const CellGrid<T> &grid, const Vec3<T> &p, T reach, Index self, std::vector<Index> &found) {
  std::array<Index, 3> c;
  for (int d = 0; d < 3; ++d)
    c[d] = std::clamp(static_cast<Index>((p[d] - grid.origin[d]) * grid.inverse_size), Index(0), grid.cells[d] - 1);
  const Index x0 = std::max(c[0] - 1, 0), x1 = std::min(c[0] + 1, grid.cells[0] - 1);
  const T reach2 = reach * reach;
  for (Index cz = std::max(c[2] - 1, 0); cz <= std::min(c[2] + 1, grid.cells[2] - 1); ++cz)
    for (Index cy = std::max(c[1] - 1, 0); cy <= std::min(c[1] + 1, grid.cells[1] - 1); ++cy) {
      const Index line = grid.cells[0] * (cy + grid.cells[1] * cz);
      const Index begin = grid.cell_begin[line + x0], end = grid.cell_begin[line + x1 + 1];
      auto count = found.size();
      found.resize(count + static_cast<std::size_t>(end - begin));
      for (Index k = begin; k < end; ++k) {
        const T dx = grid.x[k] - p[0], dy = grid.y[k] - p[1], dz = grid.z[k] - p[2];
        found[count] = grid.order[k];
        count += (dx * dx + dy * dy + dz * dz < reach2) & (grid.order[k] != self);
      }
      found.resize(count);
    }
}

/// Mirror images of all particles that another one can have within `reach` (m). A particle may have been pushed across
/// a plane: the reach is longer by as far as the furthest one lies behind it, so that pairs find each other both ways.
template <class T>
std::vector<MirrorImage> mirror_images(std::span<const Vec3<T>> positions, SymmetryPlanes planes, T reach) {
  Vec3<T> behind = Vec3<T>::Zero();
  for (const Vec3<T> &x : positions) behind = behind.cwiseMax(-x);
  std::vector<MirrorImage> images;
  const auto add = [&](bool flip_x, bool flip_y) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      if ((!flip_x || positions[i][0] < reach + behind[0]) && (!flip_y || positions[i][1] < reach + behind[1]))
        images.push_back({static_cast<Index>(i), flip_x, flip_y});
  };
  if (planes.x) add(true, false);
  if (planes.y) add(false, true);
  if (planes.x && planes.y) add(true, true);
  return images;
}

/// Builds the lists anew: complete within `support` (m) until two particles have moved by more than `skin` (m) relative
/// to each other.
template <class T>
void build_neighbours(Neighbours<T> &n, std::span<const Vec3<T>> positions, SymmetryPlanes planes, T support, T skin) {
  n.support = support;
  n.reach = support + skin;
  n.images = mirror_images(positions, planes, n.reach);
  n.built_at.assign(positions.begin(), positions.end());
  std::vector<Vec3<T>> all(positions.begin(), positions.end());
  for (const MirrorImage &image : n.images) all.push_back(mirrored(all[image.parent], image));
  const CellGrid<T> grid = sort_into_cells(all, n.reach);

  const Index count = static_cast<Index>(positions.size());
  constexpr Index chunk = 256;
  std::vector<std::vector<Index>> chunk_rows((count + chunk - 1) / chunk);
  n.row_begin.assign(count + 1, 0);
  parallel_for_chunks(count, chunk, [&](Index begin, Index end) {
    auto &rows = chunk_rows[begin / chunk];
    rows.reserve(static_cast<std::size_t>(end - begin) * 128);
    for (Index i = begin; i < end; ++i) {
      append_within(grid, all[i], n.reach, i, rows);
      while (rows.size() % row_multiple) rows.push_back(i);
      n.row_begin[i + 1] = static_cast<std::int64_t>(rows.size());
    }
  });
  std::int64_t offset = 0;
  for (Index begin = 0; begin < count; begin += chunk) {
    const Index end = std::min(count, begin + chunk);
    for (Index i = begin; i < end; ++i) n.row_begin[i + 1] += offset;
    offset = n.row_begin[end];
  }
  n.list.resize(static_cast<std::size_t>(offset));
  parallel_for_chunks(count, chunk, [&](Index begin, Index) {
    const auto &rows = chunk_rows[begin / chunk];
    std::copy(rows.begin(), rows.end(), n.list.begin() + n.row_begin[begin]);
  });
}

/// True if the lists may miss a neighbour: some two particles may have moved by more than the skin relative to each
/// other. No two displacements differ by more than the diagonal of the box around all of them, images included.
template <class T>
bool are_stale(const Neighbours<T> &n, std::span<const Vec3<T>> positions, SymmetryPlanes planes, T support) {
  if (n.built_at.size() != positions.size()) return true;
  struct Box {
    Vec3<T> low, high;
  };
  const Box box = ordered_fold(
      static_cast<Index>(positions.size()), Box{Vec3<T>::Constant(1e30), Vec3<T>::Constant(-1e30)},
      [&](Index i) {
        const Vec3<T> u = positions[i] - n.built_at[i];
        return Box{u, u};
      },
      [](const Box &a, const Box &b) {
        // Written so that a NaN stays: lists of such positions must not be built.
        Box c = a;
        for (int d = 0; d < 3; ++d) {
          if (!(b.low[d] >= a.low[d]) && a.low[d] == a.low[d]) c.low[d] = b.low[d];
          if (!(b.high[d] <= a.high[d]) && a.high[d] == a.high[d]) c.high[d] = b.high[d];
        }
        return c;
      });
  Vec3<T> extent = box.high - box.low;
  if (planes.x) extent[0] = std::max(extent[0], T(2) * std::max(box.high[0], -box.low[0]));
  if (planes.y) extent[1] = std::max(extent[1], T(2) * std::max(box.high[1], -box.low[1]));
  const T relative = extent.norm();
  return std::isfinite(relative) && relative > n.reach - support;
}

} // namespace ogive
