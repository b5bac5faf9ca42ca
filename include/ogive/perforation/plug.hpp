// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/closest_point.hpp"
#include "ogive/contact/search.hpp"
#include "ogive/core/types.hpp"
#include "ogive/perforation/setup.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace ogive {

/// A partition of 0 to n - 1 whose parts are joined one by one. The smallest member names its part.
struct DisjointSets {
  std::vector<Index> parent; ///< of each number, itself where it names its part
  /// Each number alone.
  explicit DisjointSets(Index n) : parent(n) { std::iota(parent.begin(), parent.end(), Index(0)); }
  /// The smallest member of the part that `i` belongs to.
  Index root(Index i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  /// Makes one part of those of `i` and `j`.
  void join(Index i, Index j) {
    const Index a = root(i), b = root(j);
    parent[std::max(a, b)] = std::min(a, b);
  }
  /// The smallest member of the part of each number.
  std::vector<Index> roots() {
    std::vector<Index> all(parent.size());
    for (Index i = 0; i < static_cast<Index>(all.size()); ++i) all[i] = root(i);
    return all;
  }
};

/// The pieces into which the plate's particles have broken.
template <class T> struct Fragments {
  T plug_mass{};     ///< kg, largest piece that is not connected to the rim; whole model
  T plug_velocity{}; ///< m/s in the direction of flight
  T debris_mass{};   ///< kg, all smaller pieces
  Index pieces = 0;  ///< number of loose pieces, of the computed part
  T failed_mass{};   ///< kg, failed particles, removed ones included; they belong to no piece; whole model
  Index failed = 0;  ///< number of them, of the computed part
};

/// Number of the piece that each particle belongs to: the smallest particle index of the piece. Two particles are
/// connected while they are nearer than `distance` (m) and neither has failed. One piece before the first step, which
/// makes the lists.
template <class T, class Body>
std::vector<Index> connected_pieces(const Body &body, const Nodes<T> &nodes, T distance) {
  const Index n = body.points.size();
  if (body.neighbours.order.empty()) return std::vector<Index>(n, 0);
  DisjointSets pieces(n);
  const auto failed = [&](Index i) { return is_failed(body.metal.damage, body.points.damage[i]); };
  for_each_neighbour_pair(body.neighbours, [&](Index i, Index j) {
    const Vec3<T> gap = nodes.position[body.nodes.begin + i] - nodes.position[body.nodes.begin + j];
    if (gap.squaredNorm() > distance * distance || failed(i) || failed(j)) return;
    pieces.join(i, j);
  });
  return pieces.roots();
}

/// The piece to which each particle of a plate belongs.
struct Pieces {
  std::vector<Index> of;    ///< the piece of each particle, of connected_pieces()
  std::vector<bool> at_rim; ///< by piece: it hangs on the rim
  std::vector<bool> failed; ///< by particle: it belongs to no piece
  Index plug = -1;          ///< the heaviest loose piece; -1 if there is none

