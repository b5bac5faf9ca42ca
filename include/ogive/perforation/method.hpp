// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_body.hpp"
#include "ogive/material/metal.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/sph/body.hpp"

namespace ogive {

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
  SphOptions<T> sph{};            ///< of the plate's particles
  HexOptions<T> hex{};            ///< of the projectile and of hexes around particles
  T rim_size_ratio = T(2.5);      ///< hex size at the disc's edge over the particle distance
  T contact_stiffness = T(0.1);   ///< penalty over m/dt^2
  T contact_courant = T(0.4);     ///< of the time step dt that the contact's stiffness is made for
  T largest_added_mass = T(0.01); ///< of the projectile's mass, allowed to raise the time step of thin hexes at a tip
};

/// Numerical methods; they differ in the cohesion of the plate's particles.
enum class Method {
  paper,     ///< as in Liu et al. 2012: by SPH alone; particles come apart by themselves
  stabilised ///< zero-energy modes are resisted by bonds (sph/control.hpp); what tears is up to damage
};

/// Choices of a method, which are the same for all metals, plates and projectiles.
template <class T> struct MethodChoices {
  Lattice lattice{};                ///< of the plate's particles
  DamageLaw damage{};               ///< growth of damage
  FailureEffect failure{};          ///< of damage D = 1 on a particle
  T softening{};                    ///< Dc, part of the flow stress that D = 1 takes away
  T band_onset{};                   ///< of bands of adiabatic shear in the plate, see ShearBand
  T sharp_friction{};               ///< Coulomb, on noses that are not blunt; on blunt ones 0
  PerforationOptions<T> numerics{}; ///< of particles, hexes and contact
};

/// The choices of a method. The paper names its lattice by its figures only, and has no damage; its friction is that on
/// steel, on aluminium it has 0.02. Dc of the stabilised method is that of Boervik et al. 2001, the rest is ours:
/// docs/beyond.md lists the tests on which each choice was made.
template <class T> MethodChoices<T> choices_of(Method method) {
  MethodChoices<T> c;
  if (method == Method::paper) {
    c.lattice = Lattice::cubic;
    c.sharp_friction = T(0.08);
    return c;
  }
  c.lattice = Lattice::ring;
  c.damage = DamageLaw::johnson_cook, c.failure = FailureEffect::no_tension;
  c.softening = T(0.3);
  c.band_onset = T(0.5);
  c.sharp_friction = T(0.02);
  c.numerics.sph.control.stiffness = T(0.3);
  c.numerics.sph.damage_pressure = DamagePressure::neighbours;
  return c;
}

/// The metal of a plate with the damage and the bands of shear that a method needs; the constants of the failure
/// strain are its own, and without any it has no damage.
template <class T, class Law> Metal<T, Law> with_damage_of(Method method, Metal<T, Law> metal) {
  const MethodChoices<T> c = choices_of<T>(method);
  Damage<T> &damage = metal.damage;
  const FailureStrain<T> &f = damage.failure_strain;
  if (f.D1 != T(0) || f.D2 != T(0)) damage.law = c.damage, damage.effect = c.failure, damage.softening = c.softening;
  metal.shear_band.onset_ratio = c.band_onset;
  return metal;
}

} // namespace ogive
