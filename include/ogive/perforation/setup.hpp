// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_force.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/material/any_flow_law.hpp"
#include "ogive/material/library.hpp"
#include "ogive/mesh/facets.hpp"
#include "ogive/mesh/projectile.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/perforation/part_contacts.hpp"
#include "ogive/perforation/plates.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sim/run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ogive {

/// A model of plates with the flow law `Law` and a projectile with `ShotLaw`.
template <class T, class Law, class Kernel, class Form, class Rule, class ShotLaw = Bilinear<T>>
using PerforationModel =
    Model<T, PerforationBodies<SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>, HexBody<T, ShotLaw, Rule>>>;

/// A perforation model whose flow laws, kernel, form and rule are chosen when the program runs: one type for all cases.
template <class T>
using AnyPerforationModel = PerforationModel<T, AnyFlowLaw<T>, AnyKernel, AnyForm, AnyRule, AnyFlowLaw<T>>;

/// The particles of a plate: of the only one, or of the `layer`-th from the front, from 0.
template <class M> auto &plate_particles(M &model, std::size_t layer = 0) {
  return model.bodies.plate_particles[layer];
}
/// The hexes of a plate: around its particles, or all of it.
template <class M> auto &plate_hexes(M &model, std::size_t layer = 0) { return model.bodies.plate_hexes[layer]; }
/// A part of the projectile: the only one, or the first. Tied parts have the nodes of the whole projectile, parts that
/// touch have their own, one after the other.
template <class M> auto &projectile(M &model, std::size_t part = 0) { return model.bodies.projectile[part]; }

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

/// Mass of the projectile, kg, of the whole model.
template <class M> auto projectile_mass(const M &model) {
  auto mass = whole_mass(projectile(model).point_mass, model.symmetry);
  for (std::size_t k = 1; k < model.bodies.projectile.size(); ++k)
    mass += whole_mass(projectile(model, k).point_mass, model.symmetry);
  return mass;
}

/// Raises the stable time step of thin hexes of the parts of a body towards `dt` (s) by adding mass to their nodes, as
/// far as `largest` (kg) allows.
template <class T, class Body> void raise_time_step_within(std::vector<Body> &parts, Nodes<T> &nodes, T dt, T largest) {
  for (;; dt *= T(0.8)) {
    std::vector<Body> heavier = parts;
    Nodes<T> loaded = nodes;
    T added{};
    for (Body &part : heavier) added += raise_time_step(part, loaded, dt);
    if (added > largest) continue;
    parts = std::move(heavier);
    nodes = std::move(loaded);
    return;
  }
}

/// Height of the centre of a mesh's volume above z = 0, m.
template <class T> T centre_height(const HexMesh<T> &mesh) {
  T whole{}, moment{};
  for (Index e = 0; e < static_cast<Index>(mesh.hexes.size()); ++e) {
    const Corners<T> x = corners(mesh, e);
    const T part = hex_volume<T>(x);
    whole += part, moment += part * x.col(2).mean();
  }
  return moment / whole;
}

/// Turns a projectile's mesh, which points to -z with its tip at z = 0, into its axis at the start, with its centre on
/// the line of flight through the middle of the plate, and draws it back along that line until it touches the plane
/// z = 0 from above.
template <class T> HexMesh<T> in_line_of_flight(HexMesh<T> mesh, const PerforationCase<T> &c) {
  const bool tilted = c.pitch != T(0) || c.yaw != T(0);
  if (c.obliquity == T(0) && !tilted) return mesh;
  const Vec3<T> flight = direction_of_flight(c);
  const T s = std::sin(c.obliquity + c.pitch), cosine = std::cos(c.obliquity + c.pitch);
  Vec3<T> shift = Vec3<T>::Zero();
  if (tilted) {
    const Vec3<T> centre = -centre_height(mesh) * direction_of_axis(c);
    shift = flight * flight.dot(centre) - centre;
    for (Vec3<T> &p : mesh.positions)
      p = Vec3<T>(p[0], std::cos(c.yaw) * p[1] - std::sin(c.yaw) * p[2],
                  std::sin(c.yaw) * p[1] + std::cos(c.yaw) * p[2]);
  }
  T lowest = tilted ? std::numeric_limits<T>::max() : T(0);
  for (Vec3<T> &p : mesh.positions) {
    p = Vec3<T>(cosine * p[0] - s * p[2], p[1], s * p[0] + cosine * p[2]);
    if (tilted) p += shift;
    lowest = std::min(lowest, p[2]);
  }
  for (Vec3<T> &p : mesh.positions) p += lowest / -flight[2] * flight;
  return mesh;
}

