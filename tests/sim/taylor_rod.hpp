// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/blocks.hpp"

#include "ogive/mesh/projectile.hpp"
#include "ogive/sim/guard.hpp"
#include "ogive/sph/layout.hpp"

/// \file
/// A round rod that flies against a rigid wall without friction (Taylor's test), a quarter computed.

namespace sim_test {

/// A rod and how it strikes; SI units.
template <class Law> struct TaylorCase {
  Metal<double, Law> metal;
  double length, radius, speed;
  double end_time; ///< when the rod has come to rest
};

/// The copper rod of the code comparisons (e.g. Camacho & Ortiz 1997).
inline TaylorCase<Steel> copper_rod() {
  Metal<double, Steel> m;
  m.name = "copper";
  m.density = 8930;
  m.elasticity = {117e9, 0.35};
  m.flow = {400e6, 100e6};
  return {m, 32.4e-3, 3.2e-3, 227, 80e-6};
}

/// A rod after its impact; SI units.
struct Rod {
  bool finished = false; ///< at the end time, not before
  double length{};
  double foot{};             ///< radius within 1 mm of the wall
  double widest{};           ///< largest radius anywhere
  double error{};            ///< largest error of the energy, over the initial one
  double kinetic{};          ///< kinetic energy left, over the initial one
  double hourglass{};        ///< work of hourglass control, over the initial energy
  double least_hourglass{};  ///< its least value in time, over the initial energy: 0 unless it gives more than it took
  bool turned{};             ///< a facet of its surface has turned inside out; hexes only
  double greatest_strain{};  ///< plastic
  std::vector<double> radii; ///< of slices from the foot upwards
};

template <class M, class Law> Rod fly_against_wall(M &model, NodeRange range, const TaylorCase<Law> &c) {
  auto &nodes = model.nodes;
  for (Index n = range.begin; n < range.end; ++n) // what touches the wall is at rest
    nodes.velocity[n][2] = nodes.held[n] & held_z ? 0 : -c.speed;
  const double e = total(energy(model));
  Rod rod;
  const auto result =
      run(model, RunOptions<double>{.end_time = c.end_time, .observe_every = 1e-6}, [&](const auto &, const auto &now) {
        rod.error = std::max(rod.error, std::abs(total(now) / e - 1));
        rod.least_hourglass = std::min(rod.least_hourglass, now.hourglass / e);
        return true;
      });
  rod.finished = result.reason == StopReason::end_time;
  rod.kinetic = energy(model).kinetic / e;
  rod.hourglass = energy(model).hourglass / e;
  for_each_body(model, [&](const auto &body) {
    for (const double strain : body.points.plastic_strain) rod.greatest_strain = std::max(rod.greatest_strain, strain);
  });
  double low = 1, high = -1;
  for (Index n = range.begin; n < range.end; ++n) {
    low = std::min(low, nodes.position[n][2]);
    high = std::max(high, nodes.position[n][2]);
  }
  rod.length = high - low;
  constexpr int slices = 8;
  rod.radii.assign(slices, 0.0);
  for (Index n = range.begin; n < range.end; ++n) {
    const V &p = nodes.position[n];
    const double r = std::hypot(p[0], p[1]);
    const int slice = std::min(slices - 1, static_cast<int>((p[2] - low) / rod.length * slices));
    rod.radii[slice] = std::max(rod.radii[slice], r);
    // Particles at the edge of the foot curl up into a lip that reaches farther, see docs/verification.md.
    if (p[2] < low + 1e-3) rod.foot = std::max(rod.foot, r);
    rod.widest = std::max(rod.widest, r);
  }
  return rod;
}

/// A quarter of a rigid wall below z = 0: its nodes do not move.
struct RigidWall {
  std::vector<Facet> facets;
};

/// Adds a rigid wall to the nodes.
inline RigidWall add_wall(Nodes<double> &nodes, SymmetryPlanes planes) {
  const auto mesh = brick_at(1, 1, 1, V(20e-3, 20e-3, 5e-3), V(0, 0, -5e-3));
  const NodeRange wall = add_nodes(nodes, mesh.positions);
  for (Index n = wall.begin; n < wall.end; ++n) nodes.held[n] = held_all, nodes.mass[n] = 1;
  return {shifted(facets_off_planes(boundary_facets(mesh), mesh.positions, planes, 0.0), wall.begin)};
}

/// What keeps a rod of hexes off the wall.
enum class Foot {
  held,   ///< the nodes of its foot stay in the wall's plane, no others meet it
  touches ///< contact of all nodes of its surface
};

/// The rod of hexes of the size that suits particles `spacing` (m) apart, at the default options.
template <class Rule, class Law> Rod rod_of_hexes(const TaylorCase<Law> &c, double spacing, Foot foot = Foot::held) {
  Nodes<double> nodes;
  const ProjectileShape<double> shape{Nose::blunt, 2 * c.radius, c.length, 0, 0};
  const auto mesh = projectile_mesh(shape, spacing, Extent::quarter);
  auto rod = add_hex_body<Rule>(nodes, mesh, c.metal, "rod");
  const SymmetryPlanes planes = symmetry_planes(Extent::quarter);
  hold_on_planes(nodes, rod.nodes, planes, 1e-9);
  const NodeRange range = rod.nodes;
  NodeToSurface<double> skin;
  skin.name = "skin", skin.facets = facets_off_planes(boundary_facets(mesh), mesh.positions, planes, 1e-9);
  std::vector<NodeToSurface<double>> contacts;
  if (foot == Foot::held) {
    for (Index n = range.begin; n < range.end; ++n)
      if (nodes.position[n][2] < 1e-9) nodes.held[n] |= held_z;
  } else {
    const RigidWall wall = add_wall(nodes, planes);
    std::vector<Index> slaves;
    for (const Facet &facet : skin.facets) slaves.insert(slaves.end(), facet.nodes.begin(), facet.nodes.end());
    std::sort(slaves.begin(), slaves.end());
    slaves.erase(std::unique(slaves.begin(), slaves.end()), slaves.end());
    const std::vector<double> offset(slaves.size(), 0.0);
    contacts.push_back(make_contact(nodes, std::move(slaves), offset, wall.facets, "wall", {}, planes));
  }
  using Body = HexBody<double, Law, Rule>;
  Model<double, std::tuple<Body>> model{std::move(nodes), std::tuple<Body>(std::move(rod)), planes};
  model.contacts = std::move(contacts);
  Rod end = fly_against_wall(model, range, c);
  end.turned = first_turned(skin, std::get<0>(model.bodies), model.nodes) >= 0;
  return end;
}

/// The rod of particles `spacing` (m) apart, against a hex that does not move.
inline Rod rod_of_particles(const TaylorCase<Steel> &c, double spacing) {
  Nodes<double> nodes;
  const SymmetryPlanes planes = symmetry_planes(Extent::quarter);
  auto rod = add_sph_body(nodes, ring_disc(DiscShape<double>{c.radius, c.length, spacing}, Extent::quarter), c.metal,
                          "rod", planes);
  const double distance = rod.spacing;
  for (V &p : nodes.position) p[2] += c.length;
  const NodeRange range = rod.nodes;
  std::vector<Index> slaves;
  for (Index n = range.begin; n < range.end; ++n) slaves.push_back(n);
  const RigidWall wall = add_wall(nodes, planes);
  auto contact =
      make_contact(nodes, slaves, std::vector<double>(slaves.size(), distance / 2), wall.facets, "wall", {}, planes);
  Model<double, std::tuple<Sph>> model{std::move(nodes), std::tuple<Sph>(std::move(rod)), planes};
  model.contacts.push_back(std::move(contact));
  Rod end = fly_against_wall(model, range, c);
  end.length += distance; // from centres to surfaces
  for (double &r : end.radii) r += distance / 2;
  end.foot += distance / 2, end.widest += distance / 2;
  return end;
}

} // namespace sim_test
