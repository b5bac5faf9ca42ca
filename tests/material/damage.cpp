// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/material/doubts.hpp"
#include "ogive/material/library.hpp"
#include "ogive/material/stress_update.hpp"

#include <array>
#include <cmath>
#include <random>

using namespace ogive;

namespace {

using Steel = Metal<double, ModifiedJohnsonCook<double>>;

/// Weldox 460 E that keeps its temperature, with damage that shows as `effect`.
Steel isothermal(DamageLaw law, FailureEffect effect = FailureEffect::none) {
  auto metal = library::weldox_460e_mjc<double>();
  metal.specific_heat = 0;
  metal.damage.law = law;
  metal.damage.effect = effect;
  return metal;
}

/// The velocity gradient of pure deviatoric stretching along x at the equivalent rate `rate` (1/s).
Mat3<double> stretching(double rate) {
  Mat3<double> L = Mat3<double>::Zero();
  L.diagonal() << rate, -0.5 * rate, -0.5 * rate;
  return L;
}

/// Stretches a point at the equivalent rate `rate`, by `strain`, in steps of `dt`, and swells it so that its
/// triaxiality is `triaxiality` after each step.
void stretch(const Steel &metal, MaterialPoint<double> &p, double triaxiality, double rate, double strain, double dt) {
  const double bulk = bulk_modulus(metal.elasticity);
  for (int i = 0; i < std::lround(strain / (rate * dt)); ++i) {
    Mat3<double> L = stretching(rate);
    // The density that the linear law answers with the pressure -triaxiality q, q of the step before.
    const double wanted = metal.density * (1 - triaxiality * von_mises(p.deviator) / bulk);
    L.diagonal().array() += std::log(p.density / wanted) / (3 * dt);
    p = updated(metal, p, L, dt);
  }
}

Sym3<double> turned(const Vec3<double> &principal, std::mt19937 &random) {
  std::uniform_real_distribution<double> angle(0.0, 6.0);
  Mat3<double> Q = Mat3<double>::Identity();
  for (const auto &[i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    Mat3<double> R = Mat3<double>::Identity();
    const double a = angle(random);
    R(i, i) = R(j, j) = std::cos(a), R(i, j) = -std::sin(a), R(j, i) = std::sin(a);
    Q = Q * R;
  }
  return rotated<double>({principal[0], principal[1], principal[2], 0, 0, 0}, Q);
}

} // namespace

TEST_CASE("the largest principal stress is found in any direction", "[material]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(-1e9, 1e9);
  for (int i = 0; i < 200; ++i) {
    Vec3<double> principal(size(random), size(random), size(random));
    if (i % 4 == 0) principal[1] = principal[0]; // uniaxial tension or compression on top of a pressure
    const Sym3<double> s = turned(principal, random);
    // The angle of two equal principal values is only known to the square root of round-off: 1e-8, and its cosine is
    // flat or has slope 1 there.
    CHECK(largest_principal_stress(deviator(s), -trace(s) / 3) == Approx(principal.maxCoeff()).margin(40));
  }
  CHECK(largest_principal_stress(Sym3<double>{}, 3e6) == -3e6);
}

TEST_CASE("at constant triaxiality, rate and temperature a point fails at the strain of Eq. 4", "[material]") {
  auto metal = isothermal(DamageLaw::johnson_cook, FailureEffect::no_tension);
  // Constants that make every factor of Eq. 4 count.
  metal.damage.failure_strain = {0.05, 0.6, -1.5, -0.03, 1.2, 1.0};
  const double triaxiality = GENERATE(-0.5, 0.0, 1.0 / 3.0, 1.5), rate = GENERATE(1e2, 1e4);
  const double temperature = GENERATE(293.0, 1046.5);
  auto p = initial_point(metal);
  p.temperature = temperature;
  const double dt = 1e-4 / rate;
  // By hand: [0.05 + 0.6 exp(-1.5 eta)] rate^-0.03 [1 + 1.2 T*], with T* = 0 and 0.5.
  const double expected =
      (0.05 + 0.6 * std::exp(-1.5 * triaxiality)) * std::pow(rate, -0.03) * (temperature == 293 ? 1.0 : 1 + 1.2 * 0.5);
  while (p.damage < 1) stretch(metal, p, triaxiality, rate, 1e-4, dt);
  // One step is 1e-4. The elastic strain (0.004) comes first, at the rate but without triaxiality; while hardening, the
  // plastic rate lags the total one by up to slope/3G, a tenth right at yield: 0.3 % of a rate^-0.03.
  CHECK(p.plastic_strain == Approx(expected).epsilon(4e-3).margin(2e-4));
  CHECK(von_mises(p.deviator) == 0.0);
}

TEST_CASE("Cockcroft-Latham damage is the work of the largest principal stress", "[material]") {
  auto metal = isothermal(DamageLaw::cockcroft_latham);
  metal.flow.B = 0;
  metal.flow.C = 0;
  metal.damage.critical_work = 800e6;
  const double q = metal.flow.A;
  auto p = initial_point(metal);
  SECTION("stretching at a triaxiality: sigma_1 = (eta + 2/3) q") {
    const double eta = GENERATE(-0.5, 0.0, 1.0 / 3.0, 1.0);
    stretch(metal, p, eta, 1e3, 0.4, 1e-7);
    // The triaxiality is that of the step before: 1e-4 of the strain; the first steps are elastic.
    CHECK(p.damage == Approx((eta + 2.0 / 3.0) * q * p.plastic_strain / 800e6).epsilon(1e-3));
  }
  SECTION("simple shear: sigma_1 = q/sqrt(3)") {
    Mat3<double> L = Mat3<double>::Zero();
    L(0, 1) = 1e4 * std::sqrt(3.0);
    for (int i = 0; i < 3000; ++i) p = updated(metal, p, L, 1e-8);
    // Second-order terms of the step's rotation leave a pressure of 1e-4 q.
    CHECK(p.damage == Approx(q / std::sqrt(3.0) * p.plastic_strain / 800e6).epsilon(1e-3));
  }
  SECTION("compression does no damage") {
    stretch(metal, p, -1.0, 1e3, 0.4, 1e-7); // sigma_1 = -q/3
    CHECK(p.plastic_strain > 0.39);
    // Only the first steps, before the pressure has followed the stress: 1e-3 of the strain.
    CHECK(p.damage < 1e-3);
  }
}

TEST_CASE("on a path through different triaxialities the parts of the failure strains add up", "[material]") {
  const auto metal = isothermal(DamageLaw::johnson_cook);
  const auto &f = metal.damage.failure_strain;
  const double rate = 1e3;
  auto p = initial_point(metal);
  double expected = 0, before = 0;
  // A neck: smooth tension, then a notch that gets sharper, then unloading into shear.
  for (const auto &[triaxiality, strain] :
       std::array<std::array<double, 2>, 4>{{{1.0 / 3.0, 0.15}, {0.8, 0.1}, {1.4, 0.05}, {0.0, 0.2}}}) {
    stretch(metal, p, triaxiality, rate, strain, 1e-7);
    expected += (p.plastic_strain - before) / failure_strain(f, triaxiality, rate, 0.0);
    before = p.plastic_strain;
  }
  // The rate within a percent while the flow stress follows a new pressure; rate^-0.0123.
  CHECK(p.damage == Approx(expected).epsilon(1e-3));
}

TEST_CASE("damage never falls", "[material]") {
  const auto law = GENERATE(DamageLaw::johnson_cook, DamageLaw::cockcroft_latham);
  const auto effect = GENERATE(FailureEffect::none, FailureEffect::no_tension, FailureEffect::removal);
  auto metal = library::aa5083_h116_mjc<double>();
  metal.damage.law = law;
  metal.damage.effect = effect;
  std::mt19937 random(3);
  std::normal_distribution<double> rate(0.0, 3e4);
  auto p = initial_point(metal);
  int failures = 0;
  for (int i = 0; i < 4000; ++i) {
    Mat3<double> L;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) L(r, c) = rate(random);
    L.diagonal().array() -= L.trace() / 3 + 1e8 * std::log(metal.density / p.density) / 30; // keeps its volume
    const auto next = updated(metal, p, L, 1e-7);
    if (!(next.damage >= p.damage)) ++failures;
    p = next;
  }
  CHECK(failures == 0);
  CHECK(p.damage > 1);
}

