#pragma once

#include "ogive/core/types.hpp"

#include <algorithm>
#include <concepts>

namespace ogive {

/// Flow stress and its partial derivatives.
template <class T> struct FlowStress {
  T value{};             ///< Pa
  T by_plastic_strain{}; ///< Pa
  T by_rate{};           ///< Pa s
  T by_temperature{};    ///< Pa/K
};

/// A flow law: the free function `flow_stress(law, plastic_strain, rate_per_s, temperature_K)`, finite for every
/// plastic strain >= 0, rate > 0 and temperature.
template <class Law, class T>
concept FlowLaw = requires(const Law &law, T x) {
  { flow_stress(law, x, x, x) } -> std::same_as<FlowStress<T>>;
};

/// Hardening A + B eps^n and its slope. At eps = 0 the slope of n < 1 is infinite; a large finite one is given.
template <class T> struct PowerHardening { T value, slope; };

/// Hardening term shared by the Johnson-Cook family, Pa.
template <class T> PowerHardening<T> power_hardening(T A, T B, T n, T plastic_strain) {
  const T eps = std::max(plastic_strain, T(1e-12));
  const T grown = B * std::pow(eps, n);
  return {A + (plastic_strain > T(0) ? grown : T(0)), n * grown / eps};
}

/// Thermal factor 1 - T*^b with T* clamped to [0, 1], and its slope in 1/K.
template <class T> struct ThermalFactor { T value, slope; };

/// Thermal softening of the Johnson-Cook family: T* = (T - Tr)/(Tm - Tr); 1 below Tr, 0 above Tm.
template <class T> ThermalFactor<T> thermal_factor(T temperature, T room, T melting, T b) {
  const T scaled = (temperature - room) / (melting - room);
  if (!(scaled > T(0))) return {T(1), T(0)};
  if (scaled >= T(1)) return {T(0), T(0)};
  const T power = std::pow(scaled, b);
  return {T(1) - power, -b * power / (scaled * (melting - room))};
}

} // namespace ogive
