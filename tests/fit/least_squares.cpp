// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "instances/fits.hpp"

#include "ogive/fit/exponents.hpp"
#include "ogive/fit/hardening_fit.hpp"
#include "ogive/fit/least_squares.hpp"

using namespace ogive;

TEST_CASE("least squares finds the straight line through four points") {
  // y = 1, 3, 4, 4 at x = 0, 1, 2, 3: mean 3, slope sum (x - 1.5) y / 5 = 1, so 1.5 + x, by hand.
  const Eigen::Vector4d x(0, 1, 2, 3), y(1, 3, 4, 4);
  const auto residual = [&](const Eigen::VectorXd &p) { return Eigen::VectorXd(p[0] + p[1] * x.array() - y.array()); };
  const auto p = least_squares(residual, Eigen::VectorXd{{0, 0}}, Eigen::VectorXd{{1, 1}});
  // Differences of a linear function are exact but for round-off, 1e-16/1e-6.
  CHECK(p[0] == Approx(1.5).epsilon(1e-8));
  CHECK(p[1] == Approx(1).epsilon(1e-8));
}

TEST_CASE("least squares finds a curved valley's bottom whatever the parameters' units") {
  // Rosenbrock's function has its minimum at (1, 1).
  const auto residual = [](const Eigen::VectorXd &p) {
    const double u = p[0] / 1e8;
    return Eigen::VectorXd{{10 * (p[1] - u * u), 1 - u}};
  };
  const auto p = least_squares(residual, Eigen::VectorXd{{-1.2e8, 1}}, Eigen::VectorXd{{1e8, 1}});
  CHECK(p[0] == Approx(1e8).epsilon(1e-7));
  CHECK(p[1] == Approx(1).epsilon(1e-7));
}

TEST_CASE("hardening is found from three points and a fourth between them, with any factor") {
  std::vector<HardeningPoint> points;
  for (const double strain : {0.0, 0.01, 0.05, 0.25})
    points.push_back({strain, (1 + strain) * (400e6 + 300e6 * std::sqrt(strain)), 1 + strain});
  const auto h = fit_hardening(points, "curve");
  // No scatter: what remains is Levenberg-Marquardt's own tolerance.
  CHECK(h.A == Approx(400e6).epsilon(1e-7));
  CHECK(h.B == Approx(300e6).epsilon(1e-7));
  CHECK(h.a == Approx(0.5).epsilon(1e-7));
}

TEST_CASE("a curve that does not harden as the law wants is refused") {
  std::vector<HardeningPoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({0.01 * i, 500e6 - 1e8 * i * 0.01, 1});
  CHECK_THROWS_WITH(fit_hardening(points, "quasi-static curve"), Catch::StartsWith("quasi-static curve: B (MPa) = -") &&
                                                                     Catch::Contains("must give a positive one"));
  points.resize(3);
  CHECK_THROWS_WITH(fit_hardening(points, "quasi-static curve"),
                    Catch::StartsWith("quasi-static curve: points = 3: must be four or more"));
}

TEST_CASE("each rate factor's equation for C holds at its own C") {
  for (const auto form : all_flow_forms) {
    const FlowFrame f{form, 0.05, 293, 1800};
    const double C = 0.013, rate = 700, rate0 = 0.2;
    const auto e = rate_equation(f, rate_factor(f, C, rate) / rate_factor(f, C, rate0), rate, rate0);
    CHECK(e.y == Approx(C * e.z).epsilon(1e-12));
    CHECK(e.x > 0);
  }
}

TEST_CASE("the thermal exponent is the one of the best sum of squares, or nothing") {
  std::vector<SofteningPoint> points;
  for (const double t : {0.1, 0.3, 0.5}) points.push_back({t, 1 - std::pow(t, 0.94)});
  CHECK(fit_thermal_exponent(points).value() == Approx(0.94).epsilon(1e-12));
  // One point: 1 - 0.5^b = 0.25, b = ln 0.75/ln 0.5.
  CHECK(fit_thermal_exponent({{0.5, 0.25}}).value() == Approx(std::log(0.75) / std::log(0.5)).epsilon(1e-12));
  CHECK_FALSE(fit_thermal_exponent({{0.3, 1.1}}));
}
