// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <array>
#include <cmath>

namespace ogive {

/// Barycentric coordinates of the point of triangle abc that is closest to p (Ericson 2005, section 5.1.5).
template <class T> Vec3<T> closest_on_triangle(const Vec3<T> &p, const Vec3<T> &a, const Vec3<T> &b, const Vec3<T> &c) {
  const Vec3<T> ab = b - a, ac = c - a, ap = p - a;
  const T d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= T(0) && d2 <= T(0)) return {T(1), T(0), T(0)};
  const Vec3<T> bp = p - b;
  const T d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= T(0) && d4 <= d3) return {T(0), T(1), T(0)};
  const T vc = d1 * d4 - d3 * d2;
  if (vc <= T(0) && d1 >= T(0) && d3 <= T(0)) {
    const T v = d1 / (d1 - d3);
    return {T(1) - v, v, T(0)};
  }
  const Vec3<T> cp = p - c;
  const T d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= T(0) && d5 <= d6) return {T(0), T(0), T(1)};
  const T vb = d5 * d2 - d1 * d6;
  if (vb <= T(0) && d2 >= T(0) && d6 <= T(0)) {
    const T w = d2 / (d2 - d6);
    return {T(1) - w, T(0), w};
  }
  const T va = d3 * d6 - d5 * d4;
  if (va <= T(0) && d4 - d3 >= T(0) && d5 - d6 >= T(0)) {
    const T w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {T(0), T(1) - w, w};
  }
  const T denominator = T(1) / (va + vb + vc);
  return {va * denominator, vb * denominator, vc * denominator};
}

/// Point of a facet closest to another point.
template <class T> struct FacetPoint {
  std::array<T, 4> weights{};         ///< of the facet's corners, sum 1
  Vec3<T> position = Vec3<T>::Zero(); ///< m
  Vec3<T> normal = Vec3<T>::Zero();   ///< outward unit normal of the facet there
  T distance_squared{};               ///< m2
};

/// The nearest of some facets so far. Of two that are equally near to 1e-6, as on both sides of an edge, the one
/// whose normal points better at the given place is the nearest.
template <class T> struct NearestSoFar {
  T distance_squared{}; ///< m2
  T alignment{};        ///< m, part of the distance that is along the normal
  bool empty = true;    ///< there has been none

  /// Takes a facet if it is nearer, or as near and better aligned; true if it does.
  bool take(T candidate_squared, T candidate_alignment) {
    const T tie = T(1e-6) * (distance_squared + candidate_squared);
    if (!empty && !(candidate_squared < distance_squared - tie) &&
        !(candidate_squared <= distance_squared + tie && candidate_alignment > alignment))
      return false;
    *this = {candidate_squared, candidate_alignment, false};
    return true;
  }
};

/// Closest point of a quadrilateral, taken as four triangles around its middle so that no diagonal is preferred.
template <class T> FacetPoint<T> closest_on_facet(const Vec3<T> &p, const std::array<Vec3<T>, 4> &corner) {
  const Vec3<T> middle = T(0.25) * (corner[0] + corner[1] + corner[2] + corner[3]);
  FacetPoint<T> best;
  NearestSoFar<T> nearest;
  for (int k = 0; k < 4; ++k) {
    const int l = (k + 1) % 4;
    const Vec3<T> bary = closest_on_triangle(p, corner[k], corner[l], middle);
    const Vec3<T> x = bary[0] * corner[k] + bary[1] * corner[l] + bary[2] * middle;
    const T d2 = (p - x).squaredNorm();
    const Vec3<T> area = cross<T>(corner[l] - corner[k], middle - corner[k]);
    const Vec3<T> normal = area / std::max(area.norm(), T(1e-30));
    if (nearest.take(d2, std::abs(normal.dot(p - x)))) {
      best.weights = {T(0.25) * bary[2], T(0.25) * bary[2], T(0.25) * bary[2], T(0.25) * bary[2]};
      best.weights[k] += bary[0];
      best.weights[l] += bary[1];
      best.position = x;
      best.normal = normal;
      best.distance_squared = d2;
    }
  }
  return best;
}

} // namespace ogive