TEST_CASE("a failed point bears pressure only, a removed one nothing", "[material]") {
  const auto effect = GENERATE(FailureEffect::no_tension, FailureEffect::removal);
  auto metal = isothermal(DamageLaw::johnson_cook, effect);
  metal.damage.failure_strain = {0.1, 0, 0, 0, 0, 1};
  auto p = initial_point(metal), before = p;
  const double dt = 1e-8, rate = 1e4;
  const Mat3<double> L = stretching(rate) + 0.02 * rate * Mat3<double>::Identity();
  while (p.damage < 1) before = p, p = updated(metal, p, L, dt);
  CHECK(before.pressure < 0);
  CHECK(von_mises(p.deviator) == 0.0);
  CHECK(p.pressure == 0.0);
  // Trapezoidal rule: half a step's work of the stress it had, then none. The rate at the middle of the step differs by
  // 1e-4 of itself.
  const auto D = symmetric_part<double>(L);
  const double half_work = 0.5 * dt * (double_dot(before.deviator, D) - before.pressure * trace(D)) / before.density;
  CHECK(p.internal_energy - before.internal_energy == Approx(half_work).epsilon(1e-3));

  auto opened = p;
  for (int i = 0; i < 1000; ++i) opened = updated(metal, opened, L, dt);
  CHECK(opened.pressure == 0.0);
  CHECK(opened.plastic_strain == p.plastic_strain);
  CHECK(opened.internal_energy == p.internal_energy);

  for (int i = 0; i < 4000; ++i) p = updated(metal, p, Mat3<double>(-rate * Mat3<double>::Identity()), dt);
  CHECK(von_mises(p.deviator) == 0.0);
  if (effect == FailureEffect::removal) {
    CHECK(p.pressure == 0.0);
  } else {
    CHECK(p.density > metal.density);
    CHECK(p.pressure == Approx(bulk_modulus(metal.elasticity) * (p.density / metal.density - 1)));
    CHECK(p.internal_energy > opened.internal_energy);
  }
}

