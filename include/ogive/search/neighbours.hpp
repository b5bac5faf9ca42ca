// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/search/box.hpp"
#include "ogive/search/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace ogive {

/// Mirror image of a particle.
struct MirrorImage {
  Index parent = 0;        ///< particle
  Index place = 0;         ///< of the parent
  Reflection reflection{}; ///< that makes the image
};

/// Neighbour lists of clusters: `lanes<T>` particles that lie close together share one list, so that a loop works on
/// all of them at once with one neighbour after the other. Particles have places along a curve that keeps near ones
/// together; cluster c has the places from c * lanes<T>. Mirror images have the places behind all clusters.
template <class T, class Width = SimdWidth> struct Neighbours {
  std::vector<Index> order;                ///< particle of each place; the last cluster is filled up with its last one
  Index listed = 0;                        ///< number of particles in the lists
  std::vector<MirrorImage> images;         ///< image g has the place order.size() + g
  std::vector<std::int64_t> cluster_begin; ///< number of clusters + 1
  std::vector<Index> list;                 ///< places
  std::vector<std::uint64_t> within;       ///< a bit for each entry: within the support in this step
  std::vector<Vec3<T>> built_at;           ///< positions at the time of building, m
  T support = T(0);                        ///< distance within which the lists must be complete, m
  T reach = T(0);                          ///< support plus skin, m
};

/// Number of clusters.
template <class T> Index clusters(const Neighbours<T> &n) { return static_cast<Index>(n.order.size()) / lanes<T>; }

/// Places of all particles and images within reach of some particle of cluster c, the cluster's own ones included.
template <class T> std::span<const Index> row(const Neighbours<T> &n, Index c) {
  return {n.list.data() + n.cluster_begin[c], static_cast<std::size_t>(n.cluster_begin[c + 1] - n.cluster_begin[c])};
}

/// The bits of cluster c, 64 entries of its row to a word.
template <class N> auto bits(N &n, Index c) { return n.within.begin() + (n.cluster_begin[c] / 64 + c); }

/// Writes the bits of a cluster, entry by entry.
template <class Words> struct BitWriter {
  Words word;             ///< where the next word goes
  std::uint64_t bits = 0; ///< of the word that is being filled
  int count = 0;          ///< of them
  /// Appends a bit.
  void push(bool bit) {
    bits |= std::uint64_t(bit) << count;
    if (++count == 64) *word++ = std::exchange(bits, 0), count = 0;
  }
  /// Writes a word that is not full; to be called last.
  void finish() {
    if (count > 0) *word = bits;
  }
};

// Clang deduces the arguments of aggregates from version 17 on.
/// Deduced from the words.
template <class Words> BitWriter(Words) -> BitWriter<Words>;

/// The entries of a row whose bits are set.
template <class Words> struct SetEntries {
  /// Behind the last entry.
  struct End {};
  /// Goes from one set bit to the next.
  struct Iterator {
    const Index *places; ///< of the present word's first entry
    const Index *last;   ///< end of the row
    Words word;          ///< where the next word goes
    std::uint64_t bits;  ///< of the present word that are left
    /// The place.
    Index operator*() const { return places[std::countr_zero(bits)]; }
    /// On to the next.
    Iterator &operator++() { return bits &= bits - 1, skip_empty(), *this; }
    /// Whether there is an entry.
    bool operator!=(End) const { return places < last; }
    /// On to a word that has a bit.
    void skip_empty() {
      while (bits == 0 && (places += 64) < last) bits = *++word;
    }
  };
  std::span<const Index> places; ///< the row
  Words words;                   ///< its bits
  /// The first set entry.
  Iterator begin() const {
    Iterator first{places.data(), places.data() + places.size(), words, places.empty() ? 0 : *words};
    return first.skip_empty(), first;
  }
  /// Behind the last one.
  End end() const { return {}; }
};

/// Deduced from the words.
template <class Words> SetEntries(std::span<const Index>, Words) -> SetEntries<Words>;

/// The places within the support of some particle of cluster c, as the last velocity gradient found them.
template <class T> auto row_within(const Neighbours<T> &n, Index c) { return SetEntries{row(n, c), bits(n, c)}; }

/// Calls `f(i, j)` once for each two particles i < j that a list brings together, and maybe for some farther apart.
template <class T, class F> void for_each_neighbour_pair(const Neighbours<T> &n, F &&f) {
  const Index places = static_cast<Index>(n.order.size()), count = n.listed;
  for (Index c = 0; c < clusters(n); ++c)
    for (Index k = c * lanes<T>; k < std::min(count, (c + 1) * lanes<T>); ++k)
      for (const Index place : row(n, c))
        if (place < places && n.order[k] < n.order[place]) f(n.order[k], n.order[place]);
}

