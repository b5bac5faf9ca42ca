// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/parallel.hpp"
#include "ogive/material/return_map.hpp"
#include "ogive/material/shear_band.hpp"

#include <array>
#include <limits>
#include <optional>
#include <span>

namespace ogive {

/// Velocity gradient with respect to the positions of the middle of the step, from the one with respect to those of its
/// end: L_mid = L (I - dt/2 L)^-1. A rigid rotation of any size then has no rate of deformation.
template <class T> Mat3<T> midstep_gradient(const Mat3<T> &L, T dt) {
  Mat3<T> shift = L * (T(-0.5) * dt);
  for (int k = 0; k < 3; ++k) shift(k, k) += T(1);
  return product(L, inverse(shift));
}

/// Rotation of a step from the spin W = (L - L^T)/2 (Hughes & Winget 1980): the Jaumann rate, objective for finite
/// steps.
template <class T> Mat3<T> spin_rotation(const Mat3<T> &L, T dt) {
  const T f = T(0.25) * dt;
  const Vec3<T> a(f * (L(2, 1) - L(1, 2)), f * (L(0, 2) - L(2, 0)), f * (L(1, 0) - L(0, 1)));
  // I + f (A + A A) with A the matrix of the cross product with a.
  const T squared = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], rotation = T(2) / (T(1) + squared);
  Mat3<T> Q;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    Q(i, i) = T(1) + rotation * (a[i] * a[i] - squared);
    Q(j, k) = rotation * (a[j] * a[k] - a[i]);
    Q(k, j) = rotation * (a[j] * a[k] + a[i]);
  }
  return Q;
}

/// Q s Q^T.
template <class T> Sym3<T> rotated(const Sym3<T> &s, const Mat3<T> &Q) {
  const Mat3<T> r = product(Q, full(s));
  const auto at = [&](int i, int j) { return T(r(i, 0) * Q(j, 0) + r(i, 1) * Q(j, 1) + r(i, 2) * Q(j, 2)); };
  return {at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(1, 2), at(2, 0)};
}

/// A point after a step without plastic flow.
template <class N> struct ElasticTrial {
  MaterialPoint<N> point;   ///< density and deviator of the end of the step
  Sym3<N> deformation_rate; ///< D, 1/s, at the middle of the step
  Vec3<N> vorticity;        ///< curl of the velocity, 1/s, there
  N equivalent_stress;      ///< von Mises, Pa
};

/// Moves density and deviatoric stress through a step `dt` (s) as if nothing yielded: Jaumann rate. `N` is T or a pack.
template <class T, class Law, class N>
ElasticTrial<N> elastic_trial(const Metal<T, Law> &metal, const MaterialPoint<N> &old, const Mat3<N> &L, T dt) {
  const Mat3<N> mid = midstep_gradient<N>(L, dt);
  ElasticTrial<N> trial{
      old, symmetric_part(mid), Vec3<N>(mid(2, 1) - mid(1, 2), mid(0, 2) - mid(2, 0), mid(1, 0) - mid(0, 1)), {}};
  const N growth = T(0.5) * dt * trace(trial.deformation_rate);
  trial.point.density = old.density * ((T(1) - growth) / (T(1) + growth));
  trial.point.deviator = rotated(old.deviator, spin_rotation<N>(mid, dt));
  trial.point.deviator += N(T(2) * shear_modulus(metal.elasticity) * dt) * deviator(trial.deformation_rate);
  trial.point.plastic_strain_rate = N(0);
  trial.equivalent_stress = von_mises(trial.point.deviator);
  return trial;
}

/// Sets the pressure of `now` from its density and energy, and its internal energy from the work of the stress over the
/// step `dt` (s) with the rate of deformation `D` (1/s), by the trapezoidal rule. The pressure is kept between `lowest`
/// and `highest` (Pa).
template <class T, class Law, class N>
void balance(const Metal<T, Law> &metal, const MaterialPoint<N> &old, MaterialPoint<N> &now, const Sym3<N> &D, T dt,
             T lowest, T highest) {
  using std::max, std::min;
  const N old_volume = T(1) / old.density, volume = T(1) / now.density;
  const N deviatoric_work = T(0.5) * dt * double_dot(old_volume * old.deviator + volume * now.deviator, D);
  const N volume_half = T(-0.5) * dt * trace(D);
  const N energy = old.internal_energy + deviatoric_work + volume_half * old.pressure * old_volume;
  const N mu = (now.density - metal.density) * (T(1) / metal.density);
  const N free = pressure<T, N>(metal.eos, bulk_modulus(metal.elasticity), mu, metal.density * energy);
  now.pressure = max(N(lowest), min(N(highest), free));
  now.internal_energy = energy + volume_half * now.pressure * volume;
}

