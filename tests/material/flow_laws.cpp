// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/stress_update.hpp"

#include <cmath>

using namespace ogive;

namespace {

Mat3<double> uniaxial_rate(double axial, double lateral) {
  Mat3<double> L = Mat3<double>::Zero();
  L.diagonal() << axial, lateral, lateral;
  return L;
}

/// AA5083-H116 with another flow law.
template <class Law> Metal<double, Law> with_flow(const Law &flow) { return library::aa5083_h116<double>(flow, ""); }

/// Central difference of the flow stress in one argument.
template <class F> double slope(F &&f, double x, double dx) { return (f(x + dx) - f(x - dx)) / (2 * dx); }

template <class Law> void check_derivatives(const Metal<double, Law> &metal) {
  const double e = 0.2, r = 1e4, t = 600;
  const auto at = flow_stress(metal, e, r, t);
  // Central differences are good to the square of their step, about 1e-8 relative here.
  CHECK(at.by_plastic_strain ==
        Approx(slope([&](double x) { return flow_stress(metal, x, r, t).value; }, e, 1e-5)).epsilon(1e-6).margin(1));
  CHECK(at.by_rate ==
        Approx(slope([&](double x) { return flow_stress(metal, e, x, t).value; }, r, 1.0)).epsilon(1e-6).margin(1e-6));
  CHECK(at.by_temperature ==
        Approx(slope([&](double x) { return flow_stress(metal, e, r, x).value; }, t, 0.01)).epsilon(1e-6).margin(1e-3));
}

} // namespace

TEST_CASE("modified Johnson-Cook gives Eq. 2 by hand", "[material]") {
  const auto m = library::weldox_460e_mjc<double>();
  // (503 + 581 * 0.1^0.481) MPa * 1000^0.01 * (1 - 0.5^0.94), T* = 0.5 at 1046.5 K: each factor from a hand calculator,
  // six digits.
  CHECK(flow_stress(m, 0.1, 1.0, 293.0).value == Approx(694.944e6).epsilon(2e-5));
  CHECK(flow_stress(m, 0.1, 1000.0, 293.0).value / flow_stress(m, 0.1, 1.0, 293.0).value ==
        Approx(1.071519).epsilon(1e-6));
  CHECK(flow_stress(m, 0.1, 1.0, 1046.5).value / flow_stress(m, 0.1, 1.0, 293.0).value ==
        Approx(1 - 0.521233).epsilon(1e-5));
}

TEST_CASE("the thermal factor is clamped below room and above melting temperature", "[material]") {
  const auto m = library::weldox_460e_mjc<double>();
  CHECK(flow_stress(m, 0.1, 1.0, 200.0).value == flow_stress(m, 0.1, 1.0, 293.0).value);
  CHECK(flow_stress(m, 0.1, 1.0, 1800.0).value == 0.0);
  CHECK(flow_stress(m, 0.1, 1.0, 5000.0).value == 0.0);
  CHECK(std::isfinite(flow_stress(m, 0.0, 1.0, 293.0).by_plastic_strain));
}

TEST_CASE("the classical law has both published rate factors", "[material]") {
  JohnsonCook<double> law{490e6, 383e6, 0.45, 0.0123, 0.94, 5e-4, RateFactor::logarithmic};
  const ReferenceTemperatures<double> steel{293, 1800};
  const double quasi_static = 490e6 + 383e6 * std::pow(0.05, 0.45);
  CHECK(flow_stress(law, 0.05, 500.0, 293.0, steel).value == Approx(quasi_static * (1 + 0.0123 * std::log(1e6))));
  CHECK(flow_stress(law, 0.05, 1e-5, 293.0, steel).value == Approx(quasi_static));
  law.rate_factor = RateFactor::power;
  CHECK(flow_stress(law, 0.05, 500.0, 293.0, steel).value == Approx(quasi_static * std::pow(1 + 1e6, 0.0123)));
}

TEST_CASE("Voce hardening saturates", "[material]") {
  const ReferenceTemperatures<double> room{293, 893};
  Voce<double> law{50e6, 100e6, 20, 40e6, 2, {.C = 0, .m = 1}};
  // 50 + 100 (1 - e^-2) + 40 (1 - e^-0.2) MPa, from a hand calculator, six digits.
  CHECK(flow_stress(law, 0.1, 1.0, 293.0, room).value == Approx(143.717e6).epsilon(1e-5));
  CHECK(flow_stress(law, 0.0, 1.0, 293.0, room).value == 50e6);
  CHECK(flow_stress(law, 50.0, 1.0, 293.0, room).value == Approx(190e6));
  law.factors = {.C = 0.01, .m = 1, .reference_rate = 1e-3, .rate_factor = RateFactor::power};
  CHECK(flow_stress(law, 0.0, 999e-3, 293.0, room).value == Approx(50e6 * std::pow(1000, 0.01)));
  CHECK(flow_stress(law, 0.0, 999e-3, 593.0, room).value == Approx(50e6 * std::pow(1000, 0.01) / 2)); // T* = 1/2
}

