// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/material/damage.hpp"
#include "ogive/material/equation_of_state.hpp"
#include "ogive/material/flow_law.hpp"
#include "ogive/material/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ogive {

/// Isotropic elasticity.
template <class T> struct Elasticity {
  T young{};   ///< Pa
  T poisson{}; ///< -0.999 to 0.499
};

/// Shear modulus G = E/(2 (1 + nu)), Pa.
template <class T> T shear_modulus(const Elasticity<T> &e) { return e.young / (T(2) * (T(1) + e.poisson)); }
/// Bulk modulus K = E/(3 (1 - 2 nu)), Pa.
template <class T> T bulk_modulus(const Elasticity<T> &e) { return e.young / (T(3) * (T(1) - T(2) * e.poisson)); }
/// P-wave modulus lambda + 2 mu, Pa.
template <class T> T p_wave_modulus(const Elasticity<T> &e) { return bulk_modulus(e) + T(4) / T(3) * shear_modulus(e); }

/// Bands of adiabatic shear of a metal, see shear_band.hpp.
template <class T> struct ShearBand {
  T onset_ratio = T(0); ///< part of the strain of instability at which they form; 0: none do
  T onset = T(0);       ///< plastic strain in simple shear at which one forms, made by with_shear_bands()
  T spacing = T(0);     ///< particle distance, m, made by with_shear_bands(); 0: no bands
  T diffusivity = T(0); ///< of heat, m2/s, made by with_shear_bands()
};

/// An elastic-plastic metal: elasticity, equation of state, flow law, adiabatic heat, damage.
template <class T, class Law>
requires FlowLaw<Law, T>
struct Metal {
  std::string name;               ///< for messages and files
  std::string source;             ///< of the constants: papers, tables
  std::string confidence;         ///< how far they can be trusted, in words; empty: not known
  T density{};                    ///< kg/m3
  Elasticity<T> elasticity{};     ///< isotropic
  EquationOfState<T> eos{};       ///< pressure
  Law flow{};                     ///< flow stress
  T specific_heat{};              ///< J/(kg K); 0: isothermal
  T thermal_conductivity{};       ///< W/(m K); 0: not known
  T taylor_quinney = T(0.9);      ///< beta, the fraction of plastic work that heats
  T room_temperature = T(293);    ///< Tr, K, also the initial temperature
  T melting_temperature = T(1e4); ///< Tm, K
  T rate_floor = T(1);            ///< smallest plastic strain rate given to the flow law, 1/s
  Damage<T> damage{};             ///< off unless set
  ShearBand<T> shear_band{};      ///< off unless set
};

/// The metal with a law of a more general type: Metal<T, AnyFlowLaw<T>> of one of its laws.
template <class To, class T, class Law> Metal<T, To> with_law(const Metal<T, Law> &m) {
  return {m.name,           m.source,           m.confidence,
          m.density,        m.elasticity,       m.eos,
          To(m.flow),       m.specific_heat,    m.thermal_conductivity,
          m.taylor_quinney, m.room_temperature, m.melting_temperature,
          m.rate_floor,     m.damage,           m.shear_band};
}

/// Longitudinal sound speed, m/s.
template <class T, class Law> T sound_speed(const Metal<T, Law> &m) {
  return std::sqrt(p_wave_modulus(m.elasticity) / m.density);
}

/// The state of the undeformed metal at room temperature.
template <class T, class Law> MaterialPoint<T> initial_point(const Metal<T, Law> &m) {
  MaterialPoint<T> p;
  p.density = m.density;
  p.temperature = m.room_temperature;
  return p;
}

/// Flow stress of a metal at a plastic strain, its rate (1/s) and a temperature (K): that of its law at the metal's
/// reference temperatures. `N` is T or a pack of T.
template <class T, class Law, class N>
FlowStress<N> flow_stress(const Metal<T, Law> &m, N plastic_strain, N rate, N temperature) {
  if constexpr (HomologousFlowLaw<Law, T, N>)
    return flow_stress(m.flow, plastic_strain, rate, temperature,
                       ReferenceTemperatures<T>{m.room_temperature, m.melting_temperature});
  else
    return flow_stress(m.flow, plastic_strain, rate, temperature);
}

