// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/fit/repeated_limit.hpp"
#include "ogive/sph/layout.hpp"

using ogive::LimitEstimate;
using ogive::repeated_limit;

TEST_CASE("repeated limits give mean, scatter and Student's interval") {
  // 190, 192 and 197 m/s: mean 193, variance (9 + 1 + 16)/2 = 13; t(0.95, 2) = 2.920.
  const auto all = repeated_limit<double>({{190, 0.5}, {192, 0.5}, {197, 0.5}});
  CHECK(all.repeats == 3);
  CHECK(all.mean == Approx(193));
  CHECK(all.deviation.value() == Approx(std::sqrt(13.0)));
  CHECK(all.half_interval.value() == Approx(2.92 * std::sqrt(13.0 / 3)).epsilon(1e-4));
}

TEST_CASE("brackets that agree leave the interval as wide as they are") {
  const auto all = repeated_limit<double>({{190, 3}, {190, 3}});
  CHECK(all.deviation.value() == 0);
  CHECK(all.half_interval.value() == Approx(6.3138 * std::sqrt(3.0 / 2)).epsilon(1e-4));
}

TEST_CASE("one limit has no scatter, and none is refused") {
  const auto one = repeated_limit<double>({{190, 2.5}});
  CHECK(one.mean == 190);
  CHECK(!one.deviation);
  CHECK(!one.half_interval);
  CHECK_THROWS_AS(repeated_limit<double>({}), ogive::SetupError);
}

TEST_CASE("quantiles of Student's distribution are those of tables") {
  // Tables give 1.812, 1.725, 1.671 and, for infinite freedom, 1.645.
  CHECK(ogive::student_quantile_95(10) == Approx(1.812).margin(2e-3));
  CHECK(ogive::student_quantile_95(20) == Approx(1.725).margin(1e-3));
  CHECK(ogive::student_quantile_95(60) == Approx(1.671).margin(1e-3));
  CHECK(ogive::student_quantile_95(1000000) == Approx(1.645).margin(1e-3));
}

TEST_CASE("the interval covers the limit in nine cases of ten") {
  // Limits of normal scatter about 200 m/s (sum of 12 random numbers, Irwin-Hall), three repeats each.
  constexpr int trials = 4000;
  std::uint64_t place = 0;
  const auto normal = [&] {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += ogive::random_number(7, place++);
    return sum;
  };
  int covered = 0;
  for (int k = 0; k < trials; ++k) {
    std::vector<LimitEstimate<double>> limits;
    for (int r = 0; r < 3; ++r) limits.push_back({200 + 4 * normal(), 0.1});
    const auto all = repeated_limit(limits);
    covered += std::abs(all.mean - 200) <= *all.half_interval;
  }
  // Three standard deviations of a count of 4000 with p = 0.9 are 57.
  CHECK(std::abs(covered - 0.9 * trials) < 60);
}
