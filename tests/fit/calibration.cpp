// SPDX-License-Identifier: BSD-3-Clause
#include "law_curves.hpp"

#include "catch.hpp"
#include "instances/fits.hpp"

#include "ogive/fit/calibration.hpp"
#include "ogive/fit/simultaneous.hpp"
#include "ogive/fit/strain_bins.hpp"

#include <array>

using namespace ogive;

namespace {

/// The steel of Table 1 as its three laws: the classical ones with a reference rate of their own.
const ModifiedJohnsonCook<double> modified{503e6, 581e6, 0.481, 0.01, 0.94};
JohnsonCook<double> classical(RateFactor factor) { return {490e6, 383e6, 0.45, 0.0123, 0.94, 5e-4, factor}; }

template <class Law> TestSeries steel(const Law &law, double noise = 0, unsigned seed = 1, int points = 60) {
  LawCurves<Law> tests{law, noise, {std::mt19937_64(seed)}, steel_heat_per_work, points};
  tests.add_all();
  return sorted_series(tests.curves, steel_settings());
}

void check_near(const Eigen::VectorXd &found, const std::array<double, 5> &known, double epsilon) {
  for (std::size_t i = 0; i < 5; ++i) CHECK(found[static_cast<Eigen::Index>(i)] == Approx(known[i]).epsilon(epsilon));
}

/// How often each parameter lies within two standard errors of the truth, over 100 seeds.
template <class Fit> std::array<int, 5> coverage(Fit &&fit) {
  std::array<int, 5> inside{};
  const std::array<double, 5> truth{503e6, 581e6, 0.481, 0.01, 0.94};
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Calibration c = fit(steel(modified, 0.01, seed, 30));
    const Eigen::VectorXd found = parameters(c), error = standard_errors(covariance_of(c, 0));
    for (std::size_t i = 0; i < 5; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      inside[i] += std::abs(found[k] - truth[i]) <= 2 * error[k];
    }
  }
  return inside;
}

void report(const char *what, const std::array<int, 5> &inside) {
  INFO(what << ": A " << inside[0] << ", B " << inside[1] << ", a " << inside[2] << ", C " << inside[3] << ", b "
            << inside[4] << " of 100");
  // Two standard errors hold 95.4 % if the scatter is normal; the count over 100 seeds scatters by 2.1, so that 90
  // is 2.6 of that below.
  for (const int count : inside) CHECK(count >= 90);
}

} // namespace

TEST_CASE("three steps return the law that made the curves, adiabatic ones included") {
  // The heating of a test is summed by trapezoids over 60 points: some 1e-3 K, which is 1e-6 of the stress.
  const auto mjc = calibrated(steel(modified), steel_choice(FlowForm::modified));
  check_near(parameters(mjc), {503e6, 581e6, 0.481, 0.01, 0.94}, 1e-3);
  CHECK(mjc.quasi_static[0].A == Approx(503e6 * std::pow(7.4e-4, 0.01)).epsilon(1e-3));
  for (const auto factor : {RateFactor::logarithmic, RateFactor::power}) {
    const auto form = factor == RateFactor::power ? FlowForm::power : FlowForm::logarithmic;
    const auto jc = calibrated(steel(classical(factor)), steel_choice(form, 5e-4));
    check_near(parameters(jc), {490e6, 383e6, 0.45, 0.0123, 0.94}, 1e-3);
  }
}

TEST_CASE("the simultaneous fit returns the law that made the curves") {
  for (const auto form : all_flow_forms) {
    const bool mjc = form == FlowForm::modified;
    const auto series =
        mjc ? steel(modified) : steel(classical(form == FlowForm::power ? RateFactor::power : RateFactor::logarithmic));
    const auto choice = steel_choice(form, 5e-4);
    const auto c = simultaneously_calibrated(series, choice, calibrated(series, choice));
    if (mjc)
      check_near(parameters(c), {503e6, 581e6, 0.481, 0.01, 0.94}, 1e-3);
    else
      check_near(parameters(c), {490e6, 383e6, 0.45, 0.0123, 0.94}, 1e-3);
  }
}

TEST_CASE("a heated quasi-static curve and pooled rates do not disturb the round trip") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  for (const double rate : {20.0, 45.0, 2000.0}) tests.add(rate, 293, 0.2);
  for (const double hot : {473.0, 773.0}) tests.add(1e-3, hot, 0.2);
  const auto series = sorted_series(tests.curves, steel_settings());
  CHECK(series.quasi_static_rate == Approx(30));
  check_near(parameters(calibrated(series, steel_choice(FlowForm::modified))), {503e6, 581e6, 0.481, 0.01, 0.94}, 1e-3);
}

TEST_CASE("with 1 % scatter the parameters lie within two standard errors", "[coverage]") {
  const auto choice = steel_choice(FlowForm::modified);
  report("three steps", coverage([&](const TestSeries &s) { return calibrated(s, choice); }));
  report("all at once",
         coverage([&](const TestSeries &s) { return simultaneously_calibrated(s, choice, calibrated(s, choice)); }));
}

