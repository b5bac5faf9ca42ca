// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/search/columns.hpp"
#include "ogive/search/mirror_image.hpp"
#include "ogive/search/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace ogive {

/// Gives the memory of an array back; `values = {}` would keep it.
template <class V> void release(std::vector<V> &values) { std::vector<V>().swap(values); }

/// Makes room for `size` values, which are then unspecified. Growth by doubling would keep room for twice as many.
template <class V> void resize_tightly(std::vector<V> &values, std::size_t size) {
  if (values.capacity() < size) {
    release(values);
    values.reserve(size + size / 16);
  }
  values.resize(size);
}

/// A length (m) in whole quanta of `quantum` (m); one that is no number is 0.
template <class T> std::int32_t in_quanta(T length, T quantum) {
  constexpr T most = T(1 << 30);
  const T quanta = length / quantum;
  if (!(quanta == quanta)) return 0;
  return static_cast<std::int32_t>(std::lrint(std::clamp(quanta, -most, most)));
}

/// Coordinates of places in quanta, one array for each axis.
using FixedPositions = std::array<std::vector<std::int32_t>, 3>;

/// A power of two, m, of which all coordinates of the points at `positions` (m) and `least` (m) are less than 2^29.
template <class T> T quantum_for(std::span<const Vec3<T>> positions, T least) {
  T furthest = least;
  for (const Vec3<T> &x : positions) furthest = std::max(furthest, x.cwiseAbs().maxCoeff());
  return std::ldexp(T(1), std::ilogb(furthest) - 28);
}

/// Mirror images of all clusters that a particle can have within reach, and the first place of each, by reflection and
/// cluster; -1 where there is none. A particle may have been pushed across a plane: see mirror_images().
template <class T>
std::array<std::vector<Index>, 4> find_images(Neighbours<T> &n, std::span<const Vec3<T>> positions,
                                              const Columns<T> &columns, SymmetryPlanes planes) {
  // A little longer, so that no pair is missed by round-off.
  const Vec3<T> reach = furthest_behind(positions) + Vec3<T>::Constant(n.reach * T(1.0001) + T(4) * n.quantum);
  std::array<std::vector<Index>, 4> place;
  n.images.clear();
  for_each_reflection(planes, [&](Reflection in) {
    auto &places = place[in.x + 2 * in.y];
    for (Index c = 0; c < static_cast<Index>(columns.of_cluster.size()); ++c) {
      const Vec3<T> &low = columns.of_cluster[c].low;
      const bool near = (!in.x || low[0] < reach[0]) && (!in.y || low[1] < reach[1]);
      const std::size_t first = n.order.size() + n.images.size() * cluster_size;
      places.push_back(near ? static_cast<Index>(first) : -1);
      if (near) n.images.push_back({c, in});
    }
  });
  return place;
}

