// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/stress_update.hpp"

#include <cmath>
#include <optional>
#include <random>

using namespace ogive;

namespace {

/// A law that only takes single numbers, as a user may write it.
struct Plain {
  double yield = 4e8;
};
FlowStress<double> flow_stress(const Plain &law, double plastic_strain, double rate, double) {
  return {(law.yield + 5e8 * plastic_strain) * (1 + 0.01 * std::log(rate)), 5e8 * (1 + 0.01 * std::log(rate)),
          (law.yield + 5e8 * plastic_strain) * 0.01 / rate, 0.0};
}

template <class Law> struct Body {
  Metal<double, Law> metal;
  MaterialPoints<double> points;
};

/// Points in all states, with rates from elastic to fast flow, none of them a multiple of a pack in number. If the
/// metal's damage grows, some are near failure and some have failed.
template <class Law> Body<Law> some_points(const Metal<double, Law> &metal) {
  Body<Law> body{metal, {}};
  constexpr Index count = 301;
  fill(body.points, count, initial_point(metal));
  if (has_bands(metal.shear_band)) body.points.shear_strain.assign(count, 0), body.points.band_age.assign(count, 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  for (Index i = 0; i < count; ++i) {
    auto p = load(body.points, i);
    const double stress = 2e8 * (1 + u(random));
    p.deviator = deviator(Sym3<double>{stress * u(random), stress * u(random), stress * u(random), stress * u(random),
                                       stress * u(random), stress * u(random)});
    p.density *= 1 + 1e-3 * u(random);
    p.pressure = bulk_modulus(metal.elasticity) * (p.density / metal.density - 1);
    if (i % 3 != 0) p.plastic_strain = 0.5 * (1 + u(random)), p.temperature += 400 * (1 + u(random));
    p.shear_strain = p.plastic_strain;
    if (p.shear_strain > metal.shear_band.onset && i % 4 != 0) p.band_age = 3e-5 * (1 + u(random));
    if (i % 5 == 0) p.plastic_strain_rate = 1e5 * (1 + u(random));
    if (metal.damage.law != DamageLaw::none) p.damage = 0.55 * (1 + u(random));
    store(body.points, i, p);
    const double size = std::pow(10.0, 4.5 + 1.5 * u(random));
    for (int k = 0; k < 9; ++k) body.points.velocity_gradient[i](k / 3, k % 3) = size * u(random);
  }
  return body;
}

/// Several points at once and one by one, ten steps.
template <class Law> void check_same(const Metal<double, Law> &metal, double neighbour_pressure = 0) {
  auto body = some_points(metal);
  if (neighbour_pressure != 0)
    for (Index i = 0; i < body.points.size(); ++i)
      body.points.neighbour_pressure.push_back(neighbour_pressure * std::sin(i));
  auto points = body.points;
  const double dt = 4e-8;
  Index flowed = 0, failed = 0;
  for (int step = 0; step < 10; ++step) {
    update_stress(body, dt);
    for (Index i = 0; i < points.size(); ++i) {
      const auto seen = neighbour_pressure != 0 ? std::optional(points.neighbour_pressure[i]) : std::nullopt;
      const auto after = advanced(metal, load(points, i), points.velocity_gradient[i], dt, seen).point;
      flowed += after.plastic_strain_rate > 0 ? 1 : 0;
      failed += is_failed(metal.damage, after.damage) && !is_failed(metal.damage, points.damage[i]) ? 1 : 0;
      store(points, i, after);
      const auto found = load(body.points, i);
      // Newton's steps end at 1e-9 of the trial stress, from powers that differ by a few units in the last place; ten
      // steps add up. Temperatures follow the flow.
      REQUIRE(von_mises(found.deviator - after.deviator) < 1e-7 * (1e8 + von_mises(after.deviator)));
      REQUIRE(found.plastic_strain == Approx(after.plastic_strain).epsilon(1e-6).margin(1e-10));
      REQUIRE(found.temperature == Approx(after.temperature).epsilon(1e-8));
      REQUIRE(found.pressure == Approx(after.pressure).epsilon(1e-8).margin(1.0));
      REQUIRE(found.internal_energy ==
              Approx(after.internal_energy).epsilon(1e-6).margin(1e-5)); // of 1e3 J/kg and more
      REQUIRE(found.damage == Approx(after.damage).epsilon(1e-6));
      REQUIRE(found.shear_strain == Approx(after.shear_strain).epsilon(1e-6).margin(1e-10));
      REQUIRE(found.band_age == Approx(after.band_age).epsilon(1e-12));
    }
  }
  CHECK(flowed > 300);
  CHECK(flowed < 10 * points.size());
  CHECK((failed > 5) == (metal.damage.effect != FailureEffect::none));
}

} // namespace

TEST_CASE("several points at once do what they do one by one", "[material]") {
  check_same(library::weldox_460e_mjc<double>());
  check_same(library::weldox_460e_jc<double>());
  check_same(library::arne_tool_steel<double>());
  auto logarithmic = library::aa5083_h116_jc<double>();
  logarithmic.flow.rate_factor = RateFactor::logarithmic;
  logarithmic.eos.law = PressureLaw::mie_gruneisen;
  check_same(logarithmic);
  check_same(library::aa5083_h116<double>(Voce<double>{167e6, 100e6, 20, 90e6, 3, {.C = 0.01, .m = 0.9}}, ""));
  check_same(library::aa5083_h116<double>(PowerLaw<double>{276e6, 70e9, 0.1, {.C = -0.01, .m = 0.9}}, ""));
  auto damaged = library::aa5083_h116_mjc<double>();
  damaged.damage.law = DamageLaw::johnson_cook;
  damaged.damage.softening = 0.6;
  for (const auto effect : {FailureEffect::none, FailureEffect::no_tension, FailureEffect::removal}) {
    damaged.damage.effect = effect;
    check_same(damaged);
  }
  damaged.damage.failure_strain.rate_term = FailureRateTerm::logarithmic;
  damaged.shear_band = {0.5, 0.3, 0.6e-3, 5e-5};
  check_same(damaged, 8e8);
  damaged.damage.law = DamageLaw::cockcroft_latham;
  damaged.damage.critical_work = 3e8;
  check_same(damaged);
}

TEST_CASE("a law of single numbers works too, point by point", "[material]") {
  static_assert(PackedFlowLaw<ModifiedJohnsonCook<double>, double>);
  static_assert(!PackedFlowLaw<Plain, double>);
  Metal<double, Plain> metal;
  metal.name = "plain";
  metal.density = 7850;
  metal.elasticity = {200e9, 0.3};
  metal.specific_heat = 450;
  check_same(metal);
}

TEST_CASE("a change of strain or temperature from outside is seen", "[material]") {
  // The flow stress that a point is known to have must not outlive its state.
  auto body = some_points(library::weldox_460e_mjc<double>());
  for (auto &L : body.points.velocity_gradient) L *= 1e-3;
  update_stress(body, 1e-9);
  for (auto &t : body.points.temperature) t = 1790; // almost no strength is left
  update_stress(body, 1e-9);
  for (Index i = 0; i < body.points.size(); ++i)
    REQUIRE(von_mises(body.points.deviator[i]) < 1.01 * flow_stress(body.metal, body.points.plastic_strain[i],
                                                                    std::max(1.0, body.points.plastic_strain_rate[i]),
                                                                    1790.0)
                                                            .value);
}

TEST_CASE("a point that is not a number stays one and harms no other", "[material]") {
  const auto metal = library::weldox_460e_mjc<double>();
  auto body = some_points(metal), clean = body;
  body.points.deviator[9].xy = std::nan("");
  update_stress(body, 4e-8);
  update_stress(clean, 4e-8);
  CHECK(std::isnan(von_mises(body.points.deviator[9])));
  for (const Index i : {0, 8, 10, 300}) CHECK(body.points.plastic_strain[i] == clean.points.plastic_strain[i]);
}
