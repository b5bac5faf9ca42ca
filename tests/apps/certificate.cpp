// SPDX-License-Identifier: BSD-3-Clause
#include "materials/certificate.hpp"

#include "catch.hpp"
#include "materials/material_keys.hpp"

namespace {

using materials::Certificate;
using PowerLaw = ogive::Metal<double, ogive::PowerLaw<double>>;

const ogive::TensileNumbers aluminium{276e6, 310e6, 68.9e9};

} // namespace

TEST_CASE("a certificate and a metal of its kind make a metal") {
  const auto made = metal_of({.numbers = aluminium}, materials::Model::power_law, "aa6061_t651", "mine");
  const auto &m = std::get<PowerLaw>(made.metal);
  CHECK(m.name == "mine");
  CHECK(m.flow.yield == 276e6);
  CHECK(m.flow.modulus == 68.9e9);
  CHECK(m.flow.n == Approx(0.065).epsilon(1e-3)); // see tests/fit/tensile_numbers.cpp
  CHECK(m.elasticity.young == 68.9e9);
  CHECK(m.density == 2700);
  CHECK(m.flow.factors.C == 0.001);
  CHECK(m.melting_temperature == 925);
  CHECK(m.source.find("yield 276 MPa, tensile strength 310 MPa, Young's modulus 68.9 GPa") != std::string::npos);
  CHECK_FALSE(has(m, materials::Group::work));
  CHECK(made.warnings.empty());
}

TEST_CASE("the effects of rate and temperature are those of the other metal, whatever its law") {
  const auto of = [](const char *other) {
    return std::get<PowerLaw>(
               metal_of({.numbers = {500e6, 600e6, 200e9}}, materials::Model::power_law, other, "mine").metal)
        .flow.factors;
  };
  CHECK(of("weldox_460e").C == 0.0123); // classical Johnson-Cook
  CHECK(of("weldox_460e").reference_rate == 5e-4);
  CHECK(of("weldox_460e").rate_factor == ogive::RateFactor::power);
  CHECK(of("steel_4340").m == 1.03);
  CHECK(of("steel_4340").rate_factor == ogive::RateFactor::logarithmic);
}

TEST_CASE("a reduction of area gives the critical work of the neck") {
  Certificate c{.numbers = aluminium, .reduction_of_area = 0.4};
  const auto made = metal_of(c, materials::Model::power_law, "aa6061_t651", "mine");
  const auto &m = std::get<PowerLaw>(made.metal);
  // Up to a true strain of ln(1/0.6) = 0.511 between the yield stress and the stress there, about 375 MPa: the mean of
  // Y (E eps/Y)^n over the strain is 1/(1 + n) of its end, 352 MPa times 0.511.
  CHECK(m.damage.critical_work == Approx(180e6).epsilon(0.02));
}

TEST_CASE("an elongation below that of the law is a warning") {
  CHECK(metal_of({.numbers = aluminium, .elongation = 0.12}, materials::Model::power_law, "aa6061_t651", "x")
            .warnings.empty());
  // The law necks at exp(0.065) - 1 = 6.7 %.
  CHECK(metal_of({.numbers = aluminium, .elongation = 0.04}, materials::Model::power_law, "aa6061_t651", "x")
            .warnings.size() == 1);
}

TEST_CASE("Voce's law needs the uniform elongation") {
  const auto made =
      metal_of({.numbers = aluminium, .uniform_elongation = 0.08}, materials::Model::voce, "aa6061_t651", "x");
  const auto &m = std::get<ogive::Metal<double, ogive::Voce<double>>>(made.metal);
  CHECK(m.flow.A == 276e6);
  CHECK(m.flow.Q1 > 0);
  CHECK(m.flow.factors.C == 0.001);
}

TEST_CASE("steel and aluminium are known by their Young's modulus") {
  CHECK(materials::kind_of(70e9) == "aa6061_t651");
  CHECK(materials::kind_of(207e9) == "weldox_460e");
  CHECK(materials::kind_of(115e9).empty()); // titanium or copper
}
