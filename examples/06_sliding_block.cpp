// Sliding block: four masses slide over a slab at 20 m/s with friction 0.2, pressed down with 1e7 m/s2. A step is made
// of free functions, so that a force of one's own is one line between two of them.
// Run: 06_sliding_block. It prints way and heat of friction: v^2/(2 mu g) and all of the kinetic energy, to 1 %.
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  using namespace ogive;
  const double gravity = 1e7, friction = 0.2, speed = 20, mass = 1e-4; // m/s2, -, m/s, kg
  const double radius = 0.5e-3, dt = 1e-8;                             // of a mass, m; s

  HexMesh<double> slab; // 6 x 3 x 1 mm, its upper face at z = 0
  for (int a = 0; a < 8; ++a)
    slab.positions.emplace_back(hex_corner<double>(a).cwiseProduct(Vec3<double>(3e-3, 1.5e-3, 0.5e-3)) -
                                Vec3<double>(0, 0, 0.5e-3));
  slab.hexes = {{0, 1, 2, 3, 4, 5, 6, 7}};
  Nodes<double> nodes;
  const NodeRange fixed = add_nodes(nodes, slab.positions);
  for (Index n = fixed.begin; n < fixed.end; ++n) nodes.mass[n] = 1, nodes.held[n] = held_all;

  const ContactOptions<double> options{.friction = friction};
  const double sinks = gravity * dt * dt / options.stiffness; // the penalty spring is 0.1 m/dt^2
  std::vector<Vec3<double>> corners;
  for (const double x : {-2e-3, -1e-3})
    for (const double y : {-0.5e-3, 0.5e-3}) corners.emplace_back(x, y, radius - sinks);
  const NodeRange block = add_nodes(nodes, corners);
  set_velocity(nodes, block, Vec3<double>(speed, 0, 0));
  std::vector<Index> slaves;
  for (Index n = block.begin; n < block.end; ++n) nodes.mass[n] = mass, slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), radius),
                              shifted(boundary_facets(slab), fixed.begin), "block on slab", options);

  const double start = nodes.position[block.begin][0];
  for (double time = 0; time < 12e-6; time += dt) {
    clear_forces(nodes);
    for (const Index n : slaves) nodes.force[n] = Vec3<double>(0, 0, -mass * gravity);
    add_contact_force(contact, nodes, dt, dt);
    integrate(nodes, dt, dt);
  }
  const double way = nodes.position[block.begin][0] - start, theory = speed * speed / (2 * friction * gravity);
  const double heat = friction_energy(contact), kinetic = 4 * 0.5 * mass * speed * speed;
  std::printf("way  %.4f mm, theory %.4f mm\nheat %.4f J, theory %.4f J\n", way * 1e3, theory * 1e3, heat, kinetic);
  return std::abs(way / theory - 1) < 0.01 && std::abs(heat / kinetic - 1) < 0.01 ? 0 : 1;
}
