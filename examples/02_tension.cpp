// One element in tension: a 1 mm cube of tool steel is pulled at 1000/s until its strain is 5 %. The step is written
// out: the upper face has a given speed, and a boundary condition of one's own is a line between two functions.
// Run: 02_tension. It prints strain, stress and the bilinear curve every 5 us; they agree within 1 %.
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const auto metal = library::arne_tool_steel<double>();
  const double young = metal.elasticity.young, tangent = 15e9, yield = metal.flow.yield; // Pa
  const double rate = 1000, edge = 1e-3;                                                 // 1/s, m

  HexMesh<double> mesh; // corner 0 at the origin
  for (int a = 0; a < 8; ++a) mesh.positions.emplace_back(0.5 * edge * (hex_corner<double>(a) + Vec3<double>::Ones()));
  mesh.hexes = {{0, 1, 2, 3, 4, 5, 6, 7}};
  Nodes<double> nodes;
  auto cube = add_hex_body(nodes, mesh, metal, "cube");
  hold_on_planes(nodes, cube.nodes, {.x = true, .y = true}, 1e-9);
  for (Index n = 0; n < nodes.size(); ++n) {
    const Vec3<double> x = nodes.position[n];
    const double narrowing = -metal.elasticity.poisson * rate;
    nodes.velocity[n] = {narrowing * x[0], narrowing * x[1], rate * x[2]};
    if (x[2] < 1e-9) nodes.held[n] |= held_z;
  }

  double worst = 0, before = 0, time = 0, next = 5e-6; // s
  const double dt = 0.5 * stable_time_step(cube, nodes);
  while (time < 50e-6) {
    clear_forces(nodes);
    velocity_gradient(cube, nodes);
    update_stress(cube, before);
    add_internal_force(cube, nodes, before);
    if (time >= next) {
      const double strain = std::log(nodes.position[4][2] / edge), computed = stress(load(cube.points, 0)).zz;
      const double theory = std::min(young * strain, yield + tangent * (strain - yield / young));
      std::printf("strain %6.4f  stress %6.1f MPa  theory %6.1f MPa\n", strain, computed * 1e-6, theory * 1e-6);
      worst = std::max(worst, std::abs(computed / theory - 1));
      next += 5e-6;
    }
    for (Index n = 4; n < 8; ++n) nodes.force[n][2] = 0; // the upper face keeps its speed
    integrate(nodes, dt, dt);
    time += dt, before = dt;
  }
  return worst < 0.01 ? 0 : 1;
}
