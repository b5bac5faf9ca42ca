// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/facets.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/fem/plate_rim.hpp"
#include "ogive/fem/projectile.hpp"
#include "ogive/material/library.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/sph/layout.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace ogive {

/// Numerical choices of a perforation model; the defaults are the same for all cases.
template <class T> struct PerforationOptions {
  SphOptions<T> sph{};            ///< of the disc
  HexOptions<T> hex{};            ///< of rim and projectile
  T rim_size_ratio = T(2.5);      ///< hex size at the disc's edge over the particle distance
  T contact_stiffness = T(0.1);   ///< penalty over m/dt^2
  T contact_courant = T(0.4);     ///< of the time step dt that the contact's stiffness is made for
  T largest_added_mass = T(0.01); ///< of the projectile's mass, allowed to raise the time step of thin hexes at a tip
};

/// The bodies of a perforation model: disc of particles, rim of hexes, projectile of hexes.
template <class T, class Law, class Kernel, class Form, class Rule>
using PerforationModel = Model<T, SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>, HexBody<T, Bilinear<T>, Rule>>;

/// The particles in the middle of the plate.
template <class M> auto &disc(M &model) { return std::get<0>(model.bodies); }
/// The hexes around them.
template <class M> auto &rim(M &model) { return std::get<1>(model.bodies); }
/// The projectile.
template <class M> auto &projectile(M &model) { return std::get<2>(model.bodies); }

/// Holds the nodes of a range at `radius` (m) from the z axis or beyond in all directions.
template <class T> void clamp_at_radius(Nodes<T> &nodes, NodeRange range, T radius) {
  for (Index n = range.begin; n < range.end; ++n)
    if (std::hypot(nodes.position[n][0], nodes.position[n][1]) >= radius * (T(1) - T(1e-6))) nodes.held[n] = held_all;
}

/// Mass of a body's points in the whole model, kg.
template <class T> T whole_mass(const std::vector<T> &point_mass, SymmetryPlanes symmetry) {
  T mass{};
  for (T m : point_mass) mass += m;
  return T(symmetry.copies()) * mass;
}

/// Raises the stable time step of thin hexes towards `dt` (s) by adding mass to their nodes, as far as `largest` (kg)
/// allows.
template <class T, class Body> void raise_time_step_within(Body &body, Nodes<T> &nodes, T dt, T largest) {
  for (;; dt *= T(0.8)) {
    Body heavier = body;
    Nodes<T> loaded = nodes;
    if (raise_time_step(heavier, loaded, dt) > largest) continue;
    body = std::move(heavier);
    nodes = std::move(loaded);
    return;
  }
}

/// Turns a projectile's mesh, which points to -z with its tip at z = 0, into the line of flight, and draws it back
/// along that line until it touches the plane z = 0 from above.
template <class T> HexMesh<T> in_line_of_flight(HexMesh<T> mesh, const PerforationCase<T> &c) {
  if (c.obliquity == T(0)) return mesh;
  const Vec3<T> flight = direction_of_flight(c);
  const T s = flight[0], cosine = -flight[2];
  T lowest{};
  for (Vec3<T> &p : mesh.positions) {
    p = Vec3<T>(cosine * p[0] - s * p[2], p[1], s * p[0] + cosine * p[2]);
    lowest = std::min(lowest, p[2]);
  }
  for (Vec3<T> &p : mesh.positions) p += lowest / cosine * flight;
  return mesh;
}

/// The metal with the density that gives the projectile of a case the mass that is asked for.
template <class T> Metal<T, Bilinear<T>> metal_of_mass(Metal<T, Bilinear<T>> metal, const PerforationCase<T> &c) {
  if (c.projectile_mass != T(0)) metal.density = c.projectile_mass / volume(c.projectile);
  return metal;
}

/// Throws SetupError unless the sizes of a case fit together.
template <class T> void check(const PerforationCase<T> &c) {
  check(c.projectile);
  require(std::isfinite(c.projectile_mass) && c.projectile_mass >= T(0), "projectile's mass (kg)", c.projectile_mass,
          "must be positive, or 0 for that of its metal");
  require(c.obliquity >= T(0) && c.obliquity <= T(1.05), "obliquity (rad)", c.obliquity, "must lie between 0 and 1.05");
  require(c.obliquity == T(0) || c.extent != Extent::quarter, "obliquity (rad)", c.obliquity,
          "must be 0 in a quarter model");
  require(c.sph_radius > T(0.5) * c.projectile.diameter, "radius of the particle disc (m)", c.sph_radius,
          "must be larger than the projectile's");
  require(c.obliquity == T(0) || c.sph_radius >= least_sph_radius(c), "radius of the particle disc (m)", c.sph_radius,
          "must leave room for the oblique projectile, at least " + std::to_string(least_sph_radius(c)));
  require(c.clamp_radius > c.sph_radius, "clamp radius (m)", c.clamp_radius,
          "must be larger than that of the particle disc");
  require(std::isfinite(c.initial_velocity) && c.initial_velocity > T(0), "initial velocity (m/s)", c.initial_velocity,
          "must be positive");
}

