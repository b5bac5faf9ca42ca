// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh/hex_mesh.hpp"

/// Area of a facet times its outward normal, m2.
template <class T> ogive::Vec3<T> area_vector(const ogive::Facet &facet, const std::vector<ogive::Vec3<T>> &positions) {
  const ogive::Vec3<T> a = positions[facet.nodes[2]] - positions[facet.nodes[0]];
  const ogive::Vec3<T> b = positions[facet.nodes[3]] - positions[facet.nodes[1]];
  return T(0.5) * ogive::cross<T>(a, b);
}