/// Volume that the density of a projectile of given mass refers to, m3: that of its shape, which the hexes of the
/// paper's projectiles have to 0.1 %, or of the hexes themselves.
template <class T> T reference_volume(const PerforationCase<T> &c, const HexMesh<T> &mesh) {
  const auto &noses = paper_noses;
  const bool of_shape = std::find(noses.begin(), noses.end(), c.projectile.nose) != noses.end() &&
                        c.projectile.tail_length == T(0) && c.projectile.inner.empty();
  return of_shape ? volume(c.projectile) : T(symmetry_planes(c.extent).copies()) * volume(mesh);
}

/// The metals of the parts with the densities that give the projectile of a case its target mass: all densities change
/// by the same factor.
template <class T, class Law>
std::vector<Metal<T, Law>> metals_of_mass(std::vector<Metal<T, Law>> metals, const PerforationCase<T> &c,
                                          const PartMesh<T> &body) {
  if (c.projectile_mass == T(0)) return metals;
  if (metals.size() == 1) {
    metals.front().density = c.projectile_mass / reference_volume(c, body.mesh);
    return metals;
  }
  T mass{};
  const std::vector<T> volumes = part_volumes(body);
  for (std::size_t k = 0; k < metals.size(); ++k) mass += metals[k].density * volumes[k];
  const T factor = c.projectile_mass / (T(symmetry_planes(c.extent).copies()) * mass);
  for (auto &metal : metals) metal.density *= factor;
  return metals;
}

/// Throws SetupError unless the sizes of a case fit together.
template <class T> void check(const PerforationCase<T> &c) {
  check(c.projectile);
  check_parts(c);
  require(std::isfinite(c.projectile_mass) && c.projectile_mass >= T(0), "projectile's mass (kg)", c.projectile_mass,
          "must be positive, or 0 for that of its metal");
  require(c.obliquity >= T(0) && c.obliquity <= T(1.05), "obliquity (rad)", c.obliquity, "must lie between 0 and 1.05");
  require(c.obliquity == T(0) || c.extent != Extent::quarter, "obliquity (rad)", c.obliquity,
          "must be 0 in a quarter model");
  constexpr T most_tilt = T(0.79);
  require(std::abs(c.pitch) <= most_tilt, "pitch (rad)", c.pitch, "must lie between -0.79 and 0.79");
  require(std::abs(c.yaw) <= most_tilt, "yaw (rad)", c.yaw, "must lie between -0.79 and 0.79");
  require(c.pitch == T(0) || c.extent != Extent::quarter, "pitch (rad)", c.pitch, "must be 0 in a quarter model");
  require(c.yaw == T(0) || c.extent == Extent::full, "yaw (rad)", c.yaw, "must be 0 but in a full model");
  require(c.sph_radius > T(0.5) * c.projectile.diameter, "radius of the particle disc (m)", c.sph_radius,
          "must be larger than the projectile's");
  const bool straight = c.obliquity == T(0) && c.pitch == T(0) && c.yaw == T(0);
  require(straight || c.sph_radius >= least_sph_radius(c), "radius of the particle disc (m)", c.sph_radius,
          "must leave room for the oblique projectile, at least " + std::to_string(least_sph_radius(c)));
  require(c.clamp_radius > c.sph_radius, "clamp radius (m)", c.clamp_radius,
          "must be larger than that of the particle disc");
  require(c.behind.size() < most_layers, "number of plates", c.behind.size() + 1,
          "must be 1 to " + std::to_string(most_layers));
  for (std::size_t k = 0; k < c.behind.size(); ++k) {
    const std::string plate = "plate " + std::to_string(k + 2);
    require(std::isfinite(c.behind[k].gap) && c.behind[k].gap >= T(0), "gap before " + plate + " (m)", c.behind[k].gap,
            "must not be negative");
    require(std::isfinite(c.behind[k].thickness) && c.behind[k].thickness > T(0), "thickness of " + plate + " (m)",
            c.behind[k].thickness, "must be positive");
  }
  require(std::isfinite(c.initial_velocity) && c.initial_velocity > T(0), "initial velocity (m/s)", c.initial_velocity,
          "must be positive");
}

