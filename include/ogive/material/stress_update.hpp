#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/material/return_map.hpp"

namespace ogive {

/// Velocity gradient with respect to the positions of the middle of the step, from the one with respect to those of its
/// end: L_mid = L (I - dt/2 L)^-1. A rigid rotation of any size then has no rate of deformation.
template <class T> Mat3<T> midstep_gradient(const Mat3<T> &L, T dt) {
  const Mat3<T> shift = Mat3<T>::Identity() - T(0.5) * dt * L;
  return L * inverse(shift);
}

/// Rotation of a step from the spin W = (L - L^T)/2 (Hughes & Winget 1980): the Jaumann rate, objective for finite
/// steps.
template <class T> Mat3<T> spin_rotation(const Mat3<T> &L, T dt) {
  const T f = T(0.25) * dt;
  const Vec3<T> a(f * (L(2, 1) - L(1, 2)), f * (L(0, 2) - L(2, 0)), f * (L(1, 0) - L(0, 1)));
  Mat3<T> A;
  A << T(0), -a[2], a[1], a[2], T(0), -a[0], -a[1], a[0], T(0);
  return Mat3<T>::Identity() + T(2) / (T(1) + a.dot(a)) * (A + A * A);
}

/// Q s Q^T.
template <class T> Sym3<T> rotated(const Sym3<T> &s, const Mat3<T> &Q) {
  const Mat3<T> r = Q * full(s) * Q.transpose();
  return {r(0, 0), r(1, 1), r(2, 2), r(0, 1), r(1, 2), r(2, 0)};
}

/// Sets the pressure of `now` from its density and energy, and its internal energy from the work of the stress over the
/// step `dt` (s) with the rate of deformation `D` (1/s), by the trapezoidal rule. A failed point has no tension, a
/// removed one no pressure at all.
template <class T, class Law>
void balance(const Metal<T, Law> &metal, const MaterialPoint<T> &old, MaterialPoint<T> &now, const Sym3<T> &D, T dt) {
  const T deviatoric_work =
      T(0.5) * dt * double_dot(T(1) / old.density * old.deviator + T(1) / now.density * now.deviator, D);
  const T volume_half = -T(0.5) * dt * trace(D);
  const T energy = old.internal_energy + deviatoric_work + volume_half * old.pressure / old.density;
  const T mu = now.density / metal.density - T(1);
  now.pressure = pressure(metal.eos, bulk_modulus(metal.elasticity), mu, metal.density * energy);
  if (is_failed(metal.damage, now.damage)) now.pressure = std::max(now.pressure, T(0));
  if (is_removed(metal.damage, now.damage)) now.pressure = T(0);
  now.internal_energy = energy + volume_half * now.pressure / now.density;
}

/// Moves one material point through a step `dt` (s) with the velocity gradient `L` (1/s, with respect to the positions
/// at the end of the step): Jaumann rate, radial return, adiabatic heating (Liu et al. 2012, Eqs. 1-2), pressure,
/// damage (Eqs. 3-4). The point loses its stress in the step in which it fails; what it had stored counts as
/// dissipated.
template <class T, class Law>
MaterialPoint<T> updated(const Metal<T, Law> &metal, const MaterialPoint<T> &old, const Mat3<T> &L, T dt) {
  if (is_removed(metal.damage, old.damage)) return old;
  const Mat3<T> mid = midstep_gradient(L, dt);
  const Sym3<T> D = symmetric_part(mid);
  const T dilatation = trace(D);

  MaterialPoint<T> now = old;
  now.density = old.density * (T(1) - T(0.5) * dt * dilatation) / (T(1) + T(0.5) * dt * dilatation);
  now.plastic_strain_rate = T(0);
  if (is_failed(metal.damage, old.damage)) {
    balance(metal, old, now, D, dt);
    return now;
  }

  Sym3<T> trial = rotated(old.deviator, spin_rotation(mid, dt));
  trial += T(2) * shear_modulus(metal.elasticity) * dt * deviator(D);
  const T q_trial = von_mises(trial);
  const PlasticStep<T> plastic = radial_return(metal, old, q_trial, dt);
  now.deviator = trial;
  if (plastic.increment > T(0)) {
    now.deviator *= plastic.flow_stress / q_trial;
    now.plastic_strain += plastic.increment;
    now.plastic_strain_rate = plastic.increment / dt;
    if (metal.specific_heat > T(0))
      now.temperature +=
          metal.taylor_quinney * plastic.flow_stress * plastic.increment / (metal.density * metal.specific_heat);
  }
  balance(metal, old, now, D, dt);

  if (plastic.increment > T(0) && metal.damage.law != DamageLaw::none) {
    now.damage +=
        damage_growth(metal.damage, now, plastic.increment, std::max(now.plastic_strain_rate, metal.rate_floor),
                      homologous_temperature(metal, now.temperature));
    if (is_failed(metal.damage, now.damage)) {
      now.deviator = Sym3<T>{};
      balance(metal, old, now, D, dt);
    }
  }
  return now;
}

/// Moves all material points of a body (it has `metal` and `points`) through a step; dt = 0 leaves them as they are.
template <class T, class Body> void update_stress(Body &body, T dt) {
  if (dt == T(0)) return;
  parallel_for(body.points.size(), [&](Index i) {
    store(body.points, i, updated(body.metal, load(body.points, i), body.points.velocity_gradient[i], dt));
  });
}

} // namespace ogive