/// The particles sorted into columns along z of the width `width` (m) or wider, and by z within: near ones are close
/// together in memory.
template <class T> std::vector<Index> column_order(std::span<const Vec3<T>> positions, T width) {
  Vec3<T> low = positions[0], high = positions[0];
  for (const auto &p : positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const T inverse = T(1) / std::max(width, (high - low).maxCoeff() / T(60000));
  struct Place {
    std::uint32_t column;
    T z;
    Index particle;
  };
  const Index n = static_cast<Index>(positions.size());
  std::vector<Place> places(n);
  parallel_for(n, [&](Index i) {
    const Vec3<T> p = (positions[i] - low) * inverse;
    places[i] = {static_cast<std::uint32_t>(p[0]) << 16 | static_cast<std::uint32_t>(p[1]), p[2], i};
  });
  std::sort(places.begin(), places.end(), [](const Place &a, const Place &b) {
    return a.column != b.column ? a.column < b.column : a.z != b.z ? a.z < b.z : a.particle < b.particle;
  });
  std::vector<Index> order(n);
  for (Index k = 0; k < n; ++k) order[k] = places[k].particle;
  return order;
}

/// Points that may be near a cluster, in a multiple of a pack.
template <class T, class Width = SimdWidth> struct Candidates {
  std::vector<Index> place; ///< of each point
  std::vector<T> x, y, z;   ///< m
};

/// The points of the grid whose cells lie within `reach` of the box from `low` to `high` (m).
template <class T>
void gather_candidates(const CellGrid<T> &grid, const Vec3<T> &low, const Vec3<T> &high, T reach,
                       Candidates<T> &found) {
  std::array<Index, 3> first, last;
  for (int d = 0; d < 3; ++d) {
    const auto cell = [&](T x) {
      return static_cast<Index>(std::clamp((x - grid.origin[d]) * grid.inverse_size, T(0), T(grid.cells[d] - 1)));
    };
    first[d] = cell(low[d] - reach), last[d] = cell(high[d] + reach);
  }
  found.place.clear(), found.x.clear(), found.y.clear(), found.z.clear();
  const T size = T(1) / grid.inverse_size;
  const auto gap = [&](int d, Index c) {
    const T from = grid.origin[d] + T(c) * size;
    return std::max({low[d] - (from + size), from - high[d], T(0)});
  };
  for (Index cz = first[2]; cz <= last[2]; ++cz)
    for (Index cy = first[1]; cy <= last[1]; ++cy) {
      // The last cell of a row may hold points beyond its own size only through round-off: a thousandth is room enough.
      const T gap2 = gap(1, cy) * gap(1, cy) + gap(2, cz) * gap(2, cz);
      if (gap2 > T(1.002) * reach * reach) continue;
      const Index line = grid.cells[0] * (cy + grid.cells[1] * cz);
      const Index begin = grid.cell_begin[line + first[0]], end = grid.cell_begin[line + last[0] + 1];
      found.place.insert(found.place.end(), grid.order.begin() + begin, grid.order.begin() + end);
      found.x.insert(found.x.end(), grid.x.begin() + begin, grid.x.begin() + end);
      found.y.insert(found.y.end(), grid.y.begin() + begin, grid.y.begin() + end);
      found.z.insert(found.z.end(), grid.z.begin() + begin, grid.z.begin() + end);
    }
  while (found.place.size() % lanes<T>) {
    found.place.push_back(-1);
    found.x.push_back(high[0] + T(2) * reach), found.y.push_back(high[1]), found.z.push_back(high[2]);
  }
}

/// Appends to `list` the candidates within `reach` (m) of one of the `members`, in their order.
template <class T>
void append_near(const Candidates<T> &candidates, std::span<const Vec3<T>, lanes<T>> members, T reach,
                 std::vector<Index> &list) {
  const std::size_t n = candidates.place.size();
  std::size_t count = list.size();
  list.resize(count + n);
  for (std::size_t k = 0; k < n; k += lanes<T>) {
    const Pack<T> x = load_pack(&candidates.x[k]), y = load_pack(&candidates.y[k]), z = load_pack(&candidates.z[k]);
    Pack<T> nearest = reach * reach;
    for (const Vec3<T> &p : members) {
      const Pack<T> dx = x - p[0], dy = y - p[1], dz = z - p[2];
      nearest = min(dx * dx + dy * dy + dz * dz, nearest);
    }
    std::array<T, lanes<T>> distance;
    store_pack(distance.data(), nearest);
    for (Index l = 0; l < lanes<T>; ++l) {
      list[count] = candidates.place[k + l];
      count += distance[l] < reach * reach;
    }
  }
  list.resize(count);
}

/// Mirror images of all particles that another one can have within `reach` (m). A particle may have been pushed across
/// a plane: the reach is longer by as far as the furthest one lies behind it, so that pairs find each other both ways.
template <class T>
std::vector<MirrorImage> mirror_images(std::span<const Vec3<T>> positions, SymmetryPlanes planes, T reach) {
  Vec3<T> behind = Vec3<T>::Zero();
  for (const Vec3<T> &x : positions) behind = behind.cwiseMax(-x);
  std::vector<MirrorImage> images;
  const auto add = [&](Reflection in) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      if ((!in.x || positions[i][0] < reach + behind[0]) && (!in.y || positions[i][1] < reach + behind[1]))
        images.push_back({static_cast<Index>(i), 0, in});
  };
  if (planes.x) add({1, 0});
  if (planes.y) add({0, 1});
  if (planes.x && planes.y) add({1, 1});
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
  // As wide as a cube that holds a cluster, where the support holds about 58 particles.
  n.order = column_order(positions, std::cbrt(T(lanes<T>)) * support / T(2.4));
  const Index count = n.listed = static_cast<Index>(positions.size());
  std::vector<Index> place_of(count);
  for (Index k = 0; k < count; ++k) place_of[n.order[k]] = k;
  for (MirrorImage &image : n.images) image.place = place_of[image.parent];
  std::vector<Vec3<T>> at_place(n.order.size() + n.images.size());
  for (Index k = 0; k < count; ++k) at_place[k] = positions[n.order[k]];
  for (std::size_t g = 0; g < n.images.size(); ++g)
    at_place[count + g] = reflected(positions[n.images[g].parent], n.images[g].reflection);
  CellGrid<T> grid = sort_into_cells(at_place, n.reach / T(2));
  while (n.order.size() % lanes<T>) n.order.push_back(n.order.back());
  const Index fill = static_cast<Index>(n.order.size()) - count;
  for (Index &place : grid.order) place += place < count ? 0 : fill;

  constexpr Index chunk = 32;
  const Index total = clusters(n);
  std::vector<std::vector<Index>> chunk_rows((total + chunk - 1) / chunk);
  n.cluster_begin.assign(total + 1, 0);
  parallel_for_chunks(total, chunk, [&](Index begin, Index end) {
    auto &rows = chunk_rows[begin / chunk];
    rows.reserve(static_cast<std::size_t>(end - begin) * 256);
    Candidates<T> candidates;
    std::array<Vec3<T>, lanes<T>> members;
    for (Index c = begin; c < end; ++c) {
      for (Index l = 0; l < lanes<T>; ++l) members[l] = positions[n.order[c * lanes<T> + l]];
      Vec3<T> low = members[0], high = low;
      for (const Vec3<T> &p : members) low = low.cwiseMin(p), high = high.cwiseMax(p);
      gather_candidates(grid, low, high, n.reach, candidates);
      append_near<T>(candidates, members, n.reach, rows);
      n.cluster_begin[c + 1] = static_cast<std::int64_t>(rows.size());
    }
  });
  std::int64_t offset = 0;
  for (Index begin = 0; begin < total; begin += chunk) {
    const Index end = std::min(total, begin + chunk);
    for (Index c = begin; c < end; ++c) n.cluster_begin[c + 1] += offset;
    offset = n.cluster_begin[end];
  }
  // Growth by doubling would keep room for twice as many.
  if (n.list.capacity() < static_cast<std::size_t>(offset)) {
    n.list = {};
    n.list.reserve(static_cast<std::size_t>(offset + offset / 16));
  }
  n.list.resize(static_cast<std::size_t>(offset));
  n.within.assign(static_cast<std::size_t>(offset / 64 + total + 1), 0);
  parallel_for_chunks(total, chunk, [&](Index begin, Index) {
    const auto &rows = chunk_rows[begin / chunk];
    std::copy(rows.begin(), rows.end(), n.list.begin() + n.cluster_begin[begin]);
  });
}