TEST_CASE("the power law is one of the total strain", "[material]") {
  const ReferenceTemperatures<double> room{293, 925};
  const PowerLaw<double> law{276e6, 68.9e9, 0.0712, {.C = 0, .m = 1}};
  CHECK(flow_stress(law, 0.0, 1.0, 293.0, room).value == 276e6); // yield
  // At a total strain of 0.1: 276 (68900 * 0.1/276)^0.0712 = 347.055 MPa from a hand calculator, and 347.055/68900 of
  // the strain is elastic.
  CHECK(flow_stress(law, 0.1 - 347.055 / 68900, 1.0, 293.0, room).value == Approx(347.055e6).epsilon(3e-6));
  // Two steps of Newton's method solve the implicit law: steep hardening is the worst case.
  const PowerLaw<double> steep{100e6, 200e9, 0.6, {.C = 0, .m = 1}};
  for (const double strain : {1e-4, 5e-4, 2e-3, 0.05, 1.0}) {
    const double stress = flow_stress(steep, strain, 1.0, 293.0, room).value, total = strain + stress / 200e9;
    CHECK(stress == Approx(100e6 * std::pow(200e9 * total / 100e6, 0.6)).epsilon(1e-6));
  }
}

TEST_CASE("a negative rate coefficient is legal, and the flow stress keeps a floor", "[material]") {
  const ReferenceTemperatures<double> room{293, 893};
  const JohnsonCook<double> law{200e6, 300e6, 0.5, -0.05, 1, 1e-3, RateFactor::logarithmic};
  const double slow = flow_stress(law, 0.1, 1e-3, 293.0, room).value;
  CHECK(flow_stress(law, 0.1, 1.0, 293.0, room).value == Approx(slow * (1 - 0.05 * std::log(1e3))));
  // 1 - 0.05 ln(1e9) is below zero.
  const auto fast = flow_stress(law, 0.1, 1e6, 293.0, room);
  CHECK(fast.value == Approx(slow * smallest_rate_factor));
  CHECK(fast.by_rate == 0);
}

TEST_CASE("flow laws give the derivatives of their stress", "[material]") {
  check_derivatives(library::weldox_460e_mjc<double>());
  check_derivatives(library::weldox_460e_jc<double>());
  auto logarithmic = library::weldox_460e_jc<double>();
  logarithmic.flow.rate_factor = RateFactor::logarithmic;
  check_derivatives(logarithmic);
  check_derivatives(library::arne_tool_steel<double>());
  check_derivatives(with_flow(Voce<double>{167e6, 100e6, 20, 90e6, 3, {.C = 0.01, .m = 0.9}}));
  check_derivatives(with_flow(PowerLaw<double>{276e6, 70e9, 0.1, {.C = 0.01, .m = 0.9, .reference_rate = 1e-3}}));
  check_derivatives(with_flow(JohnsonCook<double>{167e6, 596e6, 0.551, -0.01, 0.859, 1, RateFactor::logarithmic}));
}

TEST_CASE("a metal whose flow law gives no strength is refused", "[material]") {
  Metal<double, JohnsonCook<double>> m;
  m.name = "mine";
  m.density = 8960;
  m.elasticity = {124e9, 0.34};
  m.melting_temperature = 1356;
  m.flow = {.A = 90e6, .B = 292e6, .n = 0.31, .C = 0.025, .m = 1.09, .reference_rate = 1};
  check(m);
  const auto refused = Catch::StartsWith("mine flow stress (Pa) at zero plastic strain, the rate floor and room");
  auto weak = m;
  weak.flow.A = 0;
  CHECK_THROWS_WITH(check(weak), refused && Catch::EndsWith("= 0: must be positive and finite"));
  weak.flow.A = -90e6;
  CHECK_THROWS_WITH(check(weak), refused);
  auto without_rate = m; // a reference rate that was forgotten
  without_rate.flow.reference_rate = 0;
  CHECK_THROWS_WITH(check(without_rate), refused);
  auto not_a_number = m;
  not_a_number.flow.C = std::nan("");
  CHECK_THROWS_WITH(check(not_a_number), refused);
  auto molten = m;
  molten.melting_temperature = 293;
  CHECK_THROWS_WITH(check(molten), Catch::StartsWith("mine melting temperature"));
}