/// Takes shear and tension from a point that has failed; from one that has been removed pressure as well.
template <class T, class Law>
void lose_stress(const Metal<T, Law> &metal, const MaterialPoint<T> &old, MaterialPoint<T> &now, const Sym3<T> &D,
                 T dt) {
  now.deviator = Sym3<T>{};
  balance(metal, old, now, D, dt, T(0),
          is_removed(metal.damage, now.damage) ? T(0) : std::numeric_limits<T>::infinity());
}

/// A point after a step.
template <class N> struct Advanced {
  MaterialPoint<N> point; ///< at the end of the step
  N yield{};              ///< flow stress at the smallest rate, Pa, of a point that did not flow; else -1
};

/// A step of the band of shear in a point, if there is one.
template <class N> struct BandStep {
  N share{};          ///< of the flow that is simple shear
  N age{};            ///< s, at the end of the step
  N concentration{1}; ///< of the heat of the step
  N cooling{};        ///< K, by heat that spreads
};

/// A step `dt` (s) of a band that forms in a point or is there. The mean temperature of the point, above which a band
/// is hot, follows from its internal energy.
template <class T, class Law, class N>
BandStep<N> band_step(const Metal<T, Law> &metal, const MaterialPoint<N> &old, const ElasticTrial<N> &trial, T dt) {
  using std::max;
  BandStep<N> step;
  if (!has_bands(metal.shear_band)) return step;
  step.share = simple_shear(trial.deformation_rate, trial.vorticity);
  const auto formed = old.shear_strain >= N(metal.shear_band.onset);
  const N after = old.band_age + dt;
  step.age = select(formed, after, N(0));
  step.concentration = T(1) + select(formed, step.share * heat_excess(metal.shear_band, after), N(0));
  const N mean = metal.room_temperature + metal.taylor_quinney / metal.specific_heat * old.internal_energy;
  const N excess = max(N(0), old.temperature - mean);
  step.cooling = select(formed, excess * (T(1) - kept_excess(metal.shear_band, old.band_age, after)), N(0));
  return step;
}

/// Takes the trial stress back to the flow stress and heats the point (Liu et al. 2012, Eqs. 1-2), or the band of shear
/// in it.
template <class T, class Law, class N>
Advanced<N> flowed(const Metal<T, Law> &metal, const MaterialPoint<N> &old, const ElasticTrial<N> &trial, T dt) {
  const BandStep<N> band = band_step(metal, old, trial, dt);
  MaterialPoint<N> cooled = old;
  cooled.temperature -= band.cooling;
  const PlasticStep<N> plastic = radial_return(metal, cooled, trial.equivalent_stress, dt, band.concentration);
  const auto flows = plastic.increment > N(0);
  MaterialPoint<N> now = trial.point;
  now.temperature = cooled.temperature;
  now.deviator *= select(flows, plastic.flow_stress / trial.equivalent_stress, N(1));
  now.plastic_strain += plastic.increment;
  now.shear_strain += band.share * plastic.increment;
  now.band_age = band.age;
  now.plastic_strain_rate = plastic.increment * (T(1) / dt);
  if (metal.specific_heat > T(0))
    now.temperature += band.concentration * (metal.taylor_quinney / (metal.density * metal.specific_heat)) *
                       (plastic.flow_stress * plastic.increment);
  return {now, select(flows, N(-1), plastic.flow_stress)};
}

