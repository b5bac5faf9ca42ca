// Tied bar: one half of particles, the other of hexes, tied to each other. It flies and is caught at the hexes' end;
// momentum changes sign after L/c (see 03_wave) only if the wave passes the tie.
// Run: 05_tied_bar. It prints the time, within 2 % of L/c, and the change of the total energy.
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const auto metal = library::arne_tool_steel<double>();
  const double half = 20e-3, radius = 3e-3, spacing = 0.5e-3, speed = 1; // m, m/s

  Nodes<double> nodes; // particles below z = 0, hexes above
  auto particles = add_sph_body(nodes, ring_disc(DiscShape<double>{radius, half, spacing}, Extent::full), metal, "sph");
  const auto mesh =
      projectile_mesh(ProjectileShape<double>{Nose::blunt, 2 * radius, half, 0, 0}, spacing, Extent::full);
  auto hexes = add_hex_body(nodes, mesh, metal, "hexes");
  for (Index n = 0; n < nodes.size(); ++n) {
    nodes.held[n] = held_x | held_y;
    nodes.velocity[n][2] = -speed;
    if (nodes.position[n][2] > half - 1e-9) nodes.held[n] = held_all, nodes.velocity[n].setZero();
  }

  // Particles within one distance of the hexes' face follow it; their mass goes to the hexes' nodes.
  const auto at_joint = [](const Vec3<double> &x) { return std::abs(x[2]) < 1e-9; };
  const auto face = shifted(facets_where(boundary_facets(mesh), mesh.positions, at_joint), hexes.nodes.begin);
  auto tie = make_tie(nodes, particles.nodes, face, hexes.hexes, spacing);
  Model model{std::move(nodes), std::tuple{std::move(particles), std::move(hexes)}, SymmetryPlanes{}};
  model.ties.push_back(std::move(tie));

  double turned_at = 0, time_before = 0, momentum_before = momentum(model)[2], error = 0;
  const double energy_at_start = total(energy(model));
  const RunOptions<double> until{.end_time = 15e-6, .observe_every = 0.2e-6};
  const auto result = run(model, until, [&](const auto &now, const Energy<double> &energy) {
    const double time = now.time - 0.5 * now.last_step, p = momentum(now)[2];
    if (momentum_before < 0 && p >= 0)
      turned_at = time_before + (time - time_before) * momentum_before / (momentum_before - p);
    time_before = time, momentum_before = p;
    error = std::max(error, std::abs(total(energy) / energy_at_start - 1));
    return turned_at == 0;
  });
  const double theory = 2 * half / sound_speed(metal);
  std::printf("turned after %.3f us, L/c is %.3f us, energy within %.2g\n", turned_at * 1e6, theory * 1e6, error);
  return !result.fault && std::abs(turned_at / theory - 1) < 0.02 && error < 0.005 ? 0 : 1;
}
