// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/core/pack.hpp"

#include <cmath>
#include <limits>
#include <random>

using namespace ogive;

namespace {

/// A pack of random numbers between `low` and `high`.
template <class T> Pack<T> numbers(double low, double high) {
  static std::mt19937 random(11);
  std::uniform_real_distribution<double> any(low, high);
  return pack_of<T>([&](Index) { return T(any(random)); });
}

} // namespace

TEMPLATE_TEST_CASE("packs compute lane by lane", "[core]", double, float) {
  using P = Pack<TestType>;
  const P a = numbers<TestType>(-3, 3), b = numbers<TestType>(0.5, 4), c = TestType(2);
  const P sum = a + b * c - a / b, largest = max(a, b), smallest = min(a, b), size = abs(a), root = sqrt(b);
  for (Index l = 0; l < lanes<TestType>; ++l) {
    CHECK(sum[l] == Approx(a[l] + b[l] * 2 - a[l] / b[l]));
    CHECK(largest[l] == std::max(a[l], b[l]));
    CHECK(smallest[l] == std::min(a[l], b[l]));
    CHECK(size[l] == std::abs(a[l]));
    CHECK(root[l] == std::sqrt(b[l]));
  }
}

TEMPLATE_TEST_CASE("masks choose lane by lane, and NaN is neither above nor below", "[core]", double, float) {
  using P = Pack<TestType>;
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  const P a = pack_of<TestType>([&](Index l) { return l == 1 ? nan : TestType(l); });
  const auto above = a > P(TestType(0));
  const P chosen = select(above & !(a >= P(TestType(2))), P(TestType(10)), P(TestType(-10)));
  for (Index l = 0; l < lanes<TestType>; ++l) {
    CHECK(above[l] == (l != 0 && l != 1));
    CHECK(chosen[l] == TestType(-10)); // only lane 1 lies between 0 and 2, and it holds a NaN
  }
  CHECK(any(above) == (lanes<TestType> > 2));
  CHECK_FALSE(any(a < P(TestType(0))));
}

TEMPLATE_TEST_CASE("powers and reciprocals are as good as documented", "[core]", double, float) {
  const double round_off = std::numeric_limits<TestType>::epsilon();
  for (int i = 0; i < 1000; ++i) {
    const auto x = numbers<TestType>(1e-12, 1e6);
    const auto p = pow(x, TestType(0.481)), l = log(x), r = reciprocal(x), s = inverse_sqrt(x);
    const auto e = exp(numbers<TestType>(-20, 20));
    for (Index lane = 0; lane < lanes<TestType>; ++lane) {
      const double v = x[lane];
      // exp(0.481 log x): |0.481 log x| < 14 times round-off in the logarithm, and some of exp.
      CHECK(std::abs(p[lane] / std::pow(v, TestType(0.481)) - 1) < 20 * round_off);
      CHECK(std::abs(l[lane] - std::log(v)) < 4 * round_off * std::max(1.0, std::abs(std::log(v))));
      // 27 bits, or all that the type has.
      const double bits = std::max(std::ldexp(1.0, -27), 4 * round_off);
      CHECK(std::abs(r[lane] * v - 1) < bits);
      CHECK(std::abs(s[lane] * std::sqrt(v) - 1) < bits);
      CHECK(e[lane] > 0);
    }
  }
}

TEST_CASE("packs are loaded, stored and taken apart", "[core]") {
  std::vector<double> values(lanes<double> + 1);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(i);
  const auto shifted = load_pack(&values[1]);
  store_pack(values.data(), shifted);
  for (Index l = 0; l < lanes<double>; ++l) CHECK(values[l] == l + 1.0);
  Mat3<Pack<double>> m;
  for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = shifted * Pack<double>(double(k));
  CHECK(lane_of(m, 1)(2, 1) == 2.0 * 7);
}