/// Builds the model of a case: a disc of particles tied to a rim of hexes that is clamped at its outer radius, and a
/// projectile that touches the plate and flies towards -z. Throws SetupError for sizes that do not fit together.
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class Rule = OnePoint, class T, class Law>
PerforationModel<T, Law, Kernel, Form, Rule> make_perforation(const PerforationCase<T> &c, const Metal<T, Law> &plate,
                                                              const Metal<T, Bilinear<T>> &projectile_metal,
                                                              PerforationOptions<T> options = {}) {
  check(c);
  const SymmetryPlanes planes = symmetry_planes(c.extent);
  const DiscShape<T> disc_shape{c.sph_radius, c.thickness, c.spacing};
  const ParticleLayout<T> layout =
      c.lattice == Lattice::cubic ? cubic_disc(disc_shape, c.extent) : ring_disc(disc_shape, c.extent);

  Nodes<T> nodes;
  auto particles = add_sph_body<Kernel, Form>(nodes, layout, plate, "disc", planes, options.sph);

  RimShape<T> rim_shape;
  rim_shape.inner_radius = c.sph_radius;
  rim_shape.outer_radius = c.clamp_radius;
  rim_shape.thickness = c.thickness;
  rim_shape.inner_size = options.rim_size_ratio * layout.spacing;
  const HexMesh<T> mesh_of_rim = rim_mesh(rim_shape, c.extent);
  auto rim_hexes = add_hex_body<Rule>(nodes, mesh_of_rim, plate, "rim", options.hex);
  const T tolerance = T(1e-3) * layout.spacing;
  hold_on_planes(nodes, rim_hexes.nodes, planes, tolerance);
  clamp_at_radius(nodes, rim_hexes.nodes, c.clamp_radius);

  const HexMesh<T> shot_mesh = in_line_of_flight(projectile_mesh(c.projectile, layout.spacing, c.extent), c);
  auto shot = add_hex_body<Rule>(nodes, shot_mesh, metal_of_mass(projectile_metal, c), "projectile", options.hex);
  hold_on_planes(nodes, shot.nodes, planes, tolerance);
  set_velocity(nodes, shot.nodes, Vec3<T>(c.initial_velocity * direction_of_flight(c)));
  if (!c.rigid_projectile)
    raise_time_step_within(shot, nodes, stable_time_step(particles, nodes),
                           options.largest_added_mass * whole_mass(shot.point_mass, {}));

  std::vector<Index> slaves;
  std::vector<T> offset;
  for (Index n = particles.nodes.begin; n < particles.nodes.end; ++n)
    slaves.push_back(n), offset.push_back(T(0.5) * layout.spacing);
  for (Index n = rim_hexes.nodes.begin; n < rim_hexes.nodes.end; ++n) slaves.push_back(n), offset.push_back(T(0));
  auto contact = make_contact(nodes, std::move(slaves), std::move(offset),
                              shifted(contact_facets(shot_mesh, c.extent), shot.nodes.begin), "plate on projectile",
                              ContactOptions<T>{.friction = c.friction,
                                                .stiffness = options.contact_stiffness,
                                                .rigid_masters = c.rigid_projectile},
                              planes);
  contact.reference_time_step = options.contact_courant * layout.spacing / sound_speed(plate);
  const auto edge = shifted(inner_facets(mesh_of_rim, rim_shape), rim_hexes.nodes.begin);
  auto tie = make_tie(nodes, particles.nodes, edge, rim_hexes.hexes, layout.spacing);

  PerforationModel<T, Law, Kernel, Form, Rule> model{
      std::move(nodes), std::tuple{std::move(particles), std::move(rim_hexes), std::move(shot)}, planes};
  model.contacts.push_back(std::move(contact));
  model.ties.push_back(std::move(tie));
  if (c.rigid_projectile) model.rigid_parts.push_back({projectile(model).nodes});
  return model;
}

} // namespace ogive
