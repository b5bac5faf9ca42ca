// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/johnson_cook_factors.hpp"

namespace ogive {

/// Hardening by Voce 1948 with two terms, and the factors of Johnson & Cook: sigma = [A + sum Qk (1 - exp(-Ck eps))]
/// f(rate) [1 - T*^m]. It saturates at A + Q1 + Q2, as alloys of aluminium do.
template <class T> struct Voce {
  T A{};                           ///< Pa
  T Q1{};                          ///< Pa
  T C1{};                          ///< 1
  T Q2{};                          ///< Pa; 0: one term
  T C2{};                          ///< 1
  JohnsonCookFactors<T> factors{}; ///< of rate and temperature
};

/// Voce's law with the rate factor and the thermal factor of Johnson & Cook 1983. A call of its own: as a part of the
/// return map it would make that longer for all laws.
template <class T, class N>
[[gnu::noinline]] FlowStress<N> flow_stress(const Voce<T> &law, N plastic_strain, N rate, N temperature,
                                            const ReferenceTemperatures<T> &reference) {
  using std::exp;
  const N first = exp(-law.C1 * plastic_strain), second = exp(-law.C2 * plastic_strain);
  const PowerHardening<N> hardening{law.A + law.Q1 * (T(1) - first) + law.Q2 * (T(1) - second),
                                    law.Q1 * law.C1 * first + law.Q2 * law.C2 * second};
  return multiplied(hardening, law.factors, rate, temperature, reference);
}

} // namespace ogive
