// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/setup.hpp"
#include "ogive/sim/hash.hpp"

#include <numbers>
#include <type_traits>
#include <vector>

namespace sim_test {

using namespace ogive;

/// A coarse plate that is struck fast: a few hundred particles.
inline PerforationCase<double> small_case(Nose nose, Extent extent) {
  PerforationCase<double> c;
  c.thickness = 6e-3;
  c.clamp_radius = 40e-3;
  c.sph_radius = 15e-3;
  c.spacing = 1.5e-3;
  c.projectile = paper_projectile<double>(nose);
  c.initial_velocity = 300;
  c.friction = 0.1;
  c.extent = extent;
  return c;
}

inline auto small_shot(const PerforationCase<double> &c) {
  return make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
}

/// A metal that fails at the plastic strain 0.1 and then shows it as `effect`.
template <class Law> Metal<double, Law> brittle(Metal<double, Law> metal, FailureEffect effect) {
  metal.damage.law = DamageLaw::johnson_cook;
  metal.damage.effect = effect;
  metal.damage.failure_strain = {0.1, 0, 0, 0, 0, 1};
  return metal;
}

/// The same at 30 degrees with a rigid projectile, which turns.
inline PerforationCase<double> turning_case(Extent extent) {
  auto c = small_case(Nose::blunt, extent);
  c.sph_radius = 20e-3;
  c.obliquity = std::numbers::pi / 6;
  c.rigid_projectile = true;
  return c;
}

/// The same with all that a shot can have: friction, damage with its effect, by the pressure of the neighbours, bands
/// of shear, bonds, a smoothing length that follows the density, mirror planes. With AnyDiscretisation the model is the
/// one that programs run.
template <class Parts = Discretisation<>>
auto full_shot(FailureEffect effect, bool rigid, Nose nose = Nose::conical, const Parts &parts = {}) {
  auto c = small_case(nose, Extent::quarter);
  c.rigid_projectile = rigid;
  auto plate = library::weldox_460e_mjc<double>();
  plate.damage.law = DamageLaw::johnson_cook;
  plate.damage.effect = effect;
  plate.damage.failure_strain = {0.05, 0.05, -1.5, 0, 0, 1};
  plate.damage.softening = 0.3;
  plate.shear_band.onset_ratio = 0.4;
  plate.flow.B = 0; // heat outweighs hardening from the first strain on
  PerforationOptions<double> numerics;
  numerics.sph.variable_smoothing = true;
  numerics.sph.control.stiffness = 0.3;
  numerics.sph.damage_pressure = DamagePressure::neighbours;
  const auto steel = library::arne_tool_steel<double>();
  if constexpr (std::is_same_v<Parts, AnyDiscretisation>)
    return make_perforation(c, std::vector{with_law<AnyFlowLaw<double>>(plate)}, with_law<AnyFlowLaw<double>>(steel),
                            numerics, parts);
  else
    return make_perforation(c, std::vector{plate}, steel, numerics, parts);
}

} // namespace sim_test