/// Adds the projectile, which touches the first plate and flies at it: a body for each part, all on the same nodes, or
/// on their own if parts touch.
template <class Rule, class T, class Law>
std::vector<HexBody<T, Law, Rule>> add_projectile(Nodes<T> &nodes, const PerforationCase<T> &c, const PartMesh<T> &body,
                                                  const std::vector<Metal<T, Law>> &metals,
                                                  const HexOptions<T> &options, T tolerance, Rule rule) {
  require(metals.size() == body.parts.size(), "number of the projectile's metals", metals.size(),
          "must be " + std::to_string(body.parts.size()) + ", one for each part");
  const auto heavy = metals_of_mass(metals, c, body);
  std::vector<HexBody<T, Law, Rule>> parts;
  if (metals.size() == 1) {
    parts.push_back(add_hex_body<Rule>(nodes, body.mesh, heavy.front(), "projectile", options, rule));
  } else if (c.parts == Parts::touching) {
    for (std::size_t k = 0; k < metals.size(); ++k) {
      const auto own = without_hexes(body, [&](Index e) { return body.part_of[e] != k; });
      parts.push_back(add_hex_body<Rule>(nodes, own.mesh, heavy[k], "projectile_" + body.parts[k], options, rule));
    }
  } else {
    const NodeRange range = add_nodes(nodes, body.mesh.positions);
    for (std::size_t k = 0; k < metals.size(); ++k) {
      Nodes<T> own;
      auto &part = parts.emplace_back(
          add_hex_body<Rule>(own, mesh_of_part(body, k), heavy[k], "projectile_" + body.parts[k], options, rule));
      part.nodes = range;
      for (auto &hex : part.hexes)
        for (Index &n : hex) n += range.begin;
      for (Index n = 0; n < range.size(); ++n) nodes.mass[range.begin + n] += own.mass[n];
    }
  }
  const NodeRange range{parts.front().nodes.begin, parts.back().nodes.end};
  hold_on_planes(nodes, range, symmetry_planes(c.extent), tolerance);
  set_velocity(nodes, range, Vec3<T>(c.initial_velocity * direction_of_flight(c)));
  return parts;
}

/// Builds the model of a case with a metal for each plate, from front to rear: each clamped at its outer radius, a disc
/// of particles tied to a rim of hexes; and a projectile, with a metal for each part, that touches the first plate and
/// flies towards -z. Plates touch each other without friction. Throws SetupError for sizes that do not fit together.
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class Rule = OnePoint, class T, class Law,
          class ShotLaw>