TEST_CASE("without effect, damage changes nothing but itself", "[material]") {
  const auto sound = isothermal(DamageLaw::none), counted = isothermal(DamageLaw::johnson_cook);
  auto a = initial_point(sound), b = initial_point(counted);
  const Mat3<double> L = stretching(1e4) + 300 * Mat3<double>::Identity();
  for (int i = 0; i < 20000; ++i) a = updated(sound, a, L, 1e-8), b = updated(counted, b, L, 1e-8);
  CHECK(b.damage > 1);
  CHECK(a.damage == 0.0);
  CHECK(a.pressure == b.pressure);
  CHECK(a.deviator.xx == b.deviator.xx);
  CHECK(a.internal_energy == b.internal_energy);
}

TEST_CASE("the critical work of slow tension fails a bar at the strain of Eq. 4", "[material]") {
  auto metal = isothermal(DamageLaw::cockcroft_latham);
  metal.damage.failure_strain = {0.1, 0.4, -0.5, -0.01, 0, 1};
  metal.damage.critical_work = critical_work_of_tension(metal);
  const double expected = 0.1 + 0.4 * std::exp(-0.5 / 3);
  // In closed form at 1/s: A e + B e^(a+1)/(a+1).
  const auto &law = metal.flow;
  CHECK(metal.damage.critical_work ==
        Approx(law.A * expected + law.B * std::pow(expected, law.a + 1) / (law.a + 1)).epsilon(1e-6));
  auto p = initial_point(metal);
  while (p.damage < 1) stretch(metal, p, 1.0 / 3.0, 1.0, 1e-4, 1e-4);
  // sigma_1 = q in smooth tension; the elastic strain comes before the triaxiality.
  CHECK(p.plastic_strain == Approx(expected).epsilon(2e-3));
}

TEST_CASE("damage with impossible constants is refused by name", "[material]") {
  auto metal = library::weldox_460e_mjc<double>();
  metal.damage.law = DamageLaw::cockcroft_latham;
  metal.damage.critical_work = 0;
  CHECK_THROWS_WITH(check(metal), Catch::Contains("weldox_460e critical work") && Catch::Contains("must be positive"));
  metal.damage.law = DamageLaw::johnson_cook;
  check(metal);
  metal.damage.failure_strain.D3 = std::nan("");
  CHECK_THROWS_WITH(check(metal), Catch::Contains("weldox_460e D3"));
  metal.damage.failure_strain = {};
  CHECK_THROWS_WITH(check(metal), Catch::Contains("weldox_460e D1 and D2"));
  metal.damage.failure_strain = {1, 0, 0, 0, 0, 0};
  CHECK_THROWS_WITH(check(metal), Catch::Contains("reference rate"));
}

