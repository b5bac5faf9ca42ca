// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/node_to_surface.hpp"
#include "ogive/contact/particle_force.hpp"
#include "ogive/fem/hex_body.hpp"
#include "ogive/mesh/facets.hpp"
#include "ogive/mesh/plate_rim.hpp"
#include "ogive/perforation/case.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/sph/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// \file
/// The plates of a target and what acts between them.

namespace ogive {

/// Name of a plate's body: "disc" of the only plate, "disc_2" of the second of several.
inline std::string body_name(const char *body, std::size_t layer, std::size_t layers) {
  std::string name = body;
  if (layers > 1) name.append("_").append(std::to_string(layer + 1));
  return name;
}

/// The particles of a plate, the `number`-th from the front, from 0.
template <class T>
ParticleLayout<T> plate_layout(const PerforationCase<T> &c, const Layer<T> &layer, std::size_t number) {
  const DiscShape<T> shape{c.sph_radius, layer.thickness, c.spacing};
  ParticleLayout<T> layout = c.lattice == Lattice::cubic ? cubic_disc(shape, c.extent) : ring_disc(shape, c.extent);
  // Plates of equal thickness are disturbed differently.
  if (c.seed != 0) disturb(layout, shape, c.extent, c.seed + (std::uint64_t(number) << 32));
  for (Vec3<T> &p : layout.positions) p[2] -= layer.front;
  return layout;
}

/// The shape of a plate's rim with hexes of `inner_size` (m) at the disc.
template <class T> RimShape<T> rim_shape(const PerforationCase<T> &c, const Layer<T> &layer, T inner_size) {
  RimShape<T> shape;
  shape.inner_radius = c.sph_radius;
  shape.outer_radius = c.clamp_radius;
  shape.thickness = layer.thickness;
  shape.inner_size = inner_size;
  return shape;
}

/// Facets of a rim.
struct RimFacets {
  std::vector<Facet> edge; ///< at the disc
  std::vector<Facet> skin; ///< all that do not lie in a mirror plane
};

/// The facets of a rim whose nodes are numbered from `first_node`.
template <class T>
RimFacets facets_of_rim(const HexMesh<T> &rim, const RimShape<T> &shape, SymmetryPlanes planes, Index first_node) {
  const T tolerance = T(1e-6) * shape.thickness;
  return {shifted(inner_facets(rim, shape), first_node),
          shifted(facets_off_planes(boundary_facets(rim), rim.positions, planes, tolerance), first_node)};
}

/// All plates of a target.
template <class Particles, class Hexes> struct Plates {
  std::vector<Particles> particles; ///< of the struck part
  std::vector<Hexes> hexes;         ///< around them
  std::vector<RimFacets> facets;    ///< of the hexes
};

/// Adds plates with a disc of particles and a rim of hexes each; not tied and not held yet.
template <class Kernel, class Form, class Rule, class T, class Law>
Plates<SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>>
add_plates_of_particles(Nodes<T> &nodes, const PerforationCase<T> &c, const std::vector<Metal<T, Law>> &metals,
                        const PerforationOptions<T> &options, const Discretisation<Kernel, Form, Rule> &parts) {
  const std::vector<Layer<T>> layers = layers_of(c);
  const SymmetryPlanes planes = symmetry_planes(c.extent);
  Plates<SphBody<T, Law, Kernel, Form>, HexBody<T, Law, Rule>> plates;
  for (std::size_t k = 0; k < layers.size(); ++k)
    plates.particles.push_back(add_sph_body<Kernel, Form>(nodes, plate_layout(c, layers[k], k), metals[k],
                                                          body_name("disc", k, layers.size()), planes, options.sph,
                                                          parts.kernel, parts.form));
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const RimShape<T> shape = rim_shape(c, layers[k], options.rim_size_ratio * plates.particles[k].spacing);
    HexMesh<T> mesh = rim_mesh(shape, c.extent);
    plates.facets.push_back(facets_of_rim(mesh, shape, planes, nodes.size()));
    for (Vec3<T> &p : mesh.positions) p[2] -= layers[k].front;
    plates.hexes.push_back(
        add_hex_body<Rule>(nodes, mesh, metals[k], body_name("rim", k, layers.size()), options.hex, parts.rule));
  }
  return plates;
}

