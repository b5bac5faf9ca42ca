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
/// alone, and that width grows as heat spreads: a band under fast shear stays hot and weak, one under slow shear cools
/// and recovers. Without this a band is as wide as some particles are, hardly warms and carries shear for far too long.

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

/// Diffusivity of heat k/(rho c_p), m2/s; 0 without conductivity or heat capacity.
template <class T, class Law> T thermal_diffusivity(const Metal<T, Law> &metal) {
  return metal.specific_heat > T(0) ? metal.thermal_conductivity / (metal.density * metal.specific_heat) : T(0);
}

/// The metal of particles `spacing` (m) apart: with the onset of its bands, if it has any. Bands form at a part of
/// instability_strain(), because strain is never even within a particle (an assumption, see docs/beyond.md).
template <class T, class Law> Metal<T, Law> with_shear_bands(Metal<T, Law> metal, T spacing) {
  ShearBand<T> &band = metal.shear_band;
  band.onset = band.spacing = T(0), band.diffusivity = thermal_diffusivity(metal);
  if (!(band.onset_ratio > T(0)) || !(band.diffusivity > T(0))) return metal;
  const T onset = band.onset_ratio * instability_strain(metal, T(1e4));
  if (std::isfinite(onset)) band.onset = onset, band.spacing = spacing;
  return metal;
}

/// True if bands may form in the metal.
template <class T> bool has_bands(const ShearBand<T> &band) { return band.spacing > T(0); }

/// Width of a band, m: 2 sqrt(kappa t), how far heat of the diffusivity kappa (m2/s) spreads from both sides of a plane
/// in the time `age` (s). `N` is T or a pack of T.
template <class T, class N> N band_width(T diffusivity, N age) {
  using std::sqrt;
  return T(2) * sqrt(diffusivity * age);
}

/// By how much the heat of a band that is `age` (s) old warms it above the mean of its particle, over what it adds to
/// that mean: the particle distance over the width, less 1; 0 once the band is as wide as the particle. `N` is T or a
/// pack of T.
template <class T, class N> N heat_excess(const ShearBand<T> &band, N age) {
  using std::max;
  return max(N(0), band.spacing / band_width(band.diffusivity, age) - T(1));
}

/// The part of its temperature above the mean of the particle that a band keeps while its age grows from `before` to
/// `after` (s): the heat stays, the width grows. 0 for a new band, which has no excess. `N` is T or a pack of T.
template <class T, class N> N kept_excess(const ShearBand<T> &band, N before, N after) {
  using std::max;
  return heat_excess(band, after) / max(heat_excess(band, before), N(T(1e-30)));
}

/// Share of simple shear in a flow, which bands need: 1 in simple shear, 0 in flow at least as close to one without
/// rotation: 2 W_k - 1, at least 0, with the kinematic vorticity number W_k = |W|/|D'| (Truesdell 1953), W the spin and
/// D' the deviator of the rate of deformation `D` (1/s); `vorticity` is the curl of the velocity, 1/s. A hole that
/// widens stretches around its edge without rotation. `N` is T or a pack of T.
template <class N> N simple_shear(const Sym3<N> &D, const Vec3<N> &vorticity) {
  using std::max, std::min, std::sqrt;
  const Sym3<N> shape = deviator(D);
  const N spin = 0.5 * (vorticity[0] * vorticity[0] + vorticity[1] * vorticity[1] + vorticity[2] * vorticity[2]);
  return max(N(0), min(N(1), 2 * sqrt(spin / max(double_dot(shape, shape), N(1e-6))) - 1));
}

} // namespace ogive