/// The same with lists of the particles `members` only; the others have no place.
template <class T>
void build_neighbours(Neighbours<T> &n, std::span<const Vec3<T>> positions, std::span<const Index> members,
                      SymmetryPlanes planes, T support, T skin) {
  if (members.empty()) {
    n = Neighbours<T>{};
    n.support = support, n.reach = support + skin;
    n.cluster_begin = {0};
  } else {
    std::vector<Vec3<T>> there;
    there.reserve(members.size());
    for (const Index i : members) there.push_back(positions[i]);
    build_neighbours(n, std::span<const Vec3<T>>(there), planes, support, skin);
    for (Index &i : n.order) i = members[i];
    for (MirrorImage &image : n.images) image.parent = members[image.parent];
  }
  n.built_at.assign(positions.begin(), positions.end());
}

/// True if the lists may miss a neighbour: some two particles may have moved by more than the skin relative to each
/// other.
template <class T>
bool are_stale(const Neighbours<T> &n, std::span<const Vec3<T>> positions, SymmetryPlanes planes, T support) {
  if (n.built_at.size() != positions.size()) return true;
  if (n.order.empty()) return false;
  const auto move = [&](Index k) { return Vec3<T>(positions[n.order[k]] - n.built_at[n.order[k]]); };
  const T relative = largest_relative_move<T>(static_cast<Index>(n.order.size()), move, planes);
  return std::isfinite(relative) && relative > n.reach - support;
}

} // namespace ogive
