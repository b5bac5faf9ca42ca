// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/stress_update.hpp"

#include <cmath>

namespace verification {

namespace {

using namespace ogive;
using M = Mat3<double>;

constexpr double rate = 1e3; ///< 1/s

/// The two factors of a flow law that do not depend on temperature, and the thermal exponent.
struct Factors {
  double A, B, n, rate_factor, exponent;
};

Factors factors(const ModifiedJohnsonCook<double> &law) { return {law.A, law.B, law.a, std::pow(rate, law.C), law.b}; }

Factors factors(const JohnsonCook<double> &law) {
  const double scaled = rate / law.reference_rate;
  const bool power = law.rate_factor == RateFactor::power;
  return {law.A, law.B, law.n, power ? std::pow(1 + scaled, law.C) : 1 + law.C * std::log(scaled), law.m};
}

Factors factors(const Bilinear<double> &law) { return {law.yield, law.hardening, 1, 1, 1}; }

/// T* after the specific work w = W/(rho c_p (Tm - Tr)) that hardening and rate factor alone would do: the solution of
/// w = integral of dT*/(1 - T*^b) = sum over k of T*^(k b + 1)/(k b + 1).
double homologous_after(double w, double b) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    double sum = 0;
    for (int k = 0; k < 400; ++k) sum += std::pow(t, k * b + 1) / (k * b + 1);
    (sum < w ? low : high) = t;
  }
  return 0.5 * (low + high);
}

/// A state of the closed form.
struct State {
  double plastic_strain, stress, heating; ///< -, Pa, K
};

/// The closed form at the total strain `strain`, with the modulus (Pa) that takes stress to elastic strain.
template <class Law> State closed_form(const Metal<double, Law> &metal, double strain, double modulus) {
  const Factors f = factors(metal.flow);
  const bool heats = metal.specific_heat > 0 && !std::is_same_v<Law, Bilinear<double>>;
  const double span = metal.melting_temperature - metal.room_temperature;
  const auto at = [&](double e) {
    const double work = metal.taylor_quinney * f.rate_factor * (f.A * e + f.B * std::pow(e, f.n + 1) / (f.n + 1));
    const double t = heats ? homologous_after(work / (metal.density * metal.specific_heat * span), f.exponent) : 0;
    const double hardening = f.A + f.B * std::pow(e, f.n);
    return State{e, hardening * f.rate_factor * (heats ? 1 - std::pow(t, f.exponent) : 1), t * span};
  };
  double low = 0, high = strain;
  for (int i = 0; i < 60; ++i) {
    const double e = 0.5 * (low + high);
    (e + at(e).stress / modulus < strain ? low : high) = e;
  }
  State state = at(0.5 * (low + high));
  if (!heats && metal.specific_heat > 0)
    state.heating = metal.taylor_quinney * (f.A * low + 0.5 * f.B * low * low) / (metal.density * metal.specific_heat);
  return state;
}

M diagonal(double axial, double lateral) {
  M L = M::Zero();
  L.diagonal() << axial, lateral, lateral;
  return L;
}

/// The gradient at the end of a step of a constant rate, so that the midstep gradient is that rate.
double at_end(double rate_of_strain, double dt) { return rate_of_strain / (1 + 0.5 * dt * rate_of_strain); }

/// Pulls a point along x at a constant rate, without lateral stress, to the logarithmic strain `strain`.
template <class Law> MaterialPoint<double> pulled(const Metal<double, Law> &metal, double strain, int steps) {
  const double dt = strain / rate / steps;
  auto p = initial_point(metal);
  double lateral = -metal.elasticity.poisson * rate;
  for (int i = 0; i < steps; ++i) {
    const auto stress_for = [&](double l) {
      const auto q = updated(metal, p, diagonal(at_end(rate, dt), at_end(l, dt)), dt);
      return q.deviator.yy - q.pressure;
    };
    double other = 1.01 * lateral, stress = stress_for(lateral);
    for (int k = 0; k < 30 && std::abs(stress) > 1; ++k) {
      const double slope = (stress_for(other) - stress) / (other - lateral);
      other = std::exchange(lateral, lateral - stress / slope);
      stress = stress_for(lateral);
      if (other == lateral) break;
    }
    p = updated(metal, p, diagonal(at_end(rate, dt), at_end(lateral, dt)), dt);
  }
  return p;
}

/// Stretches a point along x and shortens it across, without change of volume, to the strain `strain`.
template <class Law> MaterialPoint<double> stretched(const Metal<double, Law> &metal, double strain, int steps) {
  const double dt = strain / rate / steps;
  auto p = initial_point(metal);
  for (int i = 0; i < steps; ++i) p = updated(metal, p, diagonal(at_end(rate, dt), at_end(-0.5 * rate, dt)), dt);
  return p;
}

