// A kernel of one's own: Wendland C4 (1995). It gives norm, shape w(u) and (dw/du)/u with u = r/h, zero from u = 2 on.
// Run: 08_own_kernel. It prints the integral of W (1), the difference of the slope from a difference quotient (0), and
// the energy error of 10 us of a shot with it.
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <numbers>
#include <ogive/ogive.hpp>

struct WendlandC4 {
  static constexpr double norm = 495.0 / (256.0 * std::numbers::pi);
  template <class T> static T shape(T u) {
    const T s = std::max(T(1) - T(0.5) * u, T(0));
    return s * s * s * s * s * s * (T(35.0 / 12.0) * u * u + T(3) * u + T(1));
  }
  // Takes packs of numbers too: no branch on a value, and max() by its arguments.
  template <class T> static T slope_over_u(T u, T) {
    using std::max;
    const T s = max(T(1) - T(0.5) * u, T(0));
    return T(-14.0 / 3.0) * (s * s * s * s * s) * (T(1) + T(2.5) * u);
  }
};
static_assert(ogive::SmoothingKernel<WendlandC4>);

int main() {
  using namespace ogive;
  double integral = 0, slope_error = 0;
  const int n = 20000;
  const double du = kernel_support / n, h = 1e-3;
  for (int k = 0; k < n; ++k) {
    const double u = (k + 0.5) * du;
    integral += 4 * std::numbers::pi * u * u * du * h * h * h * kernel_value<WendlandC4>(u * h, h);
    const double quotient = (WendlandC4::shape(u + 0.5 * du) - WendlandC4::shape(u - 0.5 * du)) / du;
    slope_error = std::max(slope_error, std::abs(quotient - u * WendlandC4::slope_over_u(u, 1 / u)));
  }
  std::printf("integral %.9f, largest error of the slope %.1g\n", integral, slope_error);

  const PerforationCase<double> shot{.thickness = 6e-3, .spacing = 1.5e-3};
  const auto plate = library::weldox_460e_mjc<double>();
  auto model = make_perforation<WendlandC4>(shot, plate, library::arne_tool_steel<double>());
  const double start = total(energy(model));
  const RunOptions<double> until{.end_time = 10e-6};
  const auto result = run(model, until, [](const auto &, const auto &) { return true; });
  const double error = total(energy(model)) / start - 1;
  std::printf("%lld steps, energy error %.2g\n", static_cast<long long>(model.steps), error);
  const bool right = std::abs(integral - 1) < 1e-7 && slope_error < 1e-6 && std::abs(error) < 2e-3;
  return !result.fault && right ? 0 : 1;
}
