// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/metal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

/// \file
/// Bands of adiabatic shear in particles that are wider than they are.
///
/// Plastic work heats a metal that is sheared fast, and heat weakens it. From the strain on at which that outweighs
/// hardening, further slip collects in a band some hundredths of a millimetre wide (Zener & Hollomon 1944; Bai & Dodd
/// 1992, Adiabatic Shear Localization, Pergamon). Particles see the mean of such a band and of the metal beside it.
/// Once a particle has slipped far enough in simple shear, its plastic work therefore heats the width of the band
/// alone. Without this a band is as wide as some particles are, hardly warms and carries shear for far too long.

namespace ogive {

/// Plastic strain at which the adiabatic flow stress at the strain rate `rate` (1/s) is largest, from room temperature
/// on; infinity where it still grows at a strain of 10 or the metal is isothermal.
template <class T, class Law> T instability_strain(const Metal<T, Law> &metal, T rate) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (!(metal.specific_heat > T(0))) return infinity;
  constexpr T step = T(1e-3);
  constexpr int steps = 10000;
  T temperature = metal.room_temperature;
  for (int k = 1; k <= steps; ++k) {
    const FlowStress<T> s = flow_stress(metal, (T(k) - T(0.5)) * step, rate, temperature);
    const T heating = metal.taylor_quinney / (metal.density * metal.specific_heat) * s.value;
    if (s.by_plastic_strain + s.by_temperature * heating < T(0)) return (T(k) - T(0.5)) * step;
    temperature += heating * step;
  }
  return infinity;
}

/// Width of bands, m: 2 sqrt(k t/(rho c_p)), how far heat spreads in the time t of ShearBand from both sides of a
/// plane; 0 without that time, conductivity k or heat capacity.
template <class T, class Law> T band_width(const Metal<T, Law> &metal) {
  if (!(metal.specific_heat > T(0))) return T(0);
  return T(2) * std::sqrt(metal.thermal_conductivity * metal.shear_band.time / (metal.density * metal.specific_heat));
}

/// The metal of particles `spacing` (m) apart: with the onset of its bands and with the concentration of heat in them,
/// the particle distance over band_width(). Bands form at 0.4 of instability_strain(), because strain is never even
/// within a particle (an assumption, see docs/beyond.md). There are none in particles finer than they are.
template <class T, class Law> Metal<T, Law> with_shear_bands(Metal<T, Law> metal, T spacing) {
  metal.shear_band.onset = T(0), metal.shear_band.concentration = T(1);
  const T width = band_width(metal);
  if (!(width > T(0)) || width >= spacing) return metal;
  metal.shear_band.onset = T(0.4) * instability_strain(metal, T(1e4));
  metal.shear_band.concentration = spacing / width;
  return metal;
}

/// True if bands may form in the metal.
template <class T> bool has_bands(const ShearBand<T> &band) { return band.concentration > T(1); }

/// How far a flow is simple shear, which bands need: 1 in simple shear, 0 in flow that is as far from it as from one
/// without rotation, or farther: 2 W_k - 1 with the kinematic vorticity number W_k = |W|/|D'| (Truesdell 1953), W the
/// spin and D' the deviator of the rate of deformation `D` (1/s); `vorticity` is the curl of the velocity, 1/s. A hole
/// that widens stretches around its edge without rotation. `N` is T or a pack of T.
template <class N> N simple_shear(const Sym3<N> &D, const Vec3<N> &vorticity) {
  using std::max, std::min, std::sqrt;
  const Sym3<N> shape = deviator(D);
  const N spin = 0.5 * (vorticity[0] * vorticity[0] + vorticity[1] * vorticity[1] + vorticity[2] * vorticity[2]);
  return max(N(0), min(N(1), 2 * sqrt(spin / max(double_dot(shape, shape), N(1e-6))) - 1));
}

} // namespace ogive
