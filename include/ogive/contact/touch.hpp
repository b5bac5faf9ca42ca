// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/closest_point.hpp"
#include "ogive/contact/node_to_surface.hpp"
#include "ogive/contact/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// \file
/// Place and depth of the contact between a slave and the surface: the narrow phase of contact.

namespace ogive {

/// Normal of triangle abc times the angle that it takes up at one of its points, whose barycentric coordinates are
/// `at`: its angle at a corner, pi on an edge, 2 pi inside.
template <class T>
Vec3<T> angle_weighted_normal(const Vec3<T> &a, const Vec3<T> &b, const Vec3<T> &c, const Vec3<T> &at) {
  const Vec3<T> area = cross<T>(b - a, c - a);
  const T size = area.norm(), none = T(1e-9);
  if (!(size > T(0))) return Vec3<T>::Zero();
  const auto angle = [&](const Vec3<T> &p, const Vec3<T> &q, const Vec3<T> &r) {
    return std::atan2(size, (q - p).dot(r - p));
  };
  const T pi = std::numbers::pi_v<T>;
  const T weight = at[0] > T(1) - none    ? angle(a, b, c)
                   : at[1] > T(1) - none  ? angle(b, c, a)
                   : at[2] > T(1) - none  ? angle(c, a, b)
                   : at.minCoeff() < none ? pi
                                          : T(2) * pi;
  return weight / size * area;
}

/// True if `p` (m), where slave `a` of the active list is, lies outside the surface, whose closest facet is `distance`
/// (m) away: by the angle-weighted normals of all triangles that meet at the closest point, which give the side of any
/// closed surface (Baerentzen & Aanaes 2005). Edges may be of any kind and facets warped, so that the normal of one
/// facet is not enough. True if no candidate is near.
template <class T>
bool is_outside(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a, const Vec3<T> &p, T distance) {
  const auto for_each_near_triangle = [&](T reach, auto &&f) {
    for (Index k = contact.candidates.begin[a]; k < contact.candidates.begin[a + 1]; ++k) {
      const Index facet = contact.candidates.facets[k];
      const Vec3<T> &middle = contact.candidates.middle[facet];
      if ((p - middle).norm() > reach + contact.candidates.radius[facet]) continue;
      for (int c = 0; c < 4; ++c) {
        const Vec3<T> &corner = nodes.position[contact.facets[facet].nodes[c]],
                      &next = nodes.position[contact.facets[facet].nodes[(c + 1) % 4]];
        const Vec3<T> at = closest_on_triangle(p, corner, next, middle);
        f(facet, corner, next, middle, at, Vec3<T>(at[0] * corner + at[1] * next + at[2] * middle));
      }
    }
  };
  T nearest = T(1.01) * distance, near{};
  Vec3<T> closest = Vec3<T>::Zero();
  for_each_near_triangle(nearest, [&](Index facet, auto &, auto &, auto &, auto &, const Vec3<T> &x) {
    if (const T d = (p - x).norm(); d < nearest)
      nearest = d, closest = x, near = T(1e-6) * contact.candidates.radius[facet];
  });
  Vec3<T> outward = Vec3<T>::Zero();
  for_each_near_triangle(T(1.01) * nearest, [&](Index, const Vec3<T> &corner, const Vec3<T> &next,
                                                const Vec3<T> &middle, const Vec3<T> &at, const Vec3<T> &x) {
    if ((x - closest).norm() < near) outward += angle_weighted_normal(corner, next, middle, at);
  });
  // The images of facets at a mirror plane take away what points across it.
  if (contact.symmetry.x && std::abs(closest[0]) < near) outward[0] = T(0);
  if (contact.symmetry.y && std::abs(closest[1]) < near) outward[1] = T(0);
  return outward.dot(p - closest) >= T(0);
}

/// Place and depth of the contact between a slave and the surface.
template <class T> struct Touch {
  Index facet = -1;                    ///< -1: no contact
  std::array<T, 4> weights{};          ///< of the facet's nodes at the closest point
  Vec3<T> direction = Vec3<T>::Zero(); ///< unit vector out of the surface, as the slave sees it
  T depth{};                           ///< m, positive where the slave's sphere enters the surface
  bool lost = false;                   ///< no contact, because the slave is deeper inside than it may be
  Reflection reflection{};             ///< in which the slave sees the facet
  T room{};                            ///< m, without contact: how far both may approach before there can be one
};

/// The facet nearest to a slave, and its point there.
template <class T> struct NearestFacet {
  Index facet = -1;      ///< -1: none is near
  FacetPoint<T> point{}; ///< closest to the slave
  bool outside = true;   ///< the slave lies outside the surface
};

/// Closest point of the candidate facets to `p` (m), where slave `a` of the active list is, if nearer than `limit` (m).
template <class T>
NearestFacet<T> find_nearest(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a, const Vec3<T> &p,
                             T limit) {
  FacetPoint<T> best;
  NearestSoFar<T> nearest;
  Index facet = -1;
  for (Index k = contact.candidates.begin[a]; k < contact.candidates.begin[a + 1]; ++k) {
    const Index f = contact.candidates.facets[k];
    if ((p - contact.candidates.middle[f]).norm() > limit + contact.candidates.radius[f]) continue;
    std::array<Vec3<T>, 4> corner;
    for (int c = 0; c < 4; ++c) corner[c] = nodes.position[contact.facets[f].nodes[c]];
    const FacetPoint<T> point = closest_on_facet(p, corner);
    if (nearest.take(point.distance_squared, std::abs(point.normal.dot(p - point.position)))) {
      best = point;
      facet = f;
      limit = std::min(limit, std::sqrt(point.distance_squared) * T(1.001));
    }
  }
  if (facet < 0) return {};
  // On a convex surface, where few slaves are inside, one that seems outside by the nearest facet is outside.
  const bool seems_outside = best.normal.dot(p - best.position) >= T(0);
  const bool outside = (seems_outside && !contact.options.reentrant && !contact.torn) ||
                       is_outside(contact, nodes, a, p, std::sqrt(best.distance_squared));
  return {facet, best, outside};
}

/// Contact of slave `a` of the active list with the surface at `nearest`. At an edge or corner the direction is that
/// from the surface to the slave, so that it turns smoothly around the edge; in a mirror plane it stays in the plane.
template <class T>
Touch<T> touch_at(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a, const NearestFacet<T> &nearest) {
  const Index slave = contact.candidates.active[a];
  const Vec3<T> p = on_model_side(contact, nodes.position, slave);
  const T offset = contact.offset[slave], deepest = contact.search_margin;
  const Index facet = nearest.facet;
  const FacetPoint<T> &best = nearest.point;
  if (facet < 0) return {.room = deepest};
  const Vec3<T> gap = p - best.position;
  const T distance = std::sqrt(best.distance_squared);
  const bool outside = nearest.outside;
  const T depth = outside ? offset - distance : offset + distance;
  if (depth <= T(0)) return {.room = outside ? -depth : T(0)};
  if (!outside && distance > deepest) return {.lost = true};
  Vec3<T> direction = best.normal;
  if (distance > T(1e-3) * contact.candidates.radius[facet]) direction = (outside ? T(1) : T(-1)) / distance * gap;
  const T near = T(1e-6) * contact.candidates.radius[facet];
  if (contact.symmetry.x && std::abs(p[0]) < near) direction[0] = T(0);
  if (contact.symmetry.y && std::abs(p[1]) < near) direction[1] = T(0);
  const T length = direction.norm();
  if (length < T(0.1)) return {};
  const Reflection reflection = to_model_side(nodes.position[contact.slaves[slave]], contact.symmetry);
  return {facet, best.weights, reflected<T>(direction / length, reflection), depth, false, reflection};
}

/// Contact of slave `a` of the active list with the surface.
template <class T> Touch<T> find_touch(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a) {
  const Index s = contact.candidates.active[a];
  const Vec3<T> p = on_model_side(contact, nodes.position, s);
  return touch_at(contact, nodes, a, find_nearest(contact, nodes, a, p, contact.offset[s] + contact.search_margin));
}

/// Takes the way that each slave and the surface may have come closer since the last check from its room.
template <class T> void use_up_room(NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  NearSlaves<T> &near = contact.state.near;
  const Box<T> surface = box_of_moves<T>(static_cast<Index>(contact.masters.size()), [&](Index m) {
    return Vec3<T>(nodes.position[contact.masters[m]] - contact.state.masters_checked_at[m]);
  });
  parallel_for(static_cast<Index>(contact.candidates.active.size()), [&](Index a) {
    const Index s = contact.candidates.active[a], k = contact.candidates.entry[a];
    if (!(near.room[k] > T(0))) return;
    const Vec3<T> u = on_model_side(contact, nodes.position, s) - on_model_side(contact, near.checked_at[k]);
    near.room[k] -= (u - surface.low).cwiseAbs().cwiseMax((u - surface.high).cwiseAbs()).norm();
  });
}

} // namespace ogive
