// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>

#include <vector>

namespace ogive {

/// State of one material point.
template <class T> struct MaterialPoint {
  Sym3<T> deviator{};      ///< deviatoric Cauchy stress, Pa
  T pressure{};            ///< Pa, positive in compression
  T density{};             ///< kg/m3
  T plastic_strain{};      ///< equivalent plastic strain
  T plastic_strain_rate{}; ///< 1/s, of the last step
  T temperature{};         ///< K
  T damage{};              ///< 0 (sound) upwards, failure strain used up at 1
  T internal_energy{};     ///< work of the stress, J/kg
  T shear_strain{};        ///< part of the plastic strain that was simple shear; 0 where no bands of shear form
  T band_age{};            ///< s, since a band of shear has formed in it
};

/// Cauchy stress of a point, Pa, positive in tension.
template <class T> Sym3<T> stress(const MaterialPoint<T> &p) { return p.deviator - spherical(p.pressure); }

/// The material points of a body, one array for each quantity.
template <class T> struct MaterialPoints {
  std::vector<Mat3<T>> velocity_gradient; ///< 1/s, of the last half step, with respect to the latest positions
  std::vector<Sym3<T>> deviator;          ///< Pa
  std::vector<T> pressure, density;       ///< Pa; kg/m3
  std::vector<T> plastic_strain, plastic_strain_rate;  ///< equivalent; of the last step, 1/s
  std::vector<T> temperature, damage, internal_energy; ///< K; 1 is failure; J/kg

  std::vector<T> shear_strain; ///< part of the plastic strain that was simple shear; empty: no bands of shear form
  std::vector<T> band_age;     ///< s, since a band of shear has formed in the point; empty as well

  /// Pa, mean over the neighbours, made anew in each step; empty: damage follows each point's own pressure.
  std::vector<T> neighbour_pressure;

  /// Pa, flow stress at the smallest rate when the point last did not flow; the strength of bonds is a part of it, and
  /// a point is elastic below it while strain and temperature are those that it belongs to.
  std::vector<T> quasi_static_yield;
  std::vector<T> yield_strain, yield_temperature; ///< that it belongs to: plastic strain; K

  /// Number of points.
  Index size() const { return static_cast<Index>(density.size()); }
};

/// Calls `f(name, unit, values)` for each field of the material state that hashes cover.
template <class P, class F> void for_each_point_field(P &&points, F &&f) {
  f("deviatoric_stress", "Pa", points.deviator);
  f("pressure", "Pa", points.pressure);
  f("density", "kg/m3", points.density);
  f("plastic_strain", "1", points.plastic_strain);
  f("plastic_strain_rate", "1/s", points.plastic_strain_rate);
  f("temperature", "K", points.temperature);
  f("damage", "1", points.damage);
  f("internal_energy", "J/kg", points.internal_energy);
  if (!points.shear_strain.empty()) f("shear_strain", "1", points.shear_strain), f("band_age", "s", points.band_age);
}

/// Calls `f(name, unit, values)` for each other field of the material state: what a point keeps from the step in which
/// it last did not flow. A restart needs it; the fields of for_each_point_field() at that step give it, and so hashes
/// leave it out.
template <class P, class F> void for_each_yield_field(P &&points, F &&f) {
  f("quasi_static_yield", "Pa", points.quasi_static_yield);
  f("yield_strain", "1", points.yield_strain);
  f("yield_temperature", "K", points.yield_temperature);
}

/// Makes `n` points, each in the state `initial`.
template <class T> void fill(MaterialPoints<T> &points, Index n, const MaterialPoint<T> &initial) {
  points.velocity_gradient.assign(n, Mat3<T>::Zero());
  points.deviator.assign(n, initial.deviator);
  points.pressure.assign(n, initial.pressure);
  points.density.assign(n, initial.density);
  points.plastic_strain.assign(n, initial.plastic_strain);
  points.plastic_strain_rate.assign(n, initial.plastic_strain_rate);
  points.temperature.assign(n, initial.temperature);
  points.damage.assign(n, initial.damage);
  points.internal_energy.assign(n, initial.internal_energy);
  points.quasi_static_yield.assign(n, T(0));
  points.yield_strain.assign(n, T(-1));
  points.yield_temperature.assign(n, T(-1));
}

/// Copy of point i.
template <class T> MaterialPoint<T> load(const MaterialPoints<T> &p, Index i) {
  return {p.deviator[i],
          p.pressure[i],
          p.density[i],
          p.plastic_strain[i],
          p.plastic_strain_rate[i],
          p.temperature[i],
          p.damage[i],
          p.internal_energy[i],
          p.shear_strain.empty() ? T(0) : p.shear_strain[i],
          p.band_age.empty() ? T(0) : p.band_age[i]};
}

/// The points `index_of(lane)` as one.
template <class T, class F> MaterialPoint<Pack<T>> load_points(const MaterialPoints<T> &p, F &&index_of) {
  const auto of = [&](const std::vector<T> &field) {
    return pack_of<T>([&](Index lane) { return field[index_of(lane)]; });
  };
  const auto component = [&](T Sym3<T>::*c) {
    return pack_of<T>([&](Index lane) { return p.deviator[index_of(lane)].*c; });
  };
  return {{component(&Sym3<T>::xx), component(&Sym3<T>::yy), component(&Sym3<T>::zz), component(&Sym3<T>::xy),
           component(&Sym3<T>::yz), component(&Sym3<T>::zx)},
          of(p.pressure),
          of(p.density),
          of(p.plastic_strain),
          of(p.plastic_strain_rate),
          of(p.temperature),
          of(p.damage),
          of(p.internal_energy),
          p.shear_strain.empty() ? Pack<T>(T(0)) : of(p.shear_strain),
          p.band_age.empty() ? Pack<T>(T(0)) : of(p.band_age)};
}

/// One lane of a symmetric tensor of packs.
template <class T> Sym3<T> lane_of(const Sym3<Pack<T>> &s, Index lane) {
  return {s.xx[lane], s.yy[lane], s.zz[lane], s.xy[lane], s.yz[lane], s.zx[lane]};
}

/// One lane of several points.
template <class T> MaterialPoint<T> lane_of(const MaterialPoint<Pack<T>> &m, Index lane) {
  return {lane_of(m.deviator, lane),   m.pressure[lane],    m.density[lane], m.plastic_strain[lane],
          m.plastic_strain_rate[lane], m.temperature[lane], m.damage[lane],  m.internal_energy[lane],
          m.shear_strain[lane],        m.band_age[lane]};
}

/// Writes point i.
template <class T> void store(MaterialPoints<T> &p, Index i, const MaterialPoint<T> &s) {
  p.deviator[i] = s.deviator;
  p.pressure[i] = s.pressure;
  p.density[i] = s.density;
  p.plastic_strain[i] = s.plastic_strain;
  p.plastic_strain_rate[i] = s.plastic_strain_rate;
  p.temperature[i] = s.temperature;
  p.damage[i] = s.damage;
  p.internal_energy[i] = s.internal_energy;
  if (!p.shear_strain.empty()) p.shear_strain[i] = s.shear_strain, p.band_age[i] = s.band_age;
}

} // namespace ogive
