// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fem/hex_force.hpp"
#include "ogive/mesh/plate_mesh.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/perforation/plates.hpp"
#include "ogive/sim/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

/// \file
/// A plate that is made of hexes, which turn into particles where they fail.

namespace ogive {

/// A plate of hexes that is clamped at its outer radius. The first of them, in the middle of which the particles lie,
/// are those within the radius of the disc; the particles have their mass as well until begin_conversion().
template <class Kernel, class Form, class Rule, class T, class Law>
Plates<SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>>
add_plate_of_hexes(Nodes<T> &nodes, const PerforationCase<T> &c, Metal<T, Law> metal,
                   const PerforationOptions<T> &options, const Discretisation<Kernel, Form, Rule> &parts) {
  PlateShapeOfHexes<T> shape;
  shape.struck_radius = T(0.5) * c.projectile.diameter;
  shape.fine_radius = std::min(options.fine_radius_ratio * shape.struck_radius, c.sph_radius);
  shape.outer_radius = c.clamp_radius;
  shape.thickness = c.thickness;
  shape.size = c.spacing;
  HexMesh<T> mesh = plate_mesh(shape, c.extent);
  const auto middle = [&](const std::array<Index, 8> &hex) {
    Vec3<T> sum = Vec3<T>::Zero();
    for (const Index n : hex) sum += mesh.positions[n];
    return Vec3<T>(T(0.125) * sum);
  };
  const auto far = std::stable_partition(mesh.hexes.begin(), mesh.hexes.end(), [&](const auto &hex) {
    const Vec3<T> x = middle(hex);
    return std::hypot(x[0], x[1]) < c.sph_radius;
  });
  ParticleLayout<T> layout;
  layout.spacing = c.thickness / T(layers(shape));
  for (Index e = 0; e < static_cast<Index>(far - mesh.hexes.begin()); ++e) {
    layout.positions.push_back(middle(mesh.hexes[e]));
    layout.volumes.push_back(hex_volume<T>(corners(mesh, e)));
  }
  // Failed metal bears pressure only. A failed hex bears nothing, until it is a particle.
  metal.damage.effect = FailureEffect::no_tension;
  Plates<SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>> plates;
  plates.particles.push_back(add_sph_body<Kernel, Form>(nodes, layout, metal, "disc", symmetry_planes(c.extent),
                                                        options.sph, parts.kernel, parts.form));
  metal.damage = regularised(metal.damage, layout.spacing);
  metal.damage.effect = FailureEffect::removal;
  plates.hexes.push_back(add_hex_body<Rule>(nodes, mesh, metal, "plate", options.plate_hex, parts.rule));
  return plates;
}

/// Lets the hexes of a plate turn into particles: its own contact, between what shows of the hexes and the particles,
/// and the conversion.
template <class M, class T> void add_conversion(M &model, const PerforationOptions<T> &options) {
  Conversion<T> conversion;
  const auto &particles = model.bodies.plate_particles[conversion.plate];
  const auto &hexes = model.bodies.plate_hexes[conversion.plate];
  conversion.options = options.conversion;
  conversion.neighbours = face_neighbours(hexes.hexes, model.nodes, model.symmetry);
  std::vector<Index> slaves(particles.nodes.size());
  std::iota(slaves.begin(), slaves.end(), particles.nodes.begin);
  auto contact = make_contact(
      model.nodes, std::move(slaves), std::vector<T>(particles.nodes.size(), T(0.5) * particles.spacing),
      exposed_facets(hexes.hexes, conversion.neighbours, [](Index) { return false; }), "particles on plate",
      ContactOptions<T>{.stiffness = options.contact_stiffness, .may_bury = true}, model.symmetry);
  contact.state.reference_time_step = model.contacts.front().state.reference_time_step;
  conversion.surface = model.contacts.size();
  model.contacts.push_back(std::move(contact));
  begin_conversion(conversion, model);
  model.conversions.push_back(std::move(conversion));
}

} // namespace ogive