  /// True if particle i is sound and belongs to plug or debris.
  bool is_loose(Index i) const { return !failed[i] && !at_rim[of[i]]; }
  /// True if particle i is sound and hangs on the plate.
  bool hangs(Index i) const { return !failed[i] && at_rim[of[i]]; }
};

/// Pieces of sound particles of a plate that chains of neighbours nearer than `ratio` particle distances connect, and
/// which of them the tie holds on the rim.
template <class M> Pieces find_pieces(const M &model, double ratio = 1.5, std::size_t layer = 0) {
  const auto &body = plate_particles(model, layer);
  using T = std::decay_t<decltype(body.spacing)>;
  Pieces p;
  const Index n = body.points.size();
  p.of = connected_pieces(body, model.nodes, T(ratio) * body.spacing);
  p.at_rim.assign(n, false), p.failed.assign(n, false);
  for (const auto &tie : model.ties)
    for (const auto &t : tie.nodes)
      if (t.slave >= body.nodes.begin && t.slave < body.nodes.end) p.at_rim[p.of[t.slave - body.nodes.begin]] = true;
  std::vector<T> mass(n, T(0));
  for (Index i = 0; i < n; ++i) {
    p.failed[i] = is_failed(body.metal.damage, body.points.damage[i]);
    mass[p.of[i]] += body.point_mass[i];
  }
  for (Index i = 0; i < n; ++i)
    if (p.of[i] == i && p.is_loose(i) && (p.plug < 0 || mass[i] > mass[p.plug])) p.plug = i;
  return p;
}

/// Plug and debris of a plate: pieces of sound particles that no chain of neighbours nearer than `ratio` particle
/// distances connects to the rim. In a quarter model a piece is taken with its mirror images.
template <class M> auto find_fragments_of(const M &model, std::size_t layer, double ratio = 1.5) {
  const auto &body = plate_particles(model, layer);
  using T = std::decay_t<decltype(body.spacing)>;
  const Pieces pieces = find_pieces(model, ratio, layer);
  Fragments<T> f;
  T plug{}, momentum{}, debris{};
  for (Index i = 0; i < static_cast<Index>(pieces.of.size()); ++i) {
    const T mass = body.point_mass[i];
    if (pieces.failed[i]) ++f.failed, f.failed_mass += mass;
    if (!pieces.is_loose(i)) continue;
    if (pieces.of[i] == i) ++f.pieces;
    if (pieces.of[i] != pieces.plug) {
      debris += mass;
      continue;
    }
    plug += mass;
    momentum -= mass * model.nodes.velocity[body.nodes.begin + i][2];
  }
  const T copies = T(model.symmetry.copies());
  f.failed_mass *= copies;
  f.plug_mass = copies * plug;
  f.debris_mass = copies * debris;
  if (plug > T(0)) f.plug_velocity = momentum / plug;
  return f;
}

/// Plugs and debris of all plates together: the masses of the plates' plugs are added up.
template <class M> auto find_fragments(const M &model, double ratio = 1.5) {
  auto whole = find_fragments_of(model, 0, ratio);
  for (std::size_t layer = 1; layer < model.bodies.plate_particles.size(); ++layer) {
    const auto next = find_fragments_of(model, layer, ratio);
    if (const auto mass = whole.plug_mass + next.plug_mass; mass > 0)
      whole.plug_velocity = (whole.plug_mass * whole.plug_velocity + next.plug_mass * next.plug_velocity) / mass;
    whole.plug_mass += next.plug_mass;
    whole.debris_mass += next.debris_mass;
    whole.pieces += next.pieces;
    whole.failed_mass += next.failed_mass;
    whole.failed += next.failed;
  }
  return whole;
}

/// True if a point (m) lies in a hex of the projectile.
template <class M, class T> bool lies_in_projectile(const M &model, const Vec3<T> &p) {
  for (const auto &part : model.bodies.projectile)
    for (Index e = 0; e < static_cast<Index>(part.hexes.size()); ++e)
      if (!is_removed(part, e) && lies_in_hex<T>(gather_corners(model.nodes.position, part.hexes[e]), p)) return true;
  return false;
}

/// Depth behind the projectile's surface of the particle of a plate that is deepest inside, m; 0 if none is inside. The
/// side of the nearest facet alone is no proof where the surface is torn or folded: an inside particle lies in a hex.
/// Removed particles may be anywhere.
template <class M, class Body> auto largest_intrusion_of(const M &model, const Body &body) {
  const auto &contact = model.contacts.front();
  const auto &nodes = model.nodes;
  using T = std::decay_t<decltype(body.spacing)>;
  Box<T> box;
  for (const Facet &f : contact.facets)
    for (Index n : f.nodes) extend(box, nodes.position[n]);
  return parallel_max(body.nodes.size(), T(0), [&](Index i) {
    const Vec3<T> p = on_model_side(contact, nodes.position[body.nodes.begin + i]);
    if (is_removed(body, i) || !is_inside(box, p)) return T(0);
    FacetPoint<T> best;
    NearestSoFar<T> nearest;
    for (const Facet &f : contact.facets) {
      std::array<Vec3<T>, 4> corner;
      for (int c = 0; c < 4; ++c) corner[c] = nodes.position[f.nodes[c]];
      if (const T far = (corner[0] - corner[2]).norm() + (corner[1] - corner[3]).norm();
          !nearest.empty && (p - corner[0]).norm() - far > std::sqrt(nearest.distance_squared))
        continue;
      const FacetPoint<T> point = closest_on_facet(p, corner);
      if (nearest.take(point.distance_squared, std::abs(point.normal.dot(p - point.position)))) best = point;
    }
    const bool is_behind = best.normal.dot(p - best.position) < T(0);
    return is_behind && lies_in_projectile(model, p) ? std::sqrt(best.distance_squared) : T(0);
  });
}

/// Depth behind the projectile's surface of the particle of any plate that is deepest inside, m; 0 if none is inside.
template <class M> auto largest_intrusion(const M &model) {
  auto deepest = largest_intrusion_of(model, plate_particles(model));
  for (std::size_t layer = 1; layer < model.bodies.plate_particles.size(); ++layer)
    deepest = std::max(deepest, largest_intrusion_of(model, plate_particles(model, layer)));
  return deepest;
}

} // namespace ogive