TEST_CASE("correlations are symmetric, at most 1, and 1 on the diagonal") {
  const auto series = steel(modified, 0.01);
  const auto choice = steel_choice(FlowForm::modified);
  const auto steps = calibrated(series, choice);
  for (const auto &c : {steps, simultaneously_calibrated(series, choice, steps)}) {
    const Eigen::MatrixXd r = correlation(covariance_of(c, 0));
    CHECK(r == r.transpose());
    CHECK(r.diagonal() == Eigen::VectorXd::Ones(5));
    CHECK(r.cwiseAbs().maxCoeff() <= 1 + 1e-12);
    // A and a must trade against each other: a flatter start of the curve with a larger yield stress looks alike.
    CHECK(r(0, 2) > 0.5);
  }
}

TEST_CASE("given values of C and b are kept, without error") {
  auto choice = steel_choice(FlowForm::modified);
  choice.C = 0.02;
  choice.b = 0.8;
  const auto series = steel(modified, 0.01);
  const auto steps = calibrated(series, choice);
  for (const auto &c : {steps, simultaneously_calibrated(series, choice, steps)}) {
    CHECK(c.C == 0.02);
    CHECK(c.b == 0.8);
    const Eigen::VectorXd error = standard_errors(covariance_of(c, 0));
    CHECK(error[3] == 0);
    CHECK(error[4] == 0);
    CHECK(error[0] > 0);
  }
}

TEST_CASE("the band of temperatures that is left out does not count") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  tests.add_all();
  // Blue brittleness: stronger at 473 to 673 K.
  for (auto &c : tests.curves)
    if (c.temperature >= 473 && c.temperature <= 673)
      for (double &stress : c.stress) stress *= 1.1;
  const auto choice = steel_choice(FlowForm::modified);
  auto settings = steel_settings();
  const double with_band = calibrated(sorted_series(tests.curves, settings), choice).b;
  settings.left_out = Interval{473, 673};
  const auto series = sorted_series(tests.curves, settings);
  CHECK(with_band > 1.1 * 0.94);
  CHECK(calibrated(series, choice).b == Approx(0.94).epsilon(1e-3));
  CHECK(simultaneously_calibrated(series, choice, calibrated(series, choice)).b == Approx(0.94).epsilon(1e-3));
  CHECK(std::count_if(series.curves.begin(), series.curves.end(),
                      [](const auto &c) { return c.use == CurveUse::left_out; }) == 3);
  CHECK(series.messages.size() == 3);
}

TEST_CASE("without heating a fast curve looks softer and C smaller") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  tests.add_all();
  auto settings = steel_settings();
  settings.heat_per_work = 0;
  const auto choice = steel_choice(FlowForm::modified);
  const double C = calibrated(sorted_series(tests.curves, settings), choice).C;
  CHECK(C < 0.0095);
  CHECK(C > 0.005);
}

TEST_CASE("curves near room temperature count as being there, colder ones are left out") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  tests.add_all();
  for (auto &c : tests.curves)
    if (c.temperature == 293) c.temperature = 300;
  tests.add(1e-3, 200, 0.2);
  const auto series = sorted_series(tests.curves, steel_settings());
  check_near(parameters(calibrated(series, steel_choice(FlowForm::modified))), {503e6, 581e6, 0.481, 0.01, 0.94}, 1e-3);
  REQUIRE(series.messages.size() == 1);
  CHECK(series.messages[0] == "0.001 1/s, 200 K: left out, colder than room temperature");
}

TEST_CASE("each plate has its own hardening, and plates without one share that of all") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  tests.add(1e-3, 293, 0.3, "thin");
  tests.law.A *= 0.85;
  tests.law.B *= 0.85;
  tests.add(1e-3, 293, 0.3, "thick");
  for (const double rate : {2.0, 1500.0}) tests.add(rate, 293, 0.2, "thick");
  for (const double hot : {473.0, 773.0}) tests.add(1e-3, hot, 0.2, "thick");
  const auto choice = steel_choice(FlowForm::modified);
  const auto series = sorted_series(tests.curves, steel_settings());
  const auto c = calibrated(series, choice);
  REQUIRE(c.hardenings == std::vector<std::string>{"thin", "thick"});
  for (const auto &fit : {c, simultaneously_calibrated(series, choice, c)}) {
    check_near(parameters(fit), {503e6, 581e6, 0.481, 0.01, 0.94}, 1e-3);
    CHECK(fit.hardening[1].A == Approx(0.85 * 503e6).epsilon(1e-3));
    CHECK(fit.hardening[1].B == Approx(0.85 * 581e6).epsilon(1e-3));
  }
  // A hot test of a third plate follows the mean of both: (1 + 0.85)/2 of Table 1.
  tests.law.A = 0.925 * 503e6;
  tests.law.B = 0.925 * 581e6;
  tests.add(1e-3, 673, 0.2, "other");
  const auto pooled = calibrated(sorted_series(tests.curves, steel_settings()), choice);
  REQUIRE(pooled.hardenings == std::vector<std::string>{"thin", "thick", all_plates});
  CHECK(pooled.hardening[2].A == Approx(0.925 * 503e6).epsilon(1e-3));
  CHECK(pooled.b == Approx(0.94).epsilon(1e-3));
}