/// Adds the growth of damage in a step `dt` (s) after which the point is `now`. With `neighbour_pressure` (Pa) damage
/// follows that pressure instead of the point's own. `N` is T or, except for damage by Cockcroft and Latham, a pack.
template <class T, class Law, class N>
void grow_damage(const Metal<T, Law> &metal, MaterialPoint<N> &now, T dt, const std::optional<N> &neighbour_pressure) {
  using std::max;
  const auto flows = now.plastic_strain_rate > N(0);
  if (metal.damage.law == DamageLaw::none || !any(flows)) return;
  MaterialPoint<N> seen = now;
  seen.pressure = neighbour_pressure.value_or(now.pressure);
  const N growth = damage_growth(metal.damage, seen, N(now.plastic_strain_rate * dt),
                                 N(max(now.plastic_strain_rate, N(metal.rate_floor))),
                                 homologous_temperature(metal, now.temperature));
  now.damage += select(flows, growth, N(0));
}

/// The end of a step `dt` (s) for points that have not failed, up to their loss of stress should they fail: radial
/// return, adiabatic heating, pressure, damage. `N` and `neighbour_pressure` as in grow_damage().
template <class T, class Law, class N>
Advanced<N> advanced_sound(const Metal<T, Law> &metal, const MaterialPoint<N> &old, const ElasticTrial<N> &trial, T dt,
                           const std::optional<N> &neighbour_pressure) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  Advanced<N> after = flowed(metal, old, trial, dt);
  balance(metal, old, after.point, trial.deformation_rate, dt, -infinity, infinity);
  grow_damage(metal, after.point, dt, neighbour_pressure);
  return after;
}

/// Moves one material point through a step `dt` (s) with the velocity gradient `L` (1/s, with respect to the positions
/// at the end of the step): Jaumann rate, radial return, adiabatic heating, pressure, damage (Liu et al. 2012, Eqs.
/// 3-4). The point loses its stress in the step in which it fails; what it had stored counts as dissipated. With
/// `neighbour_pressure` (Pa) damage follows that pressure instead of the point's own.
template <class T, class Law>
Advanced<T> advanced(const Metal<T, Law> &metal, const MaterialPoint<T> &old, const Mat3<T> &L, T dt,
                     const std::optional<T> &neighbour_pressure = {}) {
  if (is_removed(metal.damage, old.damage)) return {old, T(-1)};
  const ElasticTrial<T> trial = elastic_trial(metal, old, L, dt);
  Advanced<T> after{trial.point, T(-1)};
  if (!is_failed(metal.damage, old.damage)) after = advanced_sound(metal, old, trial, dt, neighbour_pressure);
  if (is_failed(metal.damage, after.point.damage)) lose_stress(metal, old, after.point, trial.deformation_rate, dt);
  return after;
}

/// advanced(), the point alone.
template <class T, class Law>
MaterialPoint<T> updated(const Metal<T, Law> &metal, const MaterialPoint<T> &old, const Mat3<T> &L, T dt) {
  return advanced(metal, old, L, dt).point;
}

/// Velocity gradients of the points `index_of(lane)` as one.
template <class T, class F> Mat3<Pack<T>> load_gradients(const MaterialPoints<T> &p, F &&index_of) {
  Mat3<Pack<T>> L;
  for (int k = 0; k < 9; ++k)
    L(k / 3, k % 3) = pack_of<T>([&](Index lane) { return p.velocity_gradient[index_of(lane)](k / 3, k % 3); });
  return L;
}

/// Keeps the flow stress at the smallest rate, `yield` (Pa), of a point that did not flow.
template <class T> void keep_yield(MaterialPoints<T> &p, Index i, T yield) {
  if (yield < T(0)) return;
  p.quasi_static_yield[i] = yield, p.yield_strain[i] = p.plastic_strain[i], p.yield_temperature[i] = p.temperature[i];
}

