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
Mat3<double> plane_stretching(double rate) {
  Mat3<double> L = Mat3<double>::Zero();
  L(0, 0) = std::sqrt(0.75) * rate, L(1, 1) = -L(0, 0);
  return L;
}

/// A steel in particles 0.6 mm apart, with bands from a strain of 0.2 on.
auto banded_steel() {
  auto metal = linear_steel();
  metal.shear_band = {0.5, 0.2, 0.6e-3, thermal_diffusivity(metal)};
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

TEST_CASE("a band is as wide as heat spreads in its age", "[material]") {
  auto metal = linear_steel();
  CHECK_FALSE(has_bands(with_shear_bands(metal, 0.6e-3).shear_band)); // none are asked for
  metal.shear_band.onset_ratio = 0.5;
  const auto band = with_shear_bands(metal, 0.6e-3).shear_band;
  CHECK(has_bands(band));
  CHECK(band.onset == 0.5 * instability_strain(metal, 1e4));
  // 2 sqrt(45/(7850 452) t) m.
  CHECK(band_width(band.diffusivity, 50e-6) == Approx(0.0503637e-3).epsilon(1e-5));
  CHECK(band_width(band.diffusivity, 200e-6) == Approx(0.1007274e-3).epsilon(1e-5));
  CHECK(heat_excess(band, 50e-6) == Approx(0.6 / 0.0503637 - 1).epsilon(1e-5));
  CHECK(heat_excess(band, 1.0) == 0); // as wide as the particle
  CHECK(kept_excess(band, 50e-6, 200e-6) == Approx((0.6 / 0.1007274 - 1) / (0.6 / 0.0503637 - 1)).epsilon(1e-5));
  CHECK(kept_excess(band, 0.0, 1e-6) == 0); // a new one
  CHECK(kept_excess(band, 1.0, 2.0) == 0);

  metal.thermal_conductivity = 0; // not known
  CHECK_FALSE(has_bands(with_shear_bands(metal, 0.6e-3).shear_band));
  auto hardening = library::arne_tool_steel<double>(); // never unstable
  hardening.thermal_conductivity = 30, hardening.shear_band.onset_ratio = 0.5;
  CHECK_FALSE(has_bands(with_shear_bands(hardening, 0.6e-3).shear_band));
}

TEST_CASE("simple shear is told from flow without rotation", "[material]") {
  CHECK(share_of(shearing(1e4)) == Approx(1));
  CHECK(share_of(shearing(-3)) == Approx(1));
  CHECK(share_of(plane_stretching(1e4)) == 0);
  // Half of each: |W| is half of what it is in simple shear at the rate of both, along axes that do not mix, root 2.
  Mat3<double> L = shearing(1e4);
  L(2, 2) = L(0, 1) / std::sqrt(3.0), L(0, 0) = L(1, 1) = -0.5 * L(2, 2);
  // |W|^2 = g^2/2, |D|^2 = g^2/2 + 3/2 g^2/3 = g^2.
  CHECK(share_of(L) == Approx(2 / std::sqrt(2.0) - 1));
  L += 1e7 * Mat3<double>::Identity(); // swelling does not count
  CHECK(share_of(L) == Approx(2 / std::sqrt(2.0) - 1));
  CHECK(share_of(Mat3<double>::Zero()) == 0);
}

TEST_CASE("a band heats as a plane with an even flux does, and cools as its heat spreads", "[material]") {
  auto metal = banded_steel();
  metal.flow.B = 0;                 // so that the flux is even
  metal.melting_temperature = 1e12; // and heat does not weaken
  const double rate = 1e5, dt = 2e-9, kappa = metal.shear_band.diffusivity, spacing = metal.shear_band.spacing;
  const double heating = metal.taylor_quinney * metal.flow.A * rate / (metal.density * metal.specific_heat); // K/s
  auto p = initial_point(metal);
  while (p.shear_strain < metal.shear_band.onset) p = updated(metal, p, shearing(rate), dt);
  CHECK(p.shear_strain == Approx(p.plastic_strain).epsilon(1e-10));
  CHECK(p.band_age == 0);
  CHECK(p.temperature - metal.room_temperature == Approx(heating * p.plastic_strain / rate).epsilon(1e-3)); // even

  const double start = p.temperature;
  while (p.band_age < 20e-6) p = updated(metal, p, shearing(rate), dt);
  // The heat per area is heating t times the spacing; the band has it at its width, the mean over the spacing.
  const auto width_at = [&](double t) { return 2 * std::sqrt(kappa * t); };
  const double mean = start + heating * p.band_age;
  const double excess = heating * p.band_age * (spacing / width_at(p.band_age) - 1);
  // The mean follows from the internal energy, with the elastic part: 2e-4 of the whole.
  CHECK(p.temperature - mean == Approx(excess).epsilon(1e-3));

  // At rest three times as long it is twice as wide. The stress stays at the flow stress, and nothing flows.
  const double strain = p.plastic_strain, hottest_age = p.band_age;
  while (p.band_age < 4 * hottest_age) p = updated(metal, p, shearing(0), dt);
  CHECK(p.plastic_strain == Approx(strain).epsilon(1e-6));
  CHECK(p.temperature - mean == Approx(heating * hottest_age * (spacing / width_at(p.band_age) - 1)).epsilon(1e-3));
}

TEST_CASE("a band loses strength that an even particle keeps", "[material]") {
  const auto metal = banded_steel();
  auto even = linear_steel();
  auto p = initial_point(metal), q = p;
  for (int i = 0; i < 7000; ++i) {
    p = updated(metal, p, shearing(1e5), 1e-9);
    q = updated(even, q, shearing(1e5), 1e-9);
  }
  CHECK(von_mises(p.deviator) < 0.25 * von_mises(q.deviator)); // 0.16: near melting
  CHECK(p.temperature < metal.melting_temperature);
}

TEST_CASE("the work that softens a band from its onset on does not depend on the particle distance", "[material]") {
  const auto work_per_area = [](double spacing) { // J/m2 until a band has half of its strength left
    auto metal = linear_steel();
    metal.shear_band = {0.5, 0.0, spacing, thermal_diffusivity(metal)};
    auto p = initial_point(metal);
    const double rate = 60 / spacing; // the same slip
    while (homologous_temperature(metal, p.temperature) < 0.5) p = updated(metal, p, shearing(rate), 1e-10);
    return spacing * metal.density * p.internal_energy;
  };
  // The metal hardens less in the wider particle, whose mean strain is half as large: 3 %; its elastic energy,
  // (600 MPa)^2/(6 G) = 0.8 MJ/m3, is 2 % of the work here.
  CHECK(work_per_area(1.2e-3) == Approx(work_per_area(0.6e-3)).epsilon(0.06));
}

TEST_CASE("no band forms in flow without rotation", "[material]") {
  const auto metal = banded_steel();
  auto even = linear_steel();
  auto p = initial_point(metal), q = p;
  for (int i = 0; i < 6000; ++i) {
    p = updated(metal, p, plane_stretching(1e5), 1e-9);
    q = updated(even, q, plane_stretching(1e5), 1e-9);
  }
  CHECK(p.plastic_strain > 2 * metal.shear_band.onset);
  CHECK(p.shear_strain == 0);
  CHECK(p.temperature == q.temperature);
}