TEST_CASE("a curve that is too low bends least squares and leaves the robust fit nearly alone") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified, 0.005};
  tests.add_all();
  // 10 % of the quasi-static and of the hottest curve are read 20 % too low.
  for (auto *c : {&tests.curves.front(), &tests.curves.back()})
    for (std::size_t i = 0; i < c->stress.size(); i += 10) c->stress[i] *= 0.8;
  const auto series = sorted_series(tests.curves, steel_settings());
  const auto choice = steel_choice(FlowForm::modified);
  const auto steps = calibrated(series, choice);
  const auto robust = simultaneously_calibrated(series, choice, steps);
  CHECK(std::abs(robust.hardening[0].A - 503e6) < 0.4 * std::abs(steps.hardening[0].A - 503e6));
  CHECK(robust.b == Approx(0.94).epsilon(0.01));
  CHECK(robust.C == Approx(0.01).epsilon(0.05));
}

TEST_CASE("what is missing is named with what helps") {
  LawCurves<ModifiedJohnsonCook<double>> tests{modified};
  const auto choice = steel_choice(FlowForm::modified);
  tests.add(1e-3, 500, 0.2);
  CHECK_THROWS_WITH(sorted_series(tests.curves, steel_settings()),
                    Catch::StartsWith("curves within 10 K of room temperature = 0") &&
                        Catch::Contains("room temperature is 293 K"));
  tests.add(1e-3, 293, 0.2);
  CHECK_THROWS_WITH(
      calibrated(sorted_series(tests.curves, steel_settings()), choice),
      Catch::StartsWith(
          "points for C = 0: needs two or more of a curve at room temperature faster than 3 times 0.001") &&
          Catch::EndsWith("or a known value of C"));
  tests.add(1e3, 293, 0.2);
  tests.curves.erase(tests.curves.begin());
  CHECK_THROWS_WITH(calibrated(sorted_series(tests.curves, steel_settings()), choice),
                    Catch::StartsWith("points for b = 0: needs two or more of a curve hotter than 303 K") &&
                        Catch::EndsWith("or a known value of b"));
}

TEST_CASE("C and b of each bin are those of the law, and the bins' scatter is that of the points") {
  const auto series = steel(modified);
  const auto c = calibrated(series, steel_choice(FlowForm::modified));
  for (const auto &bin : rate_bins(series, c)) CHECK(bin.value == Approx(0.01).epsilon(1e-3));
  const auto thermal = thermal_bins(series, c);
  CHECK(thermal.size() == 6); // all, and five temperatures
  for (const auto &[temperature, bins] : thermal)
    for (const auto &bin : bins) CHECK(bin.value == Approx(0.94).epsilon(1e-3));
  const auto noisy = steel(modified, 0.01, 1, 400);
  const auto fit = calibrated(noisy, steel_choice(FlowForm::modified));
  double spread = 0, error = 0, count = 0;
  for (const auto &bin : rate_bins(noisy, fit)) {
    if (bin.points < 30) continue; // the ends of the curves
    spread += (bin.value - fit.C) * (bin.value - fit.C);
    error += bin.standard_error * bin.standard_error;
    ++count;
  }
  CHECK(count > 15);
  // A variance from some twenty bins is good to about 30 %; the error of the hardening curve, which all bins share, is
  // in the spread but not in the bins' own errors.
  CHECK(spread / error == Approx(1).epsilon(0.7));
}

TEST_CASE("the misfit names the worst point") {
  auto series = steel(modified);
  const auto c = calibrated(series, steel_choice(FlowForm::modified));
  series.curves[0].curve.stress[10] -= 50e6;
  const auto m = misfit(series.curves[0], c);
  CHECK(m.largest == Approx(50e6).epsilon(1e-3));
  CHECK(m.strain == series.curves[0].curve.strain[10]);
  CHECK(m.rms == Approx(50e6 / std::sqrt(60.0)).epsilon(1e-3));
}

TEST_CASE("an adiabatic curve keeps the energy balance") {
  std::vector<double> strains;
  for (int i = 1; i <= 400; ++i) strains.push_back(0.001 * i);
  const auto points = adiabatic_curve(modified, steel_temperatures, 1e3, 293.0, steel_heat_per_work, strains);
  StressCurve c{"", "", 1e3, 293, strains, {}};
  for (const auto &p : points) c.stress.push_back(p.stress);
  // Trapezoids err at the steep start only: half of sigma(0.001) - sigma(0) over 0.001, 1e-3 K here.
  CHECK(adiabatic_temperature(c, 293, steel_heat_per_work).back() == Approx(points.back().temperature).margin(0.01));
  CHECK(points.back().temperature > 350);
}
