// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/core/tile.hpp"
#include "ogive/core/types.hpp"
#include "ogive/search/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace ogive {

/// Square columns along z that share the points out to clusters of four. Points beyond the outermost columns belong to
/// those, so that few points that are far away do not make all columns wide.
template <class T> struct Columns {
  std::array<T, 2> origin{};      ///< least x and y of the columns, m
  T width{};                      ///< m
  std::array<Index, 2> count{};   ///< along x and y
  std::vector<Index> begin;       ///< first cluster of each column, y fastest, and the end
  std::vector<Index> order;       ///< point of each place; the last one again where a column's last cluster is not full
  std::vector<Box<T>> of_cluster; ///< box around the points of each cluster, m
};

/// A width of columns (m) in which clusters of particles at a distance of `spacing` (m) are compact: with it the lists
/// of an undeformed plate are shortest, within a few per cent.
template <class T> T column_width(T spacing) { return T(1.8) * spacing; }

/// Number of the column along x (axis 0) or y (axis 1) in which a coordinate (m) lies.
template <class T> Index column_at(const Columns<T> &columns, int axis, T coordinate) {
  const T at = (coordinate - columns.origin[axis]) / columns.width;
  return static_cast<Index>(std::clamp(at, T(0), T(columns.count[axis] - 1)));
}

/// Columns of the width `width` (m) over the points at `positions` (m); around their mean if they are spread so widely
/// that there would be more than four columns for each point.
template <class T> Columns<T> lay_columns(std::span<const Vec3<T>> positions, T width) {
  Box<T> box;
  Vec3<T> sum = Vec3<T>::Zero();
  for (const Vec3<T> &x : positions) extend(box, x), sum += x;
  const T points = static_cast<T>(positions.size());
  const T most = std::max(T(16), std::floor(T(2) * std::sqrt(points)));
  Columns<T> columns;
  columns.width = width;
  for (int axis = 0; axis < 2; ++axis) {
    const T wanted = std::floor((box.high[axis] - box.low[axis]) / width) + T(1);
    columns.count[axis] = static_cast<Index>(std::min(wanted, most));
    columns.origin[axis] = wanted <= most ? box.low[axis] : sum[axis] / points - T(0.5) * most * width;
  }
  return columns;
}

/// Sorts the points at `positions` (m) into columns of the width `width` (m), by z within a column and by their number
/// where z is the same, and cuts the columns into clusters.
template <class T> Columns<T> sort_into_columns(std::span<const Vec3<T>> positions, T width) {
  if (positions.empty()) return {};
  Columns<T> columns = lay_columns(positions, width);
  const Index n = static_cast<Index>(positions.size()), total = columns.count[0] * columns.count[1];
  std::vector<Index> column(n), points_in(total, 0);
  parallel_for(n, [&](Index i) {
    column[i] = column_at(columns, 0, positions[i][0]) * columns.count[1] + column_at(columns, 1, positions[i][1]);
  });
  for (const Index c : column) ++points_in[c];
  columns.begin.resize(total + 1, 0);
  for (Index c = 0; c < total; ++c)
    columns.begin[c + 1] = columns.begin[c] + (points_in[c] + cluster_size - 1) / cluster_size;
  columns.order.resize(static_cast<std::size_t>(columns.begin[total]) * cluster_size);
  columns.of_cluster.resize(columns.begin[total]);
  std::vector<Index> next(total);
  for (Index c = 0; c < total; ++c) next[c] = columns.begin[c] * cluster_size;
  for (Index i = 0; i < n; ++i) columns.order[next[column[i]]++] = i;
  parallel_for_chunks(total, 16, [&](Index first, Index last) {
    for (Index c = first; c < last; ++c) {
      if (points_in[c] == 0) continue;
      const auto from = columns.order.begin() + columns.begin[c] * cluster_size, to = from + points_in[c];
      std::sort(from, to, [&](Index a, Index b) {
        const T za = positions[a][2], zb = positions[b][2];
        return za != zb ? za < zb : a < b;
      });
      std::fill(to, columns.order.begin() + columns.begin[c + 1] * cluster_size, *(to - 1));
      for (Index k = columns.begin[c]; k < columns.begin[c + 1]; ++k)
        for (Index l = 0; l < cluster_size; ++l)
          extend(columns.of_cluster[k], positions[columns.order[k * cluster_size + l]]);
    }
  });
  return columns;
}

/// Box around the points of a column, m.
template <class T> Box<T> box_of_column(const Columns<T> &columns, Index column) {
  Box<T> box;
  for (Index c = columns.begin[column]; c < columns.begin[column + 1]; ++c)
    extend(box, columns.of_cluster[c].low), extend(box, columns.of_cluster[c].high);
  return box;
}

/// A column that is near another one.
template <class T> struct NearColumn {
  Index next{}; ///< first cluster that may be near those that are still to come
  Index end{};  ///< of its clusters
  T half{};     ///< distance along z within which its clusters can be near, m
};

/// The columns with points within `reach` (m) of `box`.
template <class T>
std::vector<NearColumn<T>> near_columns(const Columns<T> &columns, std::span<const Box<T>> of_column, const Box<T> &box,
                                        T reach) {
  std::array<Index, 2> first, last;
  for (int axis = 0; axis < 2; ++axis) {
    first[axis] = column_at(columns, axis, box.low[axis] - reach);
    last[axis] = column_at(columns, axis, box.high[axis] + reach);
  }
  std::vector<NearColumn<T>> near;
  for (Index cx = first[0]; cx <= last[0]; ++cx)
    for (Index cy = first[1]; cy <= last[1]; ++cy) {
      const Index column = cx * columns.count[1] + cy;
      if (columns.begin[column] == columns.begin[column + 1]) continue;
      const Box<T> &other = of_column[column];
      T left = reach * reach;
      for (int d = 0; d < 2; ++d) {
        const T gap = std::max({box.low[d] - other.high[d], other.low[d] - box.high[d], T(0)});
        left -= gap * gap;
      }
      if (left >= T(0)) near.push_back({columns.begin[column], columns.begin[column + 1], std::sqrt(left)});
    }
  return near;
}

} // namespace ogive