PerforationModel<T, Law, Kernel, Form, Rule, ShotLaw>
make_perforation(const PerforationCase<T> &c, const std::vector<Metal<T, Law>> &metals,
                 const std::vector<Metal<T, ShotLaw>> &projectile_metals, PerforationOptions<T> options = {},
                 const Discretisation<Kernel, Form, Rule> &parts = {}) {
  check(c);
  const std::size_t layers = 1 + c.behind.size();
  require(metals.size() == layers, "number of the plates' metals", metals.size(),
          "must be " + std::to_string(layers) + ", one for each plate");
  const SymmetryPlanes planes = symmetry_planes(c.extent);
  Nodes<T> nodes;
  auto plates = add_plates_of_particles(nodes, c, metals, options, parts);
  auto &[particles, hexes, facets] = plates;
  const T spacing = particles.front().spacing, tolerance = T(1e-3) * spacing;
  for (const auto &body : hexes) {
    hold_on_planes(nodes, body.nodes, planes, tolerance);
    clamp_at_radius(nodes, body.nodes, c.clamp_radius);
  }

  PartMesh<T> shot_body = projectile_body(c, spacing);
  shot_body.mesh = in_line_of_flight(std::move(shot_body.mesh), c);
  auto shot = add_projectile(nodes, c, shot_body, projectile_metals, options.hex, tolerance, parts.rule);
  T step_of_particles = std::numeric_limits<T>::max(), step_of_contact = step_of_particles;
  for (const auto &body : particles) {
    step_of_particles = std::min(step_of_particles, stable_time_step(body, nodes));
    step_of_contact = std::min(step_of_contact, options.contact_courant * body.spacing / sound_speed(body.metal));
  }
  if (!c.rigid_projectile) {
    T mass{};
    for (const auto &part : shot) mass += whole_mass(part.point_mass, {});
    raise_time_step_within(shot, nodes, step_of_particles, options.largest_added_mass * mass);
  }

  Slaves<T> slaves;
  for (const auto &body : particles) add_slaves(slaves, body.nodes, T(0.5) * body.spacing);
  for (const auto &body : hexes) add_slaves(slaves, body.nodes, T(0));
  const ContactOptions<T> surface{.friction = c.friction,
                                  .stiffness = options.contact_stiffness,
                                  .rigid_masters = c.rigid_projectile,
                                  .reentrant = c.projectile.is_hollow || c.projectile.nose == Nose::mesh ||
                                               c.parts == Parts::touching};
  auto contact = make_contact(
      nodes, std::move(slaves.nodes), std::move(slaves.offset),
      shifted(facets_of_parts(contact_facets(shot_body.mesh, c.extent), shot_body), shot.front().nodes.begin),
      "plate on projectile", surface, planes);
  contact.state.reference_time_step = step_of_contact;
  std::vector<NodeToSurface<T>> contacts{std::move(contact)};
  if (c.parts == Parts::touching && shot.size() > 1) add_part_contacts(contacts, nodes, shot, c.part_friction);
  if (c.erosion && !c.rigid_projectile)
    allow_erosion(contacts, shot, static_cast<Index>(particles.size() + hexes.size()));
  std::vector<ParticleContact<T>> particle_contacts;
  if (layers > 1) {
    add_rim_contacts(contacts, nodes, particles, hexes, facets, c.sph_radius);
    particle_contacts.push_back(make_disc_contact(
        nodes, c, particles, options.contact_stiffness / (options.contact_courant * options.contact_courant)));
  }
  std::vector<Tie<T>> ties;
  for (std::size_t k = 0; k < facets.size(); ++k)
    ties.push_back(make_tie(nodes, particles[k].nodes, facets[k].edge, hexes[k].hexes, particles[k].spacing));

  PerforationModel<T, Law, Kernel, Form, Rule, ShotLaw> model{
      std::move(nodes), {std::move(particles), std::move(hexes), std::move(shot)}, planes};
  model.contacts = std::move(contacts);
  model.particle_contacts = std::move(particle_contacts);
  model.ties = std::move(ties);
  if (c.rigid_projectile) model.rigid_parts.push_back(make_rigid_part(model.nodes, projectile(model).nodes));
  return model;
}

///@{
/// The model of a case with one metal for the projectile, and with one for all plates as well.
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class Rule = OnePoint, class T, class Law,
          class ShotLaw>
PerforationModel<T, Law, Kernel, Form, Rule, ShotLaw>
make_perforation(const PerforationCase<T> &c, const std::vector<Metal<T, Law>> &metals,
                 const Metal<T, ShotLaw> &projectile_metal, PerforationOptions<T> options = {},
                 const Discretisation<Kernel, Form, Rule> &parts = {}) {
  return make_perforation(c, metals, std::vector{projectile_metal}, options, parts);
}
template <class Kernel = CubicSpline, class Form = RenormalisedForm, class Rule = OnePoint, class T, class Law,
          class ShotLaw>
PerforationModel<T, Law, Kernel, Form, Rule, ShotLaw>
make_perforation(const PerforationCase<T> &c, const Metal<T, Law> &plate, const Metal<T, ShotLaw> &projectile_metal,
                 PerforationOptions<T> options = {}, const Discretisation<Kernel, Form, Rule> &parts = {}) {
  return make_perforation(c, std::vector(1 + c.behind.size(), plate), std::vector{projectile_metal}, options, parts);
}
///@}

/// The model of a case with the choices of a method: lattice, damage and bands of shear of the plates, numerical
/// choices; and its friction on a sharp nose for which the case has none.
template <class T, class Law, class ShotLaw>
PerforationModel<T, Law, CubicSpline, RenormalisedForm, OnePoint, ShotLaw>
make_perforation(Method method, PerforationCase<T> c, const Metal<T, Law> &plate,
                 const Metal<T, ShotLaw> &projectile_metal) {
  const MethodChoices<T> choices = choices_of<T>(method);
  c.lattice = choices.lattice;
  if (c.friction == T(0) && is_sharp(c.projectile)) c.friction = choices.sharp_friction;
  return make_perforation(c, with_damage_of(method, plate), projectile_metal, choices.numerics);
}

} // namespace ogive