TEST_CASE("bilinear hardening under uniaxial strain follows the closed form", "[material]") {
  auto m = library::arne_tool_steel<double>();
  m.specific_heat = 0;
  auto p = initial_point(m);
  // Laterally held compression: s_axial = -2/3 q. Elastic up to q = yield; beyond, 3G (e_dev - ep) = yield + H ep with
  // the equivalent strain 2/3 of the axial one. Compression makes the sign; logarithmic strain is exact for the rate.
  const double strain = 0.04, steps = 4000, G = shear_modulus(m.elasticity);
  for (int i = 0; i < steps; ++i) {
    const double stretch = 1 - strain / steps; // of this step, so that the midstep rate integrates to its logarithm
    const double L = (stretch - 1) / stretch;
    p = updated(m, p, uniaxial_rate(L / 1e-8, 0), 1e-8);
  }
  const double log_strain = -steps * std::log(1 - strain / steps);
  const double equivalent = 2.0 / 3.0 * log_strain;
  const double plastic = (3 * G * equivalent - m.flow.yield) / (3 * G + m.flow.hardening);
  // The midstep rate differs from the logarithm by strain^3/12 of a step: 1e-15. Round-off remains.
  CHECK(p.plastic_strain == Approx(plastic).epsilon(1e-6));
  CHECK(p.deviator.xx == Approx(-2.0 / 3.0 * (m.flow.yield + m.flow.hardening * plastic)).epsilon(1e-6));
  CHECK(p.density == Approx(m.density * std::exp(log_strain)).epsilon(1e-6));
  CHECK(p.pressure == Approx(bulk_modulus(m.elasticity) * (std::exp(log_strain) - 1)).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("simple shear at a constant rate follows the flow law, temperature included", "[material]",
                   ModifiedJohnsonCook<double>, JohnsonCook<double>) {
  const auto metal = [] {
    if constexpr (std::is_same_v<TestType, ModifiedJohnsonCook<double>>)
      return library::weldox_460e_mjc<double>();
    else
      return library::weldox_460e_jc<double>();
  }();
  const double rate = 1e4, dt = 1e-9;
  Mat3<double> L = Mat3<double>::Zero();
  L(0, 1) = rate * std::sqrt(3.0);
  auto p = initial_point(metal);
  // Closed form: dT = beta sigma(ep, rate, T) dep / (rho cp), integrated with a fine midpoint rule along the plastic
  // strain.
  for (int i = 0; i < 30000; ++i) p = updated(metal, p, L, dt);
  double T = 293;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double de = p.plastic_strain / n, e = (i + 0.5) * de;
    T += 0.9 * flow_stress(metal, e, rate, T).value * de / (metal.density * metal.specific_heat);
  }
  CHECK(p.plastic_strain == Approx(0.3).epsilon(0.02)); // total less elastic strain, about 0.0045
  // Elastic strain lags the hardening a little, so that the plastic rate is within 1 % of the total one.
  CHECK(p.plastic_strain_rate == Approx(rate).epsilon(0.01));
  CHECK(p.temperature == Approx(T).epsilon(1e-3));
  CHECK(von_mises(p.deviator) ==
        Approx(flow_stress(metal, p.plastic_strain, p.plastic_strain_rate, p.temperature).value).epsilon(1e-6));
}

TEST_CASE("a rotating stressed point keeps its principal stresses", "[material]") {
  const auto m = library::weldox_460e_mjc<double>();
  auto p = initial_point(m);
  p = updated(m, p, uniaxial_rate(1e3, -300), 1e-6);
  const auto start = p;
  // Positions at the end of a step: x_end = R x_start, so L = (I - R^-1)/dt; 0.1 rad a step, a hundred times that of a
  // run.
  const double angle = 0.1, dt = 1e-7;
  Mat3<double> back;
  back << std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  const Mat3<double> L = (Mat3<double>::Identity() - back) / dt;
  for (int i = 0; i < 1000; ++i) p = updated(m, p, L, dt);
  // Exact up to round-off: the midstep gradient of a rotation is skew, and Hughes-Winget is orthogonal.
  CHECK(von_mises(p.deviator) == Approx(von_mises(start.deviator)).epsilon(1e-10));
  CHECK(p.density == Approx(start.density).epsilon(1e-12));
  // The step rotation is exact: after 1000 steps the axis stands at 100 rad.
  const double c = std::cos(100.0), s = std::sin(100.0);
  CHECK(p.deviator.xy ==
        Approx(c * s * (start.deviator.xx - start.deviator.yy)).margin(1e-6 * von_mises(start.deviator)));
}

TEST_CASE("radial return leaves elastic states alone and ends on the yield surface", "[material]") {
  const auto m = library::weldox_460e_mjc<double>();
  auto p = initial_point(m);
  CHECK(radial_return(m, p, 100e6, 1e-8).increment == 0.0);
  for (const double q : {600e6, 2e9, 50e9, 500e9}) {
    const auto r = radial_return(m, p, q, 1e-8);
    const double t = p.temperature + 0.9 * r.flow_stress * r.increment / (m.density * m.specific_heat);
    const double sigma = flow_stress(m, p.plastic_strain + r.increment, std::max(r.increment / 1e-8, 1.0), t).value;
    CHECK(r.flow_stress == Approx(sigma).epsilon(1e-5).margin(1e-7 * q));
  }
}

TEST_CASE("work of the stresses is elastic energy on an elastic path", "[material]") {
  auto m = library::weldox_460e_mjc<double>();
  m.flow.A = 1e12;
  auto p = initial_point(m);
  Mat3<double> L;
  L << 100, 40, 0, -20, -50, 10, 5, 0, 30;
  for (int i = 0; i < 1000; ++i) p = updated(m, p, L, 1e-8);
  const double stored = double_dot(p.deviator, p.deviator) / (4 * shear_modulus(m.elasticity)) +
                        p.pressure * p.pressure / (2 * bulk_modulus(m.elasticity));
  // Strain 1e-3: second-order terms of density and rotation are 1e-3 of the energy.
  CHECK(p.internal_energy * p.density == Approx(stored).epsilon(2e-3));
}

TEST_CASE("pressure laws agree for small compressions and Mie-Grueneisen follows the Hugoniot", "[material]") {
  const auto m = library::weldox_460e_mjc<double>();
  const double K = bulk_modulus(m.elasticity);
  EquationOfState<double> shock{PressureLaw::mie_gruneisen, 1.49, 1.93};
  CHECK(pressure(shock, K, 1e-5, 0.0) == Approx(pressure(EquationOfState<double>{}, K, 1e-5, 0.0)).epsilon(1e-4));
  // On the Hugoniot p = rho0 Us up, E = rho0 up^2/2, eta = up/Us (Rankine-Hugoniot): exact.
  const double rho = m.density, c0 = std::sqrt(K / rho), up = 500, us = c0 + 1.49 * up, eta = up / us;
  CHECK(pressure(shock, K, eta / (1 - eta), 0.5 * rho * up * up) == Approx(rho * us * up).epsilon(1e-12));
}

TEST_CASE("the library's failure strain of Weldox 460 E is that of Dey 2004", "[material]") {
  // By hand, at a triaxiality of a third and 1/s: (0.636 + 1.936 exp(-2.969/3)) 2000^-0.014; half molten times 1.507.
  const auto m = library::weldox_460e_mjc<double>();
  CHECK(failure_strain(m.damage.failure_strain, 1.0 / 3.0, 1.0, 0.0) == Approx(1.2188).epsilon(1e-4));
  CHECK(failure_strain(m.damage.failure_strain, 1.0 / 3.0, 1.0, 0.5) == Approx(1.2188 * 1.507).epsilon(1e-4));
}

TEST_CASE("damage grows by the plastic strain over the failure strain", "[material]") {
  auto m = library::weldox_460e_mjc<double>();
  m.damage.law = DamageLaw::johnson_cook;
  m.damage.failure_strain = {0.0705, 1.732, -0.54, -0.0123, 0.0};
  CHECK(failure_strain(m.damage.failure_strain, 1.0 / 3.0, 1.0, 0.0) == Approx(0.0705 + 1.732 * std::exp(-0.18)));
  auto p = initial_point(m);
  Mat3<double> L = Mat3<double>::Zero();
  L(0, 1) = 1e4 * std::sqrt(3.0);
  for (int i = 0; i < 10000; ++i) p = updated(m, p, L, 1e-9);
  // Simple shear: triaxiality stays 0 and the rate is constant, so that D = ep/ef.
  const double ef = (0.0705 + 1.732) * std::pow(1e4, -0.0123);
  CHECK(p.damage == Approx(p.plastic_strain / ef).epsilon(2e-3));
}

TEST_CASE("metals with impossible constants are refused by name", "[material]") {
  auto m = library::weldox_460e_mjc<double>();
  m.density = -1;
  CHECK_THROWS_WITH(check(m), Catch::Contains("weldox_460e density") && Catch::Contains("-1"));
  m = library::weldox_460e_mjc<double>();
  m.elasticity.poisson = 0.5;
  CHECK_THROWS_WITH(check(m), Catch::Contains("Poisson"));
}
