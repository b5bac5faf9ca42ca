#pragma once

#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"

namespace sim_test {

using namespace ogive;

/// A coarse plate that is struck fast: a few hundred particles.
inline PerforationCase<double> small_case(Nose nose, Extent extent) {
  PerforationCase<double> c;
  c.thickness = 6e-3;
  c.clamp_radius = 40e-3;
  c.sph_radius = 15e-3;
  c.spacing = 1.5e-3;
  c.nose = nose;
  c.initial_velocity = 300;
  c.friction = 0.1;
  c.extent = extent;
  return c;
}

inline auto small_shot(const PerforationCase<double> &c) {
  return make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
}

} // namespace sim_test
