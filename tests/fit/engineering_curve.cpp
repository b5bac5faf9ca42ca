// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/fit/stress_curve.hpp"

#include <cmath>

using namespace ogive;

TEST_CASE("a Ludwik curve K eps^n necks at eps = n") {
  // Engineering stress K eps^n exp(-eps) is largest where n/eps = 1 (Considère).
  const double K = 900e6, n = 0.2, young = 200e9, step = 0.0005;
  std::vector<double> strain, stress;
  for (int i = 0; i <= 800; ++i) {
    const double plastic = step * i, true_stress = K * std::pow(plastic, n), total = plastic + true_stress / young;
    strain.push_back(std::expm1(total));
    stress.push_back(true_stress * std::exp(-total));
  }
  const auto c = true_curve(strain, stress, young);
  // With elasticity d sigma/d eps = sigma gives the plastic strain n (1 - sigma/E), here 0.3 % less than n; the points
  // are one step apart.
  CHECK(c.necking_strain == Approx(n * (1 - K * std::pow(n, n) / young)).margin(step));
  CHECK(c.necking_strain == Approx(n).epsilon(0.006));
  CHECK(c.strain.back() == Approx(c.necking_strain));
  CHECK(c.necked + c.elastic + c.strain.size() == strain.size());
  CHECK(c.strain.front() >= least_plastic_strain);
  for (std::size_t i = 0; i < c.strain.size(); ++i) {
    CHECK(c.stress[i] == Approx(K * std::pow(c.strain[i], n)).epsilon(1e-9));
    CHECK(c.strain[i] == Approx(step * static_cast<double>(c.from[i])).epsilon(1e-9));
  }
}

TEST_CASE("a curve that does not neck keeps its end, an empty one stays empty") {
  const auto c = true_curve({0, 0.05, 0.1}, {0, 500e6, 550e6}, 200e9);
  CHECK(c.necked == 0);
  CHECK(c.elastic == 1);
  CHECK(c.stress == std::vector<double>{500e6 * 1.05, 550e6 * 1.1});
  CHECK(true_curve({}, {}, 200e9).strain.empty());
}
