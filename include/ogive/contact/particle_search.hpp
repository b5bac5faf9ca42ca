// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/particle_contact.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/search/box.hpp"
#include "ogive/search/cell_grid.hpp"
#include "ogive/search/mirror_image.hpp"
#include "ogive/sph/kernel.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace ogive {

/// The positions of a contact's particles, m.
template <class T> std::span<const Vec3<T>> positions_of(const ParticleContact<T> &contact, const Nodes<T> &nodes) {
  return std::span<const Vec3<T>>(nodes.position).subspan(contact.nodes.begin, contact.nodes.size());
}

/// True if two particles may have come closer by more than the search margin since the last search.
template <class T> bool is_search_due(const ParticleContact<T> &contact, const Nodes<T> &nodes) {
  const auto positions = positions_of(contact, nodes);
  if (contact.searched_at.size() != positions.size()) return true;
  const auto move = [&](Index i) { return Vec3<T>(positions[i] - contact.searched_at[i]); };
  const T relative = largest_relative_move<T>(contact.nodes.size(), move, contact.symmetry);
  return std::isfinite(relative) && relative > contact.search_margin;
}

/// For each cell, a bit for each body that has particles there or in a cell beside it.
template <class T>
std::vector<std::uint8_t> bodies_near_cells(const CellGrid<T> &grid, const std::vector<std::uint8_t> &body_bit) {
  const auto [nx, ny, nz] = grid.cells;
  std::vector<std::uint8_t> bits(grid.cell_begin.size() - 1, 0), spread = bits;
  for (std::size_t c = 0; c < bits.size(); ++c)
    for (Index k = grid.cell_begin[c]; k < grid.cell_begin[c + 1]; ++k) bits[c] |= body_bit[grid.order[k]];
  // Along one axis after the other: what lies beside the neighbour in x and y lies diagonally.
  for (const auto &[count, stride] : {std::pair{nx, Index(1)}, std::pair{ny, nx}, std::pair{nz, nx * ny}}) {
    for (Index c = 0; c < static_cast<Index>(bits.size()); ++c) {
      const Index at = c / stride % count;
      spread[c] = bits[c] | (at > 0 ? bits[c - stride] : 0) | (at + 1 < count ? bits[c + stride] : 0);
    }
    bits = spread;
  }
  return bits;
}

/// Finds, for each particle at `positions` (m), those of other bodies that it can touch before the next search.
template <class T> void search(ParticleContact<T> &contact, std::span<const Vec3<T>> positions) {
  contact.searched_at.assign(positions.begin(), positions.end());
  const Index count = static_cast<Index>(positions.size());
  const T reach = T(kernel_support) * contact.smoothing_length + contact.search_margin;
  const std::vector<MirrorImage> images = mirror_images(positions, contact.symmetry, reach);
  std::vector<Vec3<T>> at(positions.begin(), positions.end());
  std::vector<std::uint8_t> bit;
  for (Index i = 0; i < count; ++i) bit.push_back(std::uint8_t(1U << contact.body[i]));
  for (const MirrorImage &image : images) at.push_back(reflected(positions[image.parent], image.reflection));
  for (const MirrorImage &image : images) bit.push_back(bit[image.parent]);
  const CellGrid<T> grid = sort_into_cells(at, reach);
  const std::vector<std::uint8_t> near = bodies_near_cells(grid, bit);
  std::vector<char> is_near(count, 0);
  for (std::size_t c = 0; c < near.size(); ++c)
    for (Index k = grid.cell_begin[c]; k < grid.cell_begin[c + 1]; ++k)
      if (const Index i = grid.order[k]; i < count) is_near[i] = (near[c] & ~bit[i]) != 0;

  std::vector<std::vector<ParticleNearby>> rows((count + loop_chunk - 1) / loop_chunk);
  contact.row_begin.assign(count + 1, 0);
  parallel_for_chunks(count, loop_chunk, [&](Index begin, Index end) {
    auto &found = rows[begin / loop_chunk];
    for (Index i = begin; i < end; ++i) {
      const auto take = [&](Index j) {
        if (bit[j] == bit[i] || !((at[j] - positions[i]).squaredNorm() < reach * reach)) return;
        if (j < count)
          found.push_back({j, {}});
        else
          found.push_back({images[j - count].parent, images[j - count].reflection});
      };
      if (is_near[i]) for_each_candidate(grid, positions[i], reach, take);
      contact.row_begin[i + 1] = static_cast<Index>(found.size());
    }
  });
  contact.nearby.clear();
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const Index begin = static_cast<Index>(c) * loop_chunk, offset = static_cast<Index>(contact.nearby.size());
    for (Index i = begin; i < std::min(count, begin + loop_chunk); ++i) contact.row_begin[i + 1] += offset;
    contact.nearby.insert(contact.nearby.end(), rows[c].begin(), rows[c].end());
  }
  contact.fullness.assign(count, T(0));
}

/// The rows of the contact's lists.
template <class T> std::span<const ParticleNearby> row(const ParticleContact<T> &contact, Index i) {
  return std::span(contact.nearby).subspan(contact.row_begin[i], contact.row_begin[i + 1] - contact.row_begin[i]);
}

} // namespace ogive
