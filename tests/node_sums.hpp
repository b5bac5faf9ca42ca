// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/nodes.hpp"

/// kg.
inline double total_mass(const ogive::Nodes<double> &nodes) {
  double mass = 0;
  for (const double m : nodes.mass) mass += m;
  return mass;
}

/// Sum of m x, kg m.
inline ogive::Vec3<double> first_moment(const ogive::Nodes<double> &nodes) {
  ogive::Vec3<double> sum = ogive::Vec3<double>::Zero();
  for (ogive::Index n = 0; n < nodes.size(); ++n) sum += nodes.mass[n] * nodes.position[n];
  return sum;
}
