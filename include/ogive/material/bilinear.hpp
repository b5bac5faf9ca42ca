// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/flow_law.hpp"

namespace ogive {

/// Bilinear isotropic hardening: sigma = yield + hardening eps.
template <class T> struct Bilinear {
  T yield{};     ///< Pa
  T hardening{}; ///< plastic modulus H = E Et / (E - Et), Pa
};

/// Plastic modulus from Young's modulus and the tangent modulus of the stress-strain curve, Pa.
template <class T> T plastic_modulus(T young, T tangent) { return young * tangent / (young - tangent); }

/// Bilinear isotropic hardening; rate and temperature have no effect.
template <class T, class N> FlowStress<N> flow_stress(const Bilinear<T> &law, N plastic_strain, N, N) {
  return {law.yield + law.hardening * plastic_strain, N(law.hardening), N(0), N(0)};
}

} // namespace ogive
