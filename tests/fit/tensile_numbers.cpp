// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fit/tensile_numbers.hpp"

#include "catch.hpp"

using namespace ogive;

namespace {

const TensileNumbers aluminium{276e6, 310e6, 68.9e9};

/// Engineering stress and strain of a law at a plastic strain.
template <class Law> std::pair<double, double> engineering(const Law &law, double young, double plastic) {
  const double stress = flow_stress(law, plastic, 1.0, 293.0, ReferenceTemperatures<double>{293, 900}).value;
  const double strain = plastic + stress / young;
  return {stress * std::exp(-strain), std::expm1(strain)};
}

/// Largest engineering stress of a law, Pa, and the engineering strain there.
template <class Law> std::pair<double, double> largest_force(const Law &law, double young) {
  std::pair<double, double> largest{0, 0};
  for (int k = 0; k <= 20000; ++k) largest = std::max(largest, engineering(law, young, k * 2e-5));
  return largest;
}

} // namespace

TEST_CASE("a power law of yield and strength has both, and necks at its exponent", "[fit]") {
  const PowerLaw<double> law = power_law_of(aluminium);
  // 276 (68900 n/276)^n e^-n = 310 MPa at n = 0.0650: 0.065 ln(16.226) - 0.065 = 0.1161 = ln(310/276).
  CHECK(law.n == Approx(0.0650).epsilon(1e-3));
  CHECK(flow_stress(law, 0.0, 1.0, 293.0, ReferenceTemperatures<double>{293, 900}).value == 276e6);
  const auto [strength, elongation] = largest_force(law, 68.9e9);
  CHECK(strength == Approx(310e6).epsilon(1e-6));
  // The strains that are tried are 2e-5 apart, and the force is flat there.
  CHECK(elongation == Approx(std::expm1(law.n)).epsilon(1e-3));
}

TEST_CASE("Voce's law of yield, strength and uniform elongation has all three", "[fit]") {
  const Voce<double> law = voce_of(aluminium, 0.08);
  const auto [strength, elongation] = largest_force(law, 68.9e9);
  CHECK(law.A == 276e6);
  CHECK(strength == Approx(310e6).epsilon(1e-6));
  CHECK(elongation == Approx(0.08).epsilon(1e-3));
}

TEST_CASE("numbers that no tensile test has are refused", "[fit]") {
  using Catch::StartsWith;
  CHECK_THROWS_WITH(power_law_of({276e6, 276e6, 68.9e9}),
                    StartsWith("tensile strength (Pa) = 2.76e+08: must be above"));
  CHECK_THROWS_WITH(power_law_of({276e6, 310e6, 68.9e6}), StartsWith("yield stress (Pa) = 2.76e+08: must be positive"));
  CHECK_THROWS_WITH(power_law_of({100e6, 9000e6, 68.9e9}), StartsWith("tensile strength (Pa) = 9e+09: must be at"));
  CHECK_THROWS_WITH(power_law_of({276e6, 310e6, std::nan("")}), StartsWith("Young's modulus (Pa) = nan: must be pos"));
  CHECK_THROWS_WITH(voce_of(aluminium, 0), StartsWith("uniform elongation = 0: must lie between 0 and 1"));
  // At 60 % the chord from yield rises less than the stress that the slope must equal.
  CHECK_THROWS_WITH(voce_of(aluminium, 0.6), StartsWith("uniform elongation = 0.6: does not fit"));
}
