// A flow law of one's own: Voce hardening, sigma = A + Q (1 - exp(-b eps)), in a namespace of one's own.
// Run: 07_own_flow_law. It prints the stress of a sheared point against the formula (to 1e-8), and the largest plastic
// strain of a plate of this metal 10 us after the impact.
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

namespace mine {

/// sigma = A + Q (1 - exp(-b eps)), Pa.
template <class T> struct Voce { T A{}, Q{}, b{}; };

/// The library finds this by its arguments. `N` is T or a pack of several T, hence the `using`.
template <class T, class N> ogive::FlowStress<N> flow_stress(const Voce<T> &law, N plastic_strain, N, N) {
  using std::exp;
  const N left = law.Q * exp(-law.b * plastic_strain);
  return {law.A + law.Q - left, law.b * left, N(0), N(0)}; // value, and slopes by strain, rate and temperature
}

} // namespace mine

int main() {
  using namespace ogive;
  Metal<double, mine::Voce<double>> metal;
  metal.name = "voce";
  metal.density = 7850;
  metal.elasticity = {.young = 200e9, .poisson = 0.33};
  metal.flow = {.A = 500e6, .Q = 300e6, .b = 15};
  static_assert(PackedFlowLaw<mine::Voce<double>, double>, "otherwise points flow one by one, which is slower");

  MaterialPoint<double> point = initial_point(metal);
  Mat3<double> shear = Mat3<double>::Zero();
  shear(0, 1) = 1000; // 1/s
  for (int k = 0; k < 300; ++k) point = updated(metal, point, shear, 1e-6);
  const double expected = flow_stress(metal, point.plastic_strain, 1.0, 0.0).value;
  const double computed = von_mises(point.deviator);
  std::printf("eps %.4f  stress %.3f MPa  Voce %.3f MPa\n", point.plastic_strain, computed * 1e-6, expected * 1e-6);

  const PerforationCase<double> shot{.thickness = 6e-3, .spacing = 1.5e-3};
  auto model = make_perforation(shot, metal, library::arne_tool_steel<double>());
  const RunOptions<double> until{.end_time = 10e-6};
  const auto result = run(model, until, [](const auto &, const auto &) { return true; });
  const auto &strain = plate_particles(model).points.plastic_strain;
  std::printf("plate: largest plastic strain %.3f\n", *std::max_element(strain.begin(), strain.end()));
  return !result.fault && std::abs(computed / expected - 1) < 1e-8 ? 0 : 1;
}
