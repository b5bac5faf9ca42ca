// Taylor's test: a copper rod, 32.4 mm by 6.4 mm, hits a rigid wall at 227 m/s. A quarter is computed with B-bar hexes.
// Run: 04_taylor_bar. It prints length, foot and kinetic energy every 10 us; in the end the rod is 21.42 mm long and
// its foot 7.22 mm in radius, which is what other codes find (docs/verification.md), within 1.5 %.
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  Metal<double, Bilinear<double>> copper;
  copper.name = "copper";
  copper.density = 8930;
  copper.elasticity = {.young = 117e9, .poisson = 0.35};
  copper.flow = {.yield = 400e6, .hardening = 100e6};

  const ProjectileShape<double> rod{.nose = Nose::blunt, .diameter = 6.4e-3, .shank_length = 32.4e-3};
  const SymmetryPlanes planes = symmetry_planes(Extent::quarter);
  Nodes<double> nodes;
  auto body = add_hex_body<SelectiveReduced>(nodes, projectile_mesh(rod, 0.8e-3, Extent::quarter), copper, "rod");
  hold_on_planes(nodes, body.nodes, planes, 1e-9);
  for (Index n = 0; n < nodes.size(); ++n) {
    const bool at_wall = nodes.position[n][2] < 1e-9;
    if (at_wall) nodes.held[n] |= held_z;
    nodes.velocity[n][2] = at_wall ? 0 : -227;
  }
  Model model{std::move(nodes), std::tuple{std::move(body)}, planes};

  double length = 0, foot = 0;
  const RunOptions<double> until{.end_time = 80e-6, .observe_every = 10e-6};
  const auto result = run(model, until, [&](const auto &now, const Energy<double> &energy) {
    length = foot = 0;
    for (const Vec3<double> &x : now.nodes.position) {
      length = std::max(length, x[2]);
      foot = std::max(foot, std::hypot(x[0], x[1]));
    }
    std::printf("%4.0f us  length %6.3f mm  foot %5.3f mm  kinetic %7.2f J\n", now.time * 1e6, length * 1e3, foot * 1e3,
                energy.kinetic);
    return true;
  });
  const bool as_expected = std::abs(length / 21.42e-3 - 1) < 0.015 && std::abs(foot / 7.22e-3 - 1) < 0.015;
  return !result.fault && as_expected ? 0 : 1;
}