/// T* = (T - Tr)/(Tm - Tr), between 0 and 1. `N` is T or a pack of T.
template <class T, class Law, class N> N homologous_temperature(const Metal<T, Law> &m, N temperature) {
  using std::max, std::min;
  const N scaled = (temperature - m.room_temperature) / (m.melting_temperature - m.room_temperature);
  return max(N(0), min(N(1), scaled));
}

/// Throws SetupError if a constant of the metal's damage is out of range.
template <class T> void check(const Damage<T> &damage, const std::string &metal) {
  if (damage.law == DamageLaw::cockcroft_latham)
    require(std::isfinite(damage.critical_work) && damage.critical_work > T(0), metal + " critical work W_cr (Pa)",
            damage.critical_work, "must be positive and finite for damage by Cockcroft-Latham");
  if (damage.law != DamageLaw::johnson_cook) return;
  const FailureStrain<T> &f = damage.failure_strain;
  const std::array<T, 5> constants{f.D1, f.D2, f.D3, f.D4, f.D5};
  for (std::size_t k = 0; k < constants.size(); ++k)
    require(std::isfinite(constants[k]), metal + " D" + std::to_string(k + 1), constants[k], "must be finite");
  require(f.D1 > T(0) || f.D2 > T(0), metal + " D1 and D2", f.D1, "one must be positive for damage by Johnson-Cook");
  require(std::isfinite(f.reference_rate) && f.reference_rate > T(0), metal + " reference rate of the damage (1/s)",
          f.reference_rate, "must be positive and finite");
}

/// Throws SetupError if a constant is out of range, or if the flow stress of the undeformed metal at its smallest rate
/// and room temperature is not positive and finite.
template <class T, class Law> void check(const Metal<T, Law> &m) {
  const auto positive = [&](T v, const char *thing) {
    require(std::isfinite(v) && v > T(0), m.name + " " + thing, v, "must be positive and finite");
  };
  positive(m.density, "density (kg/m3)");
  positive(m.elasticity.young, "Young's modulus (Pa)");
  require(m.elasticity.poisson > T(-0.999) && m.elasticity.poisson < T(0.499), m.name + " Poisson's ratio",
          m.elasticity.poisson, "must lie between -0.999 and 0.499");
  require(m.specific_heat >= T(0) && std::isfinite(m.specific_heat), m.name + " specific heat (J/kgK)", m.specific_heat,
          "must not be negative");
  require(m.thermal_conductivity >= T(0) && std::isfinite(m.thermal_conductivity),
          m.name + " thermal conductivity (W/mK)", m.thermal_conductivity, "must not be negative");
  require(m.taylor_quinney >= T(0) && m.taylor_quinney <= T(1), m.name + " Taylor-Quinney coefficient",
          m.taylor_quinney, "must lie between 0 and 1");
  positive(m.rate_floor, "rate floor (1/s)");
  require(m.melting_temperature > m.room_temperature, m.name + " melting temperature (K)", m.melting_temperature,
          "must lie above room temperature");
  positive(flow_stress(m, T(0), m.rate_floor, m.room_temperature).value,
           "flow stress (Pa) at zero plastic strain, the rate floor and room temperature");
  check(m.damage, m.name);
}

/// Work of slow tension, Pa: the integral of the flow stress up to the plastic strain `end`, at room temperature and
/// the metal's smallest rate.
template <class T, class Law> T work_of_tension(const Metal<T, Law> &metal, T end) {
  // In s = sqrt(eps/end) the integrand is smooth where hardening starts steeply; the midpoint rule is good to 1e-6.
  constexpr int intervals = 1000;
  T work{};
  for (int k = 0; k < intervals; ++k) {
    const T s = (T(k) + T(0.5)) / T(intervals);
    work +=
        T(2) * s * end / T(intervals) * flow_stress(metal, s * s * end, metal.rate_floor, metal.room_temperature).value;
  }
  return work;
}

/// W_cr (Pa) with which Cockcroft & Latham's criterion fails a smooth bar in slow tension (triaxiality 1/3, at room
/// temperature and the metal's smallest rate) at the plastic strain at which the metal's Johnson-Cook failure strain
/// does: work_of_tension() up to there. For metals of which only D1 to D5 are published.
template <class T, class Law> T critical_work_of_tension(const Metal<T, Law> &metal) {
  return work_of_tension(metal, failure_strain(metal.damage.failure_strain, T(1) / T(3), metal.rate_floor, T(0)));
}

} // namespace ogive