/// Shears a point to the equivalent strain `strain`.
template <class Law> MaterialPoint<double> sheared(const Metal<double, Law> &metal, double strain, int steps) {
  const double dt = strain / rate / steps;
  auto p = initial_point(metal);
  M L = M::Zero();
  L(0, 1) = rate * std::sqrt(3.0);
  for (int i = 0; i < steps; ++i) p = updated(metal, p, L, dt);
  return p;
}

/// Damage by Eq. 4 in shear to the equivalent strain `strain`: the sum over plastic strain and heat of the closed form.
template <class Law> double damage_in_shear(const Metal<double, Law> &metal, double strain) {
  const auto &f = metal.damage.failure_strain;
  const double cold = (f.D1 + f.D2) * std::pow(rate / f.reference_rate, f.D4);
  const double span = metal.melting_temperature - metal.room_temperature;
  constexpr int parts = 300;
  double damage = 0;
  State before{};
  for (int k = 1; k <= parts; ++k) {
    const State now = closed_form(metal, strain * k / parts, 3 * shear_modulus(metal.elasticity));
    const double homologous = 0.5 * (before.heating + now.heating) / span;
    damage += (now.plastic_strain - before.plastic_strain) / (cold * (1 + f.D5 * homologous));
    before = now;
  }
  return damage;
}

/// Equivalent stress and heating in tension and shear; the closed form takes the plastic rate for the total one.
template <class Law> void add_law(Rung &rung, const std::string &name, const Metal<double, Law> &metal) {
  constexpr double strain = 0.3;
  constexpr int steps = 3000;
  const auto add = [&](const std::string &path, const MaterialPoint<double> &p, const State &theory) {
    compare(rung, name + ", " + path + ": stress, MPa", theory.stress * 1e-6, von_mises(p.deviator) * 1e-6, 1e-3);
    compare(rung, name + ", " + path + ": heating, K", theory.heating, p.temperature - metal.room_temperature, 1e-3);
  };
  const double three_g = 3 * shear_modulus(metal.elasticity);
  add("tension", pulled(metal, strain, steps), closed_form(metal, strain, metal.elasticity.young));
  add("shear", sheared(metal, strain, steps), closed_form(metal, strain, three_g));
}

} // namespace

Rung one_point() {
  Rung rung;
  rung.name = "one_point";
  add_law(rung, "modified Johnson–Cook", library::weldox_460e_mjc<double>());
  add_law(rung, "Johnson–Cook, power", library::weldox_460e_jc<double>());
  auto logarithmic = library::weldox_460e_jc<double>();
  logarithmic.flow.rate_factor = RateFactor::logarithmic;
  add_law(rung, "Johnson–Cook, logarithm", logarithmic);
  add_law(rung, "bilinear", library::arne_tool_steel<double>());

  // Without rate sensitivity the closed form is exact in stretching.
  auto metal = library::weldox_460e_mjc<double>();
  metal.flow.C = 0;
  const State exact = closed_form(metal, 0.3, 3 * shear_modulus(metal.elasticity));
  std::vector<double> stress, heating;
  for (const int steps : {50, 100, 200}) {
    const auto p = stretched(metal, 0.3, steps);
    stress.push_back(von_mises(p.deviator) - exact.stress);
    heating.push_back(p.temperature - metal.room_temperature - exact.heating);
  }
  converges(rung, "stretching in 50, 100, 200 steps: heating, order", 1, heating, 0.9);
  converges(rung, "stretching in 50, 100, 200 steps: stress, order", 1, stress, 0.9);
  auto cold = metal;
  cold.specific_heat = 0;
  const State isothermal = closed_form(cold, 0.3, 3 * shear_modulus(cold.elasticity));
  compare(rung, "the same at constant temperature, 50 steps: stress, MPa", isothermal.stress * 1e-6,
          von_mises(stretched(cold, 0.3, 50).deviator) * 1e-6, 1e-8);

  auto damaged = library::weldox_460e_mjc<double>();
  damaged.damage.law = DamageLaw::johnson_cook;
  compare(rung, "damage by Eq. 4 in shear", damage_in_shear(damaged, 0.3), sheared(damaged, 0.3, 3000).damage, 2e-3);

  const double K = bulk_modulus(metal.elasticity), c0 = std::sqrt(K / metal.density);
  for (const double up : {100.0, 500.0}) {
    const double us = c0 + metal.eos.hugoniot_slope * up, eta = up / us;
    auto eos = metal.eos;
    eos.law = PressureLaw::mie_gruneisen;
    compare(rung, "Mie–Grüneisen on the Hugoniot, u_p = " + number(up) + " m/s: pressure, GPa",
            metal.density * us * up * 1e-9, pressure(eos, K, eta / (1 - eta), 0.5 * metal.density * up * up) * 1e-9,
            1e-12);
  }
  return rung;
}

} // namespace verification
