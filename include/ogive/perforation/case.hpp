// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/fem/projectile.hpp"

namespace ogive {

/// How the particles of the plate are laid out.
enum class Lattice {
  cubic, ///< simple cubic, cut at the disc's edge
  ring   ///< concentric rings, layer by layer
};

/// A projectile that strikes a clamped round plate along the plate's axis. The plate lies between z = 0 (front) and
/// z = -thickness, the projectile flies towards -z. SI units.
template <class T> struct PerforationCase {
  T thickness = T(12e-3);          ///< of the plate, m
  T clamp_radius = T(250e-3);      ///< of the plate, m
  T sph_radius = T(24e-3);         ///< radius of the disc of particles, m
  T spacing = T(0.6e-3);           ///< particle distance asked for, m
  Lattice lattice = Lattice::ring; ///< cubic ones break up along their rows under tension
  Nose nose = Nose::blunt;         ///< of the paper's projectile
  T initial_velocity = T(303.5);   ///< m/s
  T friction = T(0);               ///< Coulomb, plate on projectile
  bool rigid_projectile = false;   ///< it moves as one, and does not deform
  Extent extent = Extent::quarter; ///< how much of the model is computed
};

} // namespace ogive
