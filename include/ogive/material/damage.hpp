// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"
#include "ogive/material/points.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// The two published effects of the rate on the failure strain.
enum class FailureRateTerm {
  power,      ///< (rate/reference)^D4 (Liu et al. 2012, Eq. 4)
  logarithmic ///< 1 + D4 ln(rate/reference) (Johnson & Cook 1985)
};

/// Constants of the failure strain (Liu et al. 2012, Eq. 4). The paper has no reference rate: 1/s.
template <class T> struct FailureStrain {
  T D1{}, D2{}, D3{}, D4{}, D5{};                     ///< of Eq. 4, 1
  T reference_rate = T(1);                            ///< 1/s, what published values of D4 are relative to
  FailureRateTerm rate_term = FailureRateTerm::power; ///< which of the two
};

/// eps_f = [D1 + D2 exp(D3 triaxiality)] r(rate) [1 + D5 T*] (Johnson & Cook 1985; Liu et al. 2012, Eq. 4), never below
/// 1e-6. Below the reference rate r is 1, for either term. `N` is T or a pack of T.
template <class T, class N>
N failure_strain(const FailureStrain<T> &f, N triaxiality, N rate, N homologous_temperature) {
  using std::exp, std::log, std::max, std::pow;
  const N scaled = max(N(rate / f.reference_rate), N(1));
  const N term = f.rate_term == FailureRateTerm::power ? N(pow(scaled, f.D4)) : N(T(1) + f.D4 * log(scaled));
  const N strain = (f.D1 + f.D2 * exp(f.D3 * triaxiality)) * term * (T(1) + f.D5 * homologous_temperature);
  return max(strain, N(1e-6));
}

/// Growth of damage with plastic strain.
enum class DamageLaw {
  none,            ///< it does not
  johnson_cook,    ///< D = sum of d eps / eps_f (Liu et al. 2012, Eqs. 3-4; Johnson & Cook 1985)
  cockcroft_latham ///< D = 1/W_cr times the integral of max(sigma_1, 0) d eps (Cockcroft & Latham 1968)
};

/// The behaviour of a material point once its damage has reached 1.
enum class FailureEffect {
  none,       ///< none: damage is only written (the paper's runs)
  no_tension, ///< it carries neither shear nor tension, pressure only
  removal     ///< it exerts no force; its nodes keep mass and velocity
};

/// Damage of a metal.
template <class T> struct Damage {
  DamageLaw law = DamageLaw::none;            ///< growth of damage
  FailureEffect effect = FailureEffect::none; ///< of damage 1
  FailureStrain<T> failure_strain{};          ///< of the Johnson-Cook law
  T critical_work{};                          ///< W_cr of the Cockcroft-Latham law, Pa
  T softening = T(0);                         ///< Dc: the flow stress is multiplied by 1 - Dc D (Boervik et al. 2001)
};

/// True if a point with the damage `D` has failed, so that failure shows.
template <class T> bool is_failed(const Damage<T> &damage, T D) {
  return damage.effect != FailureEffect::none && D >= T(1);
}

/// True if a point with the damage `D` has been removed.
template <class T> bool is_removed(const Damage<T> &damage, T D) {
  return damage.effect == FailureEffect::removal && D >= T(1);
}

/// Largest principal value of a stress given by its deviator and pressure (Pa), by the Lode angle: sigma_1 = -p +
/// 2/3 q cos(theta), cos(3 theta) = 27/2 J3/q^3.
template <class T> T largest_principal_stress(const Sym3<T> &deviator, T pressure) {
  const T q = von_mises(deviator);
  if (!(q > T(0))) return -pressure;
  const Sym3<T> s = T(1) / q * deviator;
  const T J3 =
      s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.zx) + s.zx * (s.xy * s.yz - s.yy * s.zx);
  return -pressure + T(2) / T(3) * q * std::cos(std::acos(std::clamp(T(13.5) * J3, T(-1), T(1))) / T(3));
}

/// Mean over equivalent stress, positive in tension, between -10 and 10: molten metal has no equivalent stress to
/// divide by. `N` is T or a pack of T.
template <class N> N triaxiality(const MaterialPoint<N> &point) {
  using std::max, std::min;
  return max(N(-10), min(N(10), N(-point.pressure / max(von_mises(point.deviator), N(1)))));
}

/// Growth of the damage of Johnson and Cook, see damage_growth(). `N` is T or a pack of T.
template <class T, class N>
N johnson_cook_growth(const Damage<T> &damage, const MaterialPoint<N> &point, N increment, N rate, N homologous) {
  return increment / failure_strain(damage.failure_strain, triaxiality(point), rate, homologous);
}

/// johnson_cook_growth() of several points at once; other laws go point by point.
template <class T>
Pack<T> damage_growth(const Damage<T> &damage, const MaterialPoint<Pack<T>> &point, Pack<T> increment, Pack<T> rate,
                      Pack<T> homologous) {
  return johnson_cook_growth(damage, point, increment, rate, homologous);
}

/// Growth of the damage while the plastic strain of `point` grows by `increment` (>= 0) to its present state, at `rate`
/// (1/s) and the homologous temperature T*. Never negative.
template <class T>
T damage_growth(const Damage<T> &damage, const MaterialPoint<T> &point, T increment, T rate, T homologous) {
  switch (damage.law) {
  case DamageLaw::johnson_cook:
    return johnson_cook_growth(damage, point, increment, rate, homologous);
  case DamageLaw::cockcroft_latham:
    return increment * std::max(T(0), largest_principal_stress(point.deviator, point.pressure)) / damage.critical_work;
  case DamageLaw::none:
    break;
  }
  return T(0);
}

} // namespace ogive
