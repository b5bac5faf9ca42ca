// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/johnson_cook_factors.hpp"

namespace ogive {

/// Power law beyond yield with the factors of Johnson & Cook: sigma = Y (E eps/Y)^n f(rate) [1 - T*^m], where eps is
/// the total strain of slow tension, plastic strain and the elastic strain sigma/E. Three numbers of a tensile test
/// give it, see fit/tensile_numbers.hpp.
template <class T> struct PowerLaw {
  T yield{};                       ///< Y, Pa
  T modulus{};                     ///< E, Pa: Young's modulus of the metal
  T n{};                           ///< hardening exponent, 0 to 0.6
  JohnsonCookFactors<T> factors{}; ///< of rate and temperature
};

/// Hardening Y (E eps/Y)^n of a plastic strain, Pa. The total strain has the elastic strain sigma/E in it, so that s =
/// sigma/Y solves s = (E eps_p/Y + s)^n: two steps of Newton's method from (1 + E eps_p/Y)^n, good to 2e-6 for n up to
/// 0.6.
template <class T, class N> PowerHardening<N> total_strain_hardening(const PowerLaw<T> &law, N plastic_strain) {
  using std::pow;
  const N x = plastic_strain * (law.modulus / law.yield);
  N s = pow(T(1) + x, law.n);
  for (int step = 0; step < 2; ++step) {
    const N power = pow(x + s, law.n);
    s = s + (power - s) / (T(1) - law.n * power / (x + s));
  }
  const N slope = law.n * s / (x + s);
  return {law.yield * s, law.modulus * slope / (T(1) - slope)};
}

/// The power law of Boervik, Forrestal & Warren 2010 (Exp. Mech. 50:969) and of Ryan et al. 2023, with the factors of
/// Johnson & Cook 1983. A call of its own: as a part of the return map it would make that longer for all laws.
template <class T, class N>
[[gnu::noinline]] FlowStress<N> flow_stress(const PowerLaw<T> &law, N plastic_strain, N rate, N temperature,
                                            const ReferenceTemperatures<T> &reference) {
  return multiplied(total_strain_hardening(law, plastic_strain), law.factors, rate, temperature, reference);
}

} // namespace ogive
