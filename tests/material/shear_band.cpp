// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/material/library.hpp"
#include "ogive/material/stress_update.hpp"

#include <cmath>
#include <limits>

using namespace ogive;

namespace {

/// A steel whose flow stress (A + B eps)(1 - T*) gives adiabatic curves in closed form.
Metal<double, JohnsonCook<double>> linear_steel() {
  auto metal = library::weldox_460e_jc<double>();
  metal.flow = {600e6, 800e6, 1, 0, 1, 1, RateFactor::logarithmic};
  return metal;
}

/// k in dT* = k (A + B eps)(1 - T*) d eps.
template <class M> double heating_of(const M &metal) {
  return metal.taylor_quinney /
         (metal.density * metal.specific_heat * (metal.melting_temperature - metal.room_temperature));
}

/// The velocity gradient of simple shear at the equivalent rate `rate` (1/s).
Mat3<double> shearing(double rate) {
  Mat3<double> L = Mat3<double>::Zero();
  L(0, 1) = std::sqrt(3.0) * rate;
  return L;
}

/// That of the same flow without rotation.
Mat3<double> stretching(double rate) {
  Mat3<double> L = Mat3<double>::Zero();
  L(0, 0) = std::sqrt(0.75) * rate, L(1, 1) = -L(0, 0);
  return L;
}

/// A steel with bands of a tenth of its particle distance, which form at a strain of 0.2.
auto banded_steel() {
  auto metal = linear_steel();
  metal.shear_band = {50e-6, 0.2, 10};
  return metal;
}

double share_of(const Mat3<double> &L) {
  return simple_shear<double>(symmetric_part(L), Vec3<double>(L(2, 1) - L(1, 2), L(0, 2) - L(2, 0), L(1, 0) - L(0, 1)));
}

} // namespace

TEST_CASE("the adiabatic flow stress is largest at the strain of instability", "[material]") {
  const auto metal = linear_steel();
  const auto &law = metal.flow;
  // With 1 - T* = exp(-k (A eps + B eps^2/2)) the derivative of (A + B eps)(1 - T*) is zero at B = k (A + B eps)^2.
  const double at = (std::sqrt(law.B / heating_of(metal)) - law.A) / law.B;
  CHECK(at > 0.3);
  // Steps of 1e-3 that are exact to first order.
  CHECK(instability_strain(metal, 1e4) == Approx(at).margin(2e-3));

  auto plastic = metal;
  plastic.flow.B = 0;
  CHECK(instability_strain(plastic, 1e4) == Approx(0).margin(2e-3)); // heat alone, from the start
  auto isothermal = metal;
  isothermal.specific_heat = 0;
  CHECK(instability_strain(isothermal, 1e4) == std::numeric_limits<double>::infinity());
  CHECK(instability_strain(library::arne_tool_steel<double>(), 1e4) == std::numeric_limits<double>::infinity());
}

TEST_CASE("heat concentrates by the particle distance over the width of a band", "[material]") {
  auto metal = linear_steel();
  CHECK_FALSE(has_bands(with_shear_bands(metal, 0.6e-3).shear_band)); // none are asked for
  metal.shear_band.time = 50e-6;
  // 2 sqrt(45/(7850 452) 50e-6) m.
  CHECK(band_width(metal) == Approx(0.0503637e-3).epsilon(1e-5));
  const auto coarse = with_shear_bands(metal, 0.6e-3).shear_band, fine = with_shear_bands(metal, 0.05e-3).shear_band;
  CHECK(coarse.concentration == Approx(0.6 / 0.0503637).epsilon(1e-5));
  CHECK(coarse.onset == 0.4 * instability_strain(metal, 1e4));
  CHECK_FALSE(has_bands(fine));
  metal.thermal_conductivity = 0; // not known
  CHECK_FALSE(has_bands(with_shear_bands(metal, 0.6e-3).shear_band));
}

TEST_CASE("simple shear is told from flow without rotation", "[material]") {
  CHECK(share_of(shearing(1e4)) == Approx(1));
  CHECK(share_of(shearing(-3)) == Approx(1));
  CHECK(share_of(stretching(1e4)) == 0);
  // Half of each: |W| is half of what it is in simple shear at the rate of both, along axes that do not mix, root 2.
  Mat3<double> L = shearing(1e4);
  L(2, 2) = L(0, 1) / std::sqrt(3.0), L(0, 0) = L(1, 1) = -0.5 * L(2, 2);
  // |W|^2 = g^2/2, |D|^2 = g^2/2 + 3/2 g^2/3 = g^2.
  CHECK(share_of(L) == Approx(2 / std::sqrt(2.0) - 1));
  L += 1e7 * Mat3<double>::Identity(); // swelling does not count
  CHECK(share_of(L) == Approx(2 / std::sqrt(2.0) - 1));
  CHECK(share_of(Mat3<double>::Zero()) == 0);
}

TEST_CASE("a point that has slipped far enough heats a band alone", "[material]") {
  const auto metal = banded_steel();
  auto p = initial_point(metal);
  const double rate = 1e5, dt = 1e-9;
  while (p.shear_strain < metal.shear_band.onset) p = updated(metal, p, shearing(rate), dt);
  CHECK(p.shear_strain == Approx(p.plastic_strain).epsilon(1e-10));
  const double k = heating_of(metal), A = metal.flow.A, B = metal.flow.B;
  const auto cold = [&](double from, double to) { return A * (to - from) + 0.5 * B * (to * to - from * from); };
  double homologous = homologous_temperature(metal, p.temperature), start = p.plastic_strain;
  CHECK(1 - homologous == Approx(std::exp(-k * cold(0, start))).epsilon(1e-3)); // as without bands

  for (int i = 0; i < 5000; ++i) p = updated(metal, p, shearing(rate), dt);
  const double left = 1 - homologous_temperature(metal, p.temperature);
  CHECK(left < 0.7 * (1 - homologous));
  // First order in steps of 1e-4 of strain, which heat by 2 K each.
  CHECK(left == Approx((1 - homologous) * std::exp(-10 * k * cold(start, p.plastic_strain))).epsilon(2e-3));
  CHECK(von_mises(p.deviator) == Approx((A + B * p.plastic_strain) * left).epsilon(1e-3));
}

TEST_CASE("the work that softens a band from its onset on does not depend on the particle distance", "[material]") {
  const auto work_per_area = [](double spacing) { // J/m2 until a band has half of its strength left
    auto metal = linear_steel();
    metal.shear_band = {50e-6, 0.0, spacing / 0.05e-3};
    auto p = initial_point(metal);
    while (homologous_temperature(metal, p.temperature) < 0.5) p = updated(metal, p, shearing(1e5), 1e-10);
    return spacing * metal.density * p.internal_energy;
  };
  // Elastic energy is stored beside it: (600 MPa)^2/(6 G) = 0.8 MJ/m3, against 2900 MJ/m3 that heat the band by half
  // the way to melting, over 12 or 24 times its width.
  CHECK(work_per_area(1.2e-3) == Approx(work_per_area(0.6e-3)).epsilon(0.01));
}

TEST_CASE("no band forms in flow without rotation", "[material]") {
  const auto metal = banded_steel();
  auto even = linear_steel();
  auto p = initial_point(metal), q = p;
  for (int i = 0; i < 6000; ++i) {
    p = updated(metal, p, stretching(1e5), 1e-9);
    q = updated(even, q, stretching(1e5), 1e-9);
  }
  CHECK(p.plastic_strain > 2 * metal.shear_band.onset);
  CHECK(p.shear_strain == 0);
  CHECK(p.temperature == q.temperature);
}