/// A box as the mirrors show it.
template <class T> Box<T> reflected(const Box<T> &box, Reflection reflection) {
  const Vec3<T> a = reflected(box.low, reflection), b = reflected(box.high, reflection);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

/// The input of the search for neighbours.
template <class T, class Width = SimdWidth> struct Search {
  const Columns<T> &columns;     ///< of all clusters
  std::vector<Box<T>> of_column; ///< box around the points of each column, m
  FixedPositions x;              ///< of the places
  T reach{};                     ///< m
  float reach_squared{};         ///< quanta squared, a little more: the test is done in single precision
};

/// Columns near a column's clusters under one reflection of the clusters.
template <class T> struct Side {
  Reflection reflection{};           ///< of the clusters whose neighbours are searched for
  std::vector<NearColumn<T>> near{}; ///< columns that may hold neighbours
  std::span<const Index> place_of{}; ///< first place of each cluster, of its image for a reflection; empty: 4 k
};

/// Appends to `row` the first places of all groups that have a particle within reach of one of cluster c. The clusters
/// of a column must come in their order: the sides remember how far they have got.
template <class T>
void append_row(const Search<T> &search, Index c, std::vector<Side<T>> &sides, std::vector<Index> &row) {
  const std::vector<Box<T>> &boxes = search.columns.of_cluster;
  const T low = boxes[c].low[2], high = boxes[c].high[2];
  for (Side<T> &side : sides) {
    std::array<FixedPack<>, 3> members;
    for (int d = 0; d < 3; ++d) members[d] = spread(&search.x[d][c * cluster_size]);
    if (side.reflection.x) members[0].v = -members[0].v;
    if (side.reflection.y) members[1].v = -members[1].v;
    for (NearColumn<T> &other : side.near) {
      // Clusters of a column follow each other along z, here and there.
      while (other.next < other.end && boxes[other.next].high[2] < low - other.half) ++other.next;
      Index last = other.next;
      while (last < other.end && boxes[last].low[2] <= high + other.half) ++last;
      std::size_t count = row.size();
      row.resize(count + static_cast<std::size_t>((last - other.next) * cluster_size / group_size<>));
      for (Index k = other.next; k < last; ++k)
        for (Index first = 0; first < cluster_size; first += group_size<>) {
          const auto difference = [&](int d) { return members[d] - repeat(&search.x[d][k * cluster_size + first]); };
          const Pack<float> dx = difference(0), dy = difference(1), dz = difference(2);
          row[count] = (side.place_of.empty() ? k * cluster_size : side.place_of[k]) + first;
          count += any_below(dx * dx + dy * dy + dz * dz, Pack<float>(search.reach_squared));
        }
      row.resize(count);
    }
  }
}

/// Columns whose neighbours are searched for before the next ones: enough for many threads.
inline constexpr Index least_columns_at_once = 128;

/// Makes room in the list for the first `done` clusters, and for the others if their rows are as long: so the list is
/// moved in memory early, while it is short, or not at all.
template <class T> void make_room(Neighbours<T> &n, Index done) {
  const auto listed = static_cast<std::size_t>(n.cluster_begin[done]);
  const auto all = static_cast<std::size_t>(static_cast<double>(listed) * clusters(n) / std::max(done, Index(1)));
  if (n.list.capacity() < all) {
    n.list.resize(std::min(n.list.size(), listed));
    n.list.reserve(all + all / 16);
  }
  if (n.list.size() < listed) n.list.resize(listed);
}

/// Builds the lists anew: complete within `support` (m) until two particles have moved by more than `skin` (m) relative
/// to each other.
template <class T>
void build_neighbours(Neighbours<T> &n, std::span<const Vec3<T>> positions, SymmetryPlanes planes, T support, T skin) {
  n.support = support;
  n.reach = support + skin;
  n.quantum = quantum_for(positions, n.reach);
  n.built_at.assign(positions.begin(), positions.end());
  n.listed = static_cast<Index>(positions.size());
  // The support of the default smoothing length is 2.4 particle distances.
  Columns<T> columns = sort_into_columns(positions, column_width(support / T(2.4)));
  n.order = std::move(columns.order);
  while (n.order.size() % block_size<>) n.order.push_back(n.order.back());
  const auto image_place = find_images(n, positions, columns, planes);
  const Index total = static_cast<Index>(columns.begin.size()) - 1;
  const float reach = static_cast<float>(n.reach / n.quantum * T(1 + 1e-5) + T(2));
  Search<T> search{columns, std::vector<Box<T>>(total), {}, n.reach, reach * reach};
  for (auto &x : search.x) x.resize(n.order.size());
  parallel_for(static_cast<Index>(n.order.size()), [&](Index k) {
    for (int d = 0; d < 3; ++d) search.x[d][k] = in_quanta(positions[n.order[k]][d], n.quantum);
  });
  parallel_for(total, [&](Index column) { search.of_column[column] = box_of_column(columns, column); });

  n.cluster_begin.assign(clusters(n) + 1, 0);
  const auto find_rows = [&](Index column, std::vector<Index> &rows) {
    rows.clear();
    const auto near = [&](Reflection in) {
      return near_columns(columns, std::span<const Box<T>>(search.of_column), reflected(search.of_column[column], in),
                          n.reach);
    };
    std::vector<Side<T>> sides;
    if (columns.begin[column] < columns.begin[column + 1]) sides.push_back({{}, near({}), {}});
    // The image of another cluster is as near to this one as the other to the image of this one.
    for_each_reflection(planes, [&](Reflection in) {
      Side<T> side{in, near(in), image_place[in.x + 2 * in.y]};
      if (!side.near.empty()) sides.push_back(std::move(side));
    });
    for (Index c = columns.begin[column]; c < columns.begin[column + 1]; ++c) {
      const std::size_t before = rows.size();
      append_row(search, c, sides, rows);
      n.cluster_begin[c + 1] = static_cast<std::int64_t>(rows.size() - before);
    }
  };
  // Some columns at a time: the rows of all of them would take more memory than the list.
  const Index at_once = std::max(least_columns_at_once, total / 16);
  std::vector<std::vector<Index>> rows(std::min(total, at_once));
  for (Index first = 0; first < total; first += at_once) {
    const Index last = std::min(total, first + at_once);
    parallel_for_chunks(last - first, 1, [&](Index k, Index) { find_rows(first + k, rows[k]); });
    for (Index c = columns.begin[first]; c < columns.begin[last]; ++c) n.cluster_begin[c + 1] += n.cluster_begin[c];
    make_room(n, columns.begin[last]);
    parallel_for(last - first, [&](Index k) {
      std::copy(rows[k].begin(), rows[k].end(), n.list.begin() + n.cluster_begin[columns.begin[first + k]]);
    });
  }
  for (Index c = columns.begin[total]; c < clusters(n); ++c) n.cluster_begin[c + 1] += n.cluster_begin[c];
  const auto listed = static_cast<std::size_t>(n.cluster_begin.back());
  n.list.resize(listed);
  n.within.assign(listed / 64 + static_cast<std::size_t>(clusters(n)) + 1, 0);
}

/// True if the lists may miss a neighbour: some two particles may have moved by more than the skin relative to each
/// other; or if coordinates may have left the range of the quanta.
template <class T>
bool are_stale(const Neighbours<T> &n, std::span<const Vec3<T>> positions, SymmetryPlanes planes, T support) {
  if (n.built_at.size() != positions.size()) return true;
  if (n.order.empty()) return false;
  const auto move = [&](Index k) { return Vec3<T>(positions[n.order[k]] - n.built_at[n.order[k]]); };
  const Box<T> moves = box_of_moves<T>(static_cast<Index>(n.order.size()), move);
  const T relative = largest_relative_move(moves, planes);
  const T furthest = moves.low.cwiseAbs().cwiseMax(moves.high.cwiseAbs()).maxCoeff();
  return std::isfinite(relative) && (relative > n.reach - support || furthest > std::ldexp(n.quantum, 29));
}

} // namespace ogive
