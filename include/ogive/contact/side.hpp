// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/closest_point.hpp"
#include "ogive/contact/node_to_surface.hpp"

#include <cmath>
#include <numbers>

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

} // namespace ogive
