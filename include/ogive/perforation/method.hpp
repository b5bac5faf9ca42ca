// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/setup.hpp"

namespace ogive {

/// How the plate's particles hold together.
enum class Method {
  sfm,        ///< as in the paper: by SPH alone; particles come apart by themselves
  stabilised, ///< zero-energy modes are resisted by bonds (sph/control.hpp); what tears is up to damage
  adaptive    ///< by hexes, which turn into particles where damage has used up the metal (sim/convert.hpp)
};

/// Dc of the methods in which damage counts; for hexes set on the plate of 12 mm of Weldox 460 E, for particles that of
/// Boervik et al. 2001 for that metal; taken for all metals, see docs/beyond.md.
constexpr double softening_of_damage(Method method) { return method == Method::adaptive ? 0.6 : 0.3; }

/// Size of hexes for which the constants of damage hold with the adaptive method, m: set on shots at Weldox 460 E, above
/// all the plate of 12 mm, and taken for all metals, see docs/beyond.md. Stabilised particles have the length of the
/// metal, Damage::shear_length.
inline constexpr double length_of_hex_damage = 0.22e-3;

/// Exponent with which failure strains follow the particle distance in those methods: chosen on the plate of 12 mm with
/// distances of 0.6 to 1.2 mm, see docs/beyond.md.
constexpr double length_exponent_of_damage(Method method) { return method == Method::adaptive ? 0.25 : 1.0; }

/// Where they do: hexes at any stress; stabilised particles in shear alone, of which a band is as wide as some of them,
/// however fine, see docs/beyond.md.
constexpr LengthScope length_scope_of_damage(Method method) {
  return method == Method::stabilised ? LengthScope::in_shear : LengthScope::everywhere;
}

/// The numerical choices of a method, the same for all cases.
template <class T> PerforationOptions<T> options_of(Method method) {
  PerforationOptions<T> options;
  if (method == Method::stabilised) {
    options.sph.control.stiffness = T(0.3);
    options.sph.damage_pressure = DamagePressure::neighbours;
  }
  if (method == Method::adaptive) {
    options.plate = PlateKind::hexes;
    options.plate_hex.hourglass_stiffness = T(0.02);
    options.plate_hex.hourglass_while_flowing = T(0.1);
  }
  return options;
}

} // namespace ogive
