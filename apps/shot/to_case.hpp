// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "projectile.hpp"

#include "ogive/perforation/method.hpp"

#include <numbers>

namespace shot {

/// The case of the options in SI units.
inline ogive::PerforationCase<double> to_case(const Options &o) {
  ogive::PerforationCase<double> c;
  c.thickness = o.thickness_mm * 1e-3;
  if (!o.layers_mm.empty()) c.thickness = o.layers_mm.front() * 1e-3;
  for (std::size_t k = 1; k < o.layers_mm.size(); ++k)
    c.behind.push_back({o.gaps_mm[k - 1] * 1e-3, o.layers_mm[k] * 1e-3});
  c.clamp_radius = o.clamp_radius_mm * 1e-3;
  c.sph_radius = o.sph_radius_mm * 1e-3;
  c.spacing = o.spacing_mm * 1e-3;
  c.lattice = o.lattice;
  c.seed = static_cast<std::uint64_t>(o.seed);
  c.projectile = shape_of(o);
  if (o.own_mesh.read) c.own_mesh = o.own_mesh.read->projectile.body;
  c.projectile_mass = o.mass_g * 1e-3;
  c.obliquity = o.obliquity_deg * std::numbers::pi / 180;
  c.pitch = o.pitch_deg * std::numbers::pi / 180;
  c.yaw = o.yaw_deg * std::numbers::pi / 180;
  c.initial_velocity = o.velocity_mps;
  c.friction = o.friction;
  c.parts = o.parts;
  c.part_friction = o.part_friction;
  c.erosion = o.projectile_erosion;
  c.rigid_projectile = o.rigid;
  c.extent = o.extent;
  return c;
}

} // namespace shot