/// Nodes that a contact takes as slaves.
template <class T> struct Slaves {
  std::vector<Index> nodes; ///< their numbers
  std::vector<T> offset;    ///< m
};

/// Adds the nodes of a range, as spheres of radius `offset` (m).
template <class T> void add_slaves(Slaves<T> &slaves, NodeRange range, T offset) {
  const std::size_t count = slaves.nodes.size() + static_cast<std::size_t>(range.size());
  if (range.size() > 1) slaves.nodes.reserve(count), slaves.offset.reserve(count); // a contact keeps the arrays
  for (Index n = range.begin; n < range.end; ++n) slaves.nodes.push_back(n), slaves.offset.push_back(offset);
}

/// Adds a contact for each rim: neither particles of other plates nor the nodes of the next rim's front face may enter
/// it. Options and mirror planes are those of the first contact, but there is no friction. Nodes at the discs' radius
/// are left out: they would slide along the other rim's edge, and the discs hold them apart.
template <class T, class Disc, class Rim>
void add_rim_contacts(std::vector<NodeToSurface<T>> &contacts, const Nodes<T> &nodes, const std::vector<Disc> &discs,
                      const std::vector<Rim> &rims, const std::vector<RimFacets> &facets, T disc_radius) {
  const SymmetryPlanes symmetry = contacts.front().symmetry;
  const T reference_time_step = contacts.front().state.reference_time_step;
  const ContactOptions<T> options{.stiffness = contacts.front().options.stiffness};
  for (std::size_t k = 0; k < rims.size(); ++k) {
    Slaves<T> slaves;
    for (std::size_t other = 0; other < discs.size(); ++other)
      if (other != k) add_slaves(slaves, discs[other].nodes, T(0.5) * discs[other].spacing);
    if (k + 1 < rims.size()) {
      const NodeRange next = rims[k + 1].nodes;
      T front = nodes.position[next.begin][2];
      for (Index n = next.begin; n < next.end; ++n) front = std::max(front, nodes.position[n][2]);
      for (Index n = next.begin; n < next.end; ++n)
        if (const Vec3<T> &p = nodes.position[n]; p[2] == front && std::hypot(p[0], p[1]) > T(1.001) * disc_radius)
          add_slaves(slaves, {n, n + 1}, T(0));
    }
    contacts.push_back(make_contact(nodes, std::move(slaves.nodes), std::move(slaves.offset), facets[k].skin,
                                    "plates on " + rims[k].name, options, symmetry));
    contacts.back().state.reference_time_step = reference_time_step;
  }
}

/// The contact between the discs of a target; `stiffness` is that of its pressure over the softest metal's density
/// times its sound speed squared.
template <class T, class Disc>
ParticleContact<T> make_disc_contact(const Nodes<T> &nodes, const PerforationCase<T> &c, const std::vector<Disc> &discs,
                                     T stiffness) {
  std::vector<ContactBody<T>> bodies;
  T softest = std::numeric_limits<T>::max(), to_touch{};
  for (std::size_t k = 0; k < discs.size(); ++k) {
    const Disc &disc = discs[k];
    if (k > 0) to_touch += c.behind[k - 1].gap;
    ContactBody<T> body{disc.nodes, disc.point_mass, disc.spacing, to_touch};
    for (T &volume : body.volumes) volume /= disc.metal.density;
    bodies.push_back(std::move(body));
    const T speed = sound_speed(disc.metal);
    softest = std::min(softest, disc.metal.density * speed * speed);
  }
  return make_particle_contact(nodes, bodies, stiffness * softest, "plates on plates", discs.front().symmetry);
}

} // namespace ogive
