// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_body.hpp"
#include "ogive/sim/conversion.hpp"
#include "ogive/sph/body.hpp"

namespace ogive {

/// What the struck part of the plate is made of.
enum class PlateKind {
  particles, ///< a disc of particles, in a rim of hexes that it is tied to
  hexes      ///< hexes that turn into particles where they fail
};

/// Kernel and form of the particles and rule of the hexes: types, or variants of types where a program chooses.
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class Rule = OnePoint> struct Discretisation {
  Kernel kernel{}; ///< of particles
  Form form{};     ///< of their gradients and forces
  Rule rule{};     ///< of hexes
};

/// Those of a program that chooses.
using AnyDiscretisation = Discretisation<AnyKernel, AnyForm, AnyRule>;

/// Numerical choices of a perforation model; the defaults are the same for all cases.
template <class T> struct PerforationOptions {
  PlateKind plate = PlateKind::particles; ///< what it is made of
  SphOptions<T> sph{};                    ///< of the plate's particles
  HexOptions<T> hex{};                    ///< of the projectile and of hexes around particles
  HexOptions<T> plate_hex{};              ///< of a plate of hexes
  ConversionOptions<T> conversion{};      ///< of its hexes into particles
  T fine_radius_ratio = T(1.6);           ///< radius up to which a plate of hexes is fine, over the projectile's
  T rim_size_ratio = T(2.5);              ///< hex size at the disc's edge over the particle distance
  T contact_stiffness = T(0.1);           ///< penalty over m/dt^2
  T contact_courant = T(0.4);             ///< of the time step dt that the contact's stiffness is made for
  T largest_added_mass = T(0.01); ///< of the projectile's mass, allowed to raise the time step of thin hexes at a tip
};

} // namespace ogive