/// Moves those of the points `index` that stay elastic through a step, several at once, and calls `others(i)` for the
/// rest. Elastic are points that have not failed and whose trial stress lies below their known flow stress.
template <class Body, class T, class F>
[[gnu::flatten]] void update_elastic_points(Body &body, std::span<const Index> index, T dt, F &&others) {
  auto &p = body.points;
  const auto &metal = body.metal;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Index n = static_cast<Index>(index.size());
  for (Index first = 0; first < n; first += lanes<T>) {
    const auto index_of = [&](Index lane) { return index[std::min(first + lane, n - 1)]; };
    const auto of = [&](const std::vector<T> &field) {
      return pack_of<T>([&](Index lane) { return field[index_of(lane)]; });
    };
    const MaterialPoint<Pack<T>> old = load_points(p, index_of);
    auto trial = elastic_trial(metal, old, load_gradients(p, index_of), dt);
    balance(metal, old, trial.point, trial.deformation_rate, dt, -infinity, infinity);
    // Written so that a NaN is not taken for elastic.
    auto elastic = (trial.equivalent_stress <= of(p.quasi_static_yield)) & (old.plastic_strain <= of(p.yield_strain)) &
                   (old.plastic_strain >= of(p.yield_strain)) & (old.temperature <= of(p.yield_temperature)) &
                   (old.temperature >= of(p.yield_temperature));
    if (metal.damage.effect != FailureEffect::none) elastic = elastic & (old.damage < Pack<T>(T(1)));
    for (Index lane = 0; lane < std::min(lanes<T>, n - first); ++lane)
      if (elastic[lane])
        store(p, index_of(lane), lane_of(trial.point, lane));
      else
        others(index_of(lane));
  }
}

/// advanced() for several points at once that have not failed; not for damage by Cockcroft and Latham.
template <class Body, class T> [[gnu::flatten]] void update_points(Body &body, std::span<const Index> points, T dt) {
  auto &p = body.points;
  const auto &metal = body.metal;
  const Index n = static_cast<Index>(points.size());
  for (Index first = 0; first < n; first += lanes<T>) {
    const auto index_of = [&](Index lane) { return points[std::min(first + lane, n - 1)]; };
    std::optional<Pack<T>> neighbour_pressure;
    if (!p.neighbour_pressure.empty())
      neighbour_pressure = pack_of<T>([&](Index lane) { return p.neighbour_pressure[index_of(lane)]; });
    const MaterialPoint<Pack<T>> old = load_points(p, index_of);
    const auto trial = elastic_trial(metal, old, load_gradients(p, index_of), dt);
    const auto after = advanced_sound(metal, old, trial, dt, neighbour_pressure);
    for (Index lane = 0; lane < std::min(lanes<T>, n - first); ++lane) {
      MaterialPoint<T> now = lane_of(after.point, lane);
      if (is_failed(metal.damage, now.damage))
        lose_stress(metal, lane_of(old, lane), now, lane_of(trial.deformation_rate, lane), dt);
      store(p, points[first + lane], now);
      keep_yield(p, points[first + lane], after.yield[lane]);
    }
  }
}

/// Moves all material points of a body (it has `metal` and `points`) through a step; dt = 0 does not change them.
template <class Body, class T> void update_stress(Body &body, T dt) {
  if (dt == T(0)) return;
  constexpr Index chunk = 128;
  const bool packed =
      PackedFlowLaw<decltype(body.metal.flow), T> && body.metal.damage.law != DamageLaw::cockcroft_latham;
  parallel_for_chunks(body.points.size(), chunk, [&](Index begin, Index end) {
    std::array<Index, chunk> at_rest, several;
    std::size_t resting = 0, count = 0;
    const auto flow = [&](Index i) {
      if (packed && !is_failed(body.metal.damage, body.points.damage[i])) {
        several[count++] = i;
        return;
      }
      const auto &mean = body.points.neighbour_pressure;
      const auto after = advanced(body.metal, load(body.points, i), body.points.velocity_gradient[i], dt,
                                  mean.empty() ? std::nullopt : std::optional<T>(mean[i]));
      store(body.points, i, after.point);
      keep_yield(body.points, i, after.yield);
    };
    // The flow stress of a point that flowed in the last step is not known, nor is that of a band that cools.
    const auto &sheared = body.points.shear_strain;
    for (Index i = begin; i < end; ++i)
      if (body.points.plastic_strain_rate[i] > T(0) || (!sheared.empty() && sheared[i] >= body.metal.shear_band.onset))
        flow(i);
      else
        at_rest[resting++] = i;
    update_elastic_points(body, std::span<const Index>(at_rest.data(), resting), dt, flow);
    if constexpr (PackedFlowLaw<decltype(body.metal.flow), T>)
      update_points(body, std::span<const Index>(several.data(), count), dt);
  });
}

} // namespace ogive