TEST_CASE("damage softens the flow stress", "[material]") {
  Steel metal = isothermal(DamageLaw::johnson_cook, FailureEffect::no_tension);
  metal.damage.softening = 0.3;
  MaterialPoint<double> p = initial_point(metal);
  p.plastic_strain = 0.2, p.damage = 0.5;
  const double sound = flow_stress(metal, 0.2, metal.rate_floor, 293.0).value;
  const double q = 2 * sound, dt = 1.0;
  // So slow that the rate stays at its floor; the increment is then that of the hardening alone.
  const auto plastic = radial_return(metal, p, q, dt);
  const double hardened = flow_stress(metal, 0.2 + plastic.increment, metal.rate_floor, 293.0).value;
  CHECK(plastic.flow_stress == Approx((1 - 0.3 * 0.5) * hardened).epsilon(1e-7));
  p.damage = 7;
  CHECK(radial_return(metal, p, 0.5 * sound, dt).flow_stress == Approx(0.7 * sound).epsilon(1e-12)); // D counts to 1
}

TEST_CASE("damage follows the pressure of the neighbours where a point has one", "[material]") {
  auto metal = isothermal(DamageLaw::johnson_cook);
  metal.damage.failure_strain = {0, 1, -1.5, 0, 0, 1.0};
  MaterialPoint<double> sheared = initial_point(metal);
  sheared.deviator.xy = 4e8; // q = sqrt(3) 4e8 Pa, beyond the flow stress with what the step adds
  const double pressure = -6e8, dt = 1e-8;
  const Mat3<double> L = stretching(1e4);
  const MaterialPoint<double> alone = advanced(metal, sheared, L, dt).point,
                              among = advanced(metal, sheared, L, dt, std::optional(pressure)).point;
  REQUIRE(alone.plastic_strain > 0);
  CHECK(among.pressure == alone.pressure); // of its stress nothing changes
  CHECK(among.plastic_strain == alone.plastic_strain);
  CHECK(among.damage ==
        Approx(among.plastic_strain / std::exp(-1.5 * -pressure / von_mises(among.deviator))).epsilon(1e-12));
  CHECK(alone.damage < 0.5 * among.damage);
}

TEST_CASE("the failure strain has both published terms of the rate, with a floor at the reference rate", "[material]") {
  FailureStrain<double> f{0.1, 0.4, -1.5, 0.05, 0.5, 0.01};
  const double slow = 0.1 + 0.4 * std::exp(-0.5); // triaxiality 1/3
  CHECK(failure_strain(f, 1.0 / 3, 1e3, 0.0) == Approx(slow * std::pow(1e5, 0.05)));
  CHECK(failure_strain(f, 1.0 / 3, 1e3, 0.2) == Approx(slow * std::pow(1e5, 0.05) * 1.1));
  CHECK(failure_strain(f, 1.0 / 3, 1e-4, 0.0) == Approx(slow));
  f.rate_term = FailureRateTerm::logarithmic;
  CHECK(failure_strain(f, 1.0 / 3, 1e3, 0.0) == Approx(slow * (1 + 0.05 * std::log(1e5))));
  CHECK(failure_strain(f, 1.0 / 3, 1e-4, 0.0) == Approx(slow));
  f.D4 = -0.2; // 1 - 0.2 ln(1e5) is below zero
  CHECK(failure_strain(f, 1.0 / 3, 1e3, 0.0) == 1e-6);
}

