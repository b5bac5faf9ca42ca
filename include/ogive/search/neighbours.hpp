// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/core/tile.hpp"

#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ogive {

/// Mirror image of a cluster.
struct ClusterImage {
  Index cluster = 0;       ///< that is mirrored
  Reflection reflection{}; ///< that makes the image
};

/// Neighbour lists of clusters: four particles that lie close together share one list of groups of neighbours, so that
/// a loop works on all pairs of the cluster with a group at once, see tile.hpp. Particles have places in an order that
/// keeps near ones together; cluster c has the four places from c * cluster_size. Clusters that are not full repeat
/// their last particle; these fillers are in no list, and their volume is zero. Mirror images of clusters have the
/// places behind all clusters.
template <class T, class Width = SimdWidth> struct Neighbours {
  std::vector<Index> order;                ///< particle of each place; a multiple of a block, see blocks()
  Index listed = 0;                        ///< number of particles in the lists
  std::vector<ClusterImage> images;        ///< image g is cluster clusters() + g, with four places more
  std::vector<std::int64_t> cluster_begin; ///< number of clusters + 1
  std::vector<Index> list;                 ///< first places of groups
  std::vector<std::uint64_t> within;       ///< a bit for each entry: within the support in this step
  std::vector<Vec3<T>> built_at;           ///< positions at the time of building, m
  T support = T(0);                        ///< distance within which the lists must be complete, m
  T reach = T(0);                          ///< support plus skin, m
  T quantum = T(1);                        ///< unit of coordinates in pair data, m
};

/// Number of clusters.
template <class T> Index clusters(const Neighbours<T> &n) { return static_cast<Index>(n.order.size()) / cluster_size; }

/// Places that are worked on one after the other: a whole number of clusters and of packs.
template <class Width = SimdWidth> inline constexpr Index block_size = lanes<float>;

/// Number of blocks.
template <class T> Index blocks(const Neighbours<T> &n) { return static_cast<Index>(n.order.size()) / block_size<>; }

/// Number of places, of mirror images too.
template <class T> std::size_t places(const Neighbours<T> &n) {
  return n.order.size() + n.images.size() * cluster_size;
}

/// True if place k, not of an image, only fills up a cluster.
template <class T> bool is_filler(const Neighbours<T> &n, Index k) { return k > 0 && n.order[k] == n.order[k - 1]; }

/// First places of all groups, of images too, with a particle within reach of some particle of cluster c, its own ones
/// included.
template <class T> std::span<const Index> row(const Neighbours<T> &n, Index c) {
  return {n.list.data() + n.cluster_begin[c], static_cast<std::size_t>(n.cluster_begin[c + 1] - n.cluster_begin[c])};
}

/// The particle at a place, and the reflection in which it is seen there.
template <class T> std::pair<Index, Reflection> seen_at(const Neighbours<T> &n, Index place) {
  const Index own = static_cast<Index>(n.order.size());
  if (place < own) return {n.order[place], {}};
  const ClusterImage &image = n.images[(place - own) / cluster_size];
  return {n.order[image.cluster * cluster_size + place % cluster_size], image.reflection};
}

/// Calls `f(i, j, reflection)` for each particle i of cluster c and each particle j, seen in a reflection, of its row:
/// i itself is among them, and so are some beyond reach.
template <class T, class F> void for_each_listed_pair(const Neighbours<T> &n, Index c, F &&f) {
  const Index own = static_cast<Index>(n.order.size());
  for (Index k = c * cluster_size; k < (c + 1) * cluster_size; ++k) {
    if (is_filler(n, k)) continue;
    for (const Index group : row(n, c))
      for (Index place = group; place < group + group_size<>; ++place) {
        const Index of =
            place < own ? place : n.images[(place - own) / cluster_size].cluster * cluster_size + place % cluster_size;
        if (is_filler(n, of)) continue;
        const auto [j, reflection] = seen_at(n, place);
        f(n.order[k], j, reflection);
      }
  }
}

/// The bits of cluster c, 64 entries of its row to a word.
template <class N> auto bits(N &n, Index c) { return n.within.begin() + (n.cluster_begin[c] / 64 + c); }

/// Writes the bits of a cluster, entry by entry.
template <class Words> struct BitWriter {
  Words word;             ///< place of the next word
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
    Words word;          ///< place of the next word
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

/// The groups with a particle within the support of some particle of cluster c, as the last velocity gradient found
/// them.
template <class T> auto row_within(const Neighbours<T> &n, Index c) { return SetEntries{row(n, c), bits(n, c)}; }

/// Calls `f(i, j)` once for each two particles i < j that a list brings together, and maybe for some farther apart;
/// without mirror images.
template <class T, class F> void for_each_neighbour_pair(const Neighbours<T> &n, F &&f) {
  for (Index c = 0; c < clusters(n); ++c)
    for_each_listed_pair(n, c, [&](Index i, Index j, Reflection reflection) {
      if (i < j && !reflection.x && !reflection.y) f(i, j);
    });
}

} // namespace ogive
