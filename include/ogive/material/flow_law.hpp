// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>

namespace ogive {

/// Flow stress and its partial derivatives.
template <class N> struct FlowStress {
  N value{};             ///< Pa
  N by_plastic_strain{}; ///< Pa
  N by_rate{};           ///< Pa s
  N by_temperature{};    ///< Pa/K
};

/// A flow law: the free function `flow_stress(law, plastic_strain, rate_per_s, temperature_K)`, finite for every
/// plastic strain >= 0, rate > 0 and temperature.
template <class Law, class T>
concept FlowLaw = requires(const Law &law, T x) {
  { flow_stress(law, x, x, x) } -> std::same_as<FlowStress<T>>;
};

/// A flow law that also takes packs, so that several points flow at once. Others are asked point by point.
template <class Law, class T>
concept PackedFlowLaw = FlowLaw<Law, Pack<T>>;

/// Hardening A + B eps^n and its slope. At eps = 0 the slope of n < 1 is infinite; a large finite one is given.
template <class N> struct PowerHardening {
  N value; ///< Pa
  N slope; ///< by plastic strain, Pa
};

/// Hardening term shared by the Johnson-Cook family, Pa. `N` is T or a pack of T, here as in all that follows.
template <class T, class N> PowerHardening<N> power_hardening(T A, T B, T n, N plastic_strain) {
  using std::max, std::pow;
  const N eps = max(plastic_strain, N(1e-12)), grown = B * pow(eps, n);
  return {A + select(plastic_strain > N(0), grown, N(0)), n * grown / eps};
}

/// Thermal factor 1 - T*^b with T* clamped to [0, 1], and its slope in 1/K.
template <class N> struct ThermalFactor {
  N value; ///< 0 to 1
  N slope; ///< by temperature, 1/K
};

/// Thermal softening of the Johnson-Cook family: T* = (T - Tr)/(Tm - Tr); 1 below Tr, 0 above Tm.
template <class T, class N> ThermalFactor<N> thermal_factor(N temperature, T room, T melting, T b) {
  using std::max, std::min, std::pow;
  const N scaled = (temperature - room) * (T(1) / (melting - room));
  const auto inside = (scaled > N(0)) & (scaled < N(1));
  const N power = pow(max(N(1e-12), min(scaled, N(1))), b);
  return {select(scaled > N(0), T(1) - select(inside, power, N(1)), N(1)),
          select(inside, -b * power / (scaled * (melting - room)), N(0))};
}

} // namespace ogive