TEST_CASE("constants of damage that make no sense are doubtful, those of the library are not", "[material]") {
  const auto doubts = [](double D1, double D2, double D3, double D4, double D5, double rate = 1) {
    return doubts_of(FailureStrain<double>{D1, D2, D3, D4, D5, rate});
  };
  for (const auto &metal : {library::weldox_460e_mjc<double>(), library::aa5083_h116_mjc<double>()})
    CHECK(doubts_of(metal.damage.failure_strain).empty());
  // 6061-T6 as published: -0.77 + 1.45 exp(-0.47 s) is zero at s = ln(1.45/0.77)/0.47 = 1.347.
  const auto negative = doubts(-0.77, 1.45, -0.47, 0, 1.6);
  REQUIRE(negative.size() == 1);
  CHECK_THAT(negative[0], Catch::Contains("below zero from triaxiality 1.35 on (D1 = -0.77, D2 = 1.45, D3 = -0.47)"));
  // The sign of a code whose pressure is positive in compression.
  const auto rising = doubts(0.03, 0.5, 0.952, 0, 0);
  REQUIRE(rising.size() == 1);
  CHECK_THAT(rising[0], Catch::Contains("rises with tension, from 0.53 at triaxiality 0 to 3.39 at 2 (D3 = 0.952)"));
  CHECK(doubts(0.5, 0, 0.952, 0, 0).empty()); // D3 has no effect
  CHECK(doubts(0.5, 0.2, -2, 0, -1.5).size() == 1);
  CHECK(doubts(0.5, 0.2, -2, 0.4, 0).size() == 1); // 10^(4*0.4) = 40 times
  // -0.5 + 0.2 exp(-2 s) is zero at s = -ln(2.5)/2 = -0.458; with D3 of the other sign at 0.458.
  CHECK_THAT(doubts(-0.5, 0.2, -2, 0, 0).at(0), Catch::Contains("below zero from triaxiality -0.45 on"));
  const auto both = doubts(-0.5, 0.2, 2, 0, 0);
  REQUIRE(both.size() == 2);
  CHECK_THAT(both[1], Catch::Contains("below zero from triaxiality -1 to 0.45 (D1 = -0.5"));
  // Zero at 2.2, beyond what a shot reaches: -0.1 + 0.25 exp(-0.4165 s).
  CHECK(doubts(-0.1, 0.25, -0.4165, 0, 0).empty());
  CHECK_THAT(doubts(0.5, 0.2, -2, 0.01, 0, 1000).at(0),
             Catch::Contains("no effect on the failure strain below its ref"));
}

TEST_CASE("flow stresses and temperatures that make no sense are doubtful, those of the library are not",
          "[material]") {
  CHECK(doubts_of_flow(library::weldox_460e_mjc<double>()).empty());
  CHECK(doubts_of_flow(library::weldox_460e_jc<double>()).empty());
  CHECK(doubts_of_flow(library::aa5083_h116_mjc<double>()).empty());
  CHECK(doubts_of_flow(library::aa5083_h116_jc<double>()).empty());

  auto metal = library::aa5083_h116_jc<double>();
  const auto only = [&](const std::string &part) {
    const auto doubts = doubts_of_flow(metal);
    REQUIRE(doubts.size() == 1);
    CHECK_THAT(doubts[0], Catch::Contains(part));
  };
  metal.flow.C = -0.01;
  // (1 + 1e4)^-0.01 over (1 + 1)^-0.01, the slow rate being the rate floor of 1/s: 0.918.
  only("falls with the rate, to 0.918 of its slow value");
  metal.flow = {167e6, 596e6, 0.551, 0.01, 0.859, 3e3, RateFactor::logarithmic};
  only("no effect on the flow stress up to 100 1/s");
  metal.flow = {167e6, 596e6, 0.551, 0.001, 0.859, 1, RateFactor::power};
  metal.melting_temperature = 430; // of 620 degrees Celsius a part
  only("its own heat melts it at a plastic strain of 0.7");

  const auto falling = library::aa5083_h116<double>(Voce<double>{200e6, 100e6, 20, -80e6, 2, {.C = 0, .m = 1}}, "");
  const auto doubts = doubts_of_flow(falling);
  REQUIRE(doubts.size() == 1);
  // 100 20 e^-20e = 80 2 e^-2e at e = ln(12.5)/18 = 0.140, where the stress is 274.5 MPa; 200 + 100 - 80 (1 - e^-4)
  // at 2.
  CHECK_THAT(doubts[0], Catch::Contains("falls beyond a plastic strain of 0.14, from 274 to 221 MPa at 2"));
}
