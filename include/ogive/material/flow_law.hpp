// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/choice.hpp"
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

/// The two temperatures of a metal that the homologous temperature T* = (T - room)/(melting - room) refers to.
template <class T> struct ReferenceTemperatures {
  T room{};    ///< Tr, K
  T melting{}; ///< Tm, K
};

/// A law of the absolute temperature: the free function `flow_stress(law, plastic_strain, rate_per_s, temperature_K)`.
template <class Law, class N>
concept AbsoluteFlowLaw = requires(const Law &law, N x) {
  { flow_stress(law, x, x, x) } -> std::same_as<FlowStress<N>>;
};

/// A law of the homologous temperature: flow_stress() takes the metal's ReferenceTemperatures as a fifth argument.
template <class Law, class T, class N>
concept HomologousFlowLaw = requires(const Law &law, N x, const ReferenceTemperatures<T> &reference) {
  { flow_stress(law, x, x, x, reference) } -> std::same_as<FlowStress<N>>;
};

/// A flow law of either kind, finite for every plastic strain >= 0, rate > 0 and temperature.
template <class Law, class T>
concept FlowLaw = AbsoluteFlowLaw<Law, T> || HomologousFlowLaw<Law, T, T>;

/// A flow law that also takes packs, so that several points flow at once. Other laws are evaluated point by point.
template <class Law, class T>
concept PackedFlowLaw = AbsoluteFlowLaw<Law, Pack<T>> || HomologousFlowLaw<Law, T, Pack<T>>;

/// The flow stress of the law that the variant holds: a law that is chosen when the program runs.
template <class... Laws, class T, class N>
requires((AbsoluteFlowLaw<Laws, N> ||
          HomologousFlowLaw<Laws, T, N>)&&...) FlowStress<N> flow_stress(const std::variant<Laws...> &law,
                                                                         N plastic_strain, N rate, N temperature,
                                                                         const ReferenceTemperatures<T> &reference) {
  return with_choice(law, [&]<class Law>(const Law &chosen) {
    if constexpr (HomologousFlowLaw<Law, T, N>)
      return flow_stress(chosen, plastic_strain, rate, temperature, reference);
    else
      return flow_stress(chosen, plastic_strain, rate, temperature);
  });
}

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
template <class T, class N>
ThermalFactor<N> thermal_factor(N temperature, const ReferenceTemperatures<T> &reference, T b) {
  using std::max, std::min, std::pow;
  const auto [room, melting] = reference;
  const N scaled = (temperature - room) * (T(1) / (melting - room));
  const auto inside = (scaled > N(0)) & (scaled < N(1));
  const N power = pow(max(N(1e-12), min(scaled, N(1))), b);
  return {select(scaled > N(0), T(1) - select(inside, power, N(1)), N(1)),
          select(inside, -b * power / (scaled * (melting - room)), N(0))};
}

} // namespace ogive
