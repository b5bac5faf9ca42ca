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

/// How the plate's particles hold together.
enum class Method {
  sfm,        ///< as in the paper: by SPH alone; particles come apart by themselves
  stabilised, ///< zero-energy modes are resisted by bonds (sph/control.hpp); what tears is up to damage
  adaptive    ///< by hexes, which turn into particles where damage has used up the metal (sim/convert.hpp)
};

/// Dc of the methods in which damage counts; for hexes set on the plate of 12 mm of Weldox 460 E, for particles that of
/// Boervik et al. 2001 for that metal; taken for all metals, see docs/beyond.md.
constexpr double softening_of_damage(Method method) { return method == Method::adaptive ? 0.6 : 0.3; }

/// Size of hexes for which the constants of damage hold with the adaptive method, m: set on shots at Weldox 460 E,
/// above all the plate of 12 mm, and taken for all metals, see docs/beyond.md. Stabilised particles have the length of
/// the metal, Damage::shear_length.
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
