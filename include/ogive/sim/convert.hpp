// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/follow.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/body.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// Hexes that fail turn into particles.
///
/// A particle takes over the shares m_a that its hex has in the masses of its nodes: mass M = sum m_a, position
/// sum m_a x_a / M, velocity v = sum m_a v_a / M, so that mass, momentum and centre of mass stay. The kinetic energy of
/// the corners against each other, sum m_a v_a^2/2 - M v^2/2, is lost and booked. Density, temperature, plastic strain,
/// damage and internal energy stay; the stress that is left is the pressure of the density, if it presses. What the
/// hex had stored besides counts as dissipated, and the work against its hourglass forces stays booked there.
///
/// Nodes keep their velocity; one without a hex has no mass, and integrate() leaves it where it is.

namespace ogive {

/// Calls `f(particles, hexes)` with the two bodies of the plate of a conversion.
template <class P, class H, class S, class T, class F>
void with_bodies(PerforationBodies<P, H, S> &bodies, const Conversion<T> &conversion, F &&f) {
  f(bodies.plate_particles[conversion.plate], bodies.plate_hexes[conversion.plate]);
}

/// Nothing: only the plates of a perforation convert.
template <class... Bodies, class T, class F> void with_bodies(std::tuple<Bodies...> &, const Conversion<T> &, F &&) {}

/// True if hex e has turned into a particle.
template <class Particles> bool is_converted(const Particles &particles, Index e) {
  return e < particles.points.size() && !is_unborn(particles, e);
}

/// True if hex e is about to lose its volume, is folded or so thin that alone it would hold up the time step, so that
/// it must go before it fails: the faces of a folded one pass through each other and have no outside.
template <class T, class Law, class Rule>
bool is_too_distorted(const HexBody<T, Law, Rule> &hexes, const Nodes<T> &nodes, Index e,
                      const ConversionOptions<T> &options, T spacing) {
  const Index points = points_of_hex(hexes);
  for (Index i = e * points; i < (e + 1) * points; ++i)
    // Written so that a NaN is left to the guards.
    if (const T density = hexes.points.density[i];
        density <= T(0) || density > options.largest_compression * hexes.metal.density)
      return true;
  if (hexes.points.plastic_strain[e * points] < options.least_checked_strain) return false;
  const Corners<T> x = gather_corners(nodes.position, hexes.hexes[e]);
  if (!(hex_volume<T>(x) > T(0)) || !(smallest_corner_jacobian<T>(x) > T(0))) return true;
  return stable_time_step_of_hex(hexes, nodes, e) < options.smallest_step * spacing / sound_speed(hexes.metal);
}

/// Books the work of hex e since the middle of the last step of `dt` (s) and ends its forces. The stress of a failed
/// hex ended when it failed.
template <class T, class Law, class Rule> void settle(HexBody<T, Law, Rule> &body, Nodes<T> &nodes, Index e, T dt) {
  // What is left pushes alone: energy() takes the kinetic energy back by half a step of these forces.
  for (int a = 0; a < 8; ++a)
    nodes.force[body.hexes[e][a]] -= std::exchange(body.corner_force[8 * e + a], Vec3<T>(Vec3<T>::Zero()));
  const HexModes<T> x = modes<T>(gather_corners(nodes.position, body.hexes[e])),
                    v = modes<T>(gather_corners(nodes.velocity, body.hexes[e]));
  const MeanGradient<T> mean = mean_gradient<T>(x);
  if (!(mean.volume > T(0))) return;
  const Mat3<T> L = mean_velocity_gradient<T>(mean, v);
  const Sym3<T> D = symmetric_part(midstep_gradient<T>(L, dt));
  const T half = T(0.5) * dt;
  const Index points = points_of_hex(body);
  for (Index i = e * points; i < (e + 1) * points; ++i)
    body.points.internal_energy[i] += half / body.points.density[i] * double_dot(stress(load(body.points, i)), D);
  body.viscous_energy[e] -= half * body.viscous_pressure[e] * L.trace() * mean.volume;
  if (points == 1)
    body.hourglass_energy[e] += half * body.hourglass_force[e].cwiseProduct(hourglass_motion<T>(x, v, L).rate).sum();
}

/// The state of the particle that hex e turns into: that of its points, their mean if they are several,
/// without shear and tension.
template <class T, class Law, class Rule> MaterialPoint<T> failed_point(const HexBody<T, Law, Rule> &body, Index e) {
  MaterialPoint<T> mean;
  const Index points = points_of_hex(body);
  for (Index i = e * points; i < (e + 1) * points; ++i) {
    const MaterialPoint<T> p = load(body.points, i);
    for (T MaterialPoint<T>::*field :
         {&MaterialPoint<T>::density, &MaterialPoint<T>::plastic_strain, &MaterialPoint<T>::temperature,
          &MaterialPoint<T>::damage, &MaterialPoint<T>::internal_energy})
      mean.*field += T(1) / T(points) * (p.*field);
  }
  mean.damage = std::max(mean.damage, T(1));
  const auto &metal = body.metal;
  // What inverted has no density worth keeping.
  mean.density = std::clamp(mean.density, T(0.5) * metal.density, T(2) * metal.density);
  mean.pressure =
      std::max(T(0), pressure<T, T>(metal.eos, bulk_modulus(metal.elasticity), mean.density / metal.density - T(1),
                                    metal.density * mean.internal_energy));
  return mean;
}

/// Takes hex e out of its body: no stress, no energy per mass, no share in the masses of its nodes.
template <class T, class Law, class Rule> void take_out(HexBody<T, Law, Rule> &body, Index e) {
  const Index points = points_of_hex(body);
  for (Index i = e * points; i < (e + 1) * points; ++i) {
    MaterialPoint<T> p = load(body.points, i);
    p.deviator = {}, p.pressure = T(0), p.internal_energy = T(0), p.damage = std::max(p.damage, T(1));
    store(body.points, i, p);
    body.points.velocity_gradient[i].setZero();
  }
  if (points == 1) body.hourglass_force[e].setZero();
  body.viscous_pressure[e] = T(0);
  body.corner_mass[e].fill(T(0));
}

/// Turns hex e into particle e; returns the kinetic energy that is lost, J. Leaves the masses of the hex's nodes to
/// gather_masses().
template <class Particles, class T, class Law, class Rule>
T turn_into_particle(Particles &particles, HexBody<T, Law, Rule> &hexes, Nodes<T> &nodes, Index e, T dt) {
  settle(hexes, nodes, e, dt);
  const Index n = particles.nodes.begin + e;
  const T mass = particles.point_mass[e];
  Vec3<T> moment = Vec3<T>::Zero(), momentum = Vec3<T>::Zero();
  T kinetic{};
  for (int a = 0; a < 8; ++a) {
    const T share = hexes.corner_mass[e][a];
    const Vec3<T> &v = nodes.velocity[hexes.hexes[e][a]];
    moment += share * nodes.position[hexes.hexes[e][a]];
    momentum += share * v;
    kinetic += T(0.5) * share * v.squaredNorm();
  }
  nodes.mass[n] = mass;
  nodes.position[n] = moment / mass;
  nodes.velocity[n] = momentum / mass;
  store(particles.points, e, failed_point(hexes, e));
  particles.points.velocity_gradient[e].setZero();
  particles.unborn[e] = 0;
  take_out(hexes, e);
  return kinetic - T(0.5) * mass * nodes.velocity[n].squaredNorm();
}

/// Gives the nodes of hex e the sum of the shares that the hexes around them have in their masses.
template <class T, class Law, class Rule>
void gather_masses(const HexBody<T, Law, Rule> &body, Nodes<T> &nodes, Index e) {
  const CornersOfNodes &list = body.corners_of_nodes;
  for (const Index n : body.hexes[e]) {
    T mass{};
    const Index at = n - body.nodes.begin;
    for (Index k = list.begin[at]; k < list.begin[at + 1]; ++k)
      mass += body.corner_mass[list.corners[k] / 8][list.corners[k] % 8];
    nodes.mass[n] = mass;
  }
}

/// The exposed faces of the hexes.
template <class T, class Particles, class Hexes>
std::vector<Facet> surface_of(const Conversion<T> &conversion, const Particles &particles, const Hexes &hexes) {
  return exposed_facets(hexes.hexes, conversion.neighbours, [&](Index e) { return is_converted(particles, e); });
}

/// Turns the hexes that have failed or are too distorted into particles, and updates the contacts.
template <class T, class Bodies> void convert(Conversion<T> &conversion, Model<T, Bodies> &model) {
  if (model.steps % conversion.options.every != 0) return;
  Nodes<T> &nodes = model.nodes;
  with_bodies(model.bodies, conversion, [&](auto &particles, auto &hexes) {
    enum Verdict : char { stays, failed, distorted };
    std::vector<Verdict> verdicts(particles.points.size(), stays);
    parallel_for(particles.points.size(), [&](Index e) {
      if (!is_unborn(particles, e)) return;
      if (is_failed(hexes, e))
        verdicts[e] = failed;
      else if (is_too_distorted(hexes, nodes, e, conversion.options, particles.spacing))
        verdicts[e] = distorted;
    });
    std::vector<Index> going;
    for (Index e = 0; e < particles.points.size(); ++e) {
      if (verdicts[e] == stays) continue;
      ++(verdicts[e] == failed ? conversion.failed : conversion.distorted);
      going.push_back(e);
    }
    if (going.empty()) return;
    for (const Index e : going) conversion.energy += turn_into_particle(particles, hexes, nodes, e, model.last_step);
    for (const Index e : going) gather_masses(hexes, nodes, e);
    particles.neighbours.built_at.clear();
    for (auto &contact : model.contacts)
      if (contact.follows) follow_slaves(contact, nodes, model.last_step);
    follow_surface(model.contacts[conversion.surface], nodes, surface_of(conversion, particles, hexes),
                   model.last_step);
  });
}

/// Gives the contacts of conversions the facets that belong to the state of the hexes, after that has been read.
template <class T, class Bodies> void renew_surfaces(Model<T, Bodies> &model) {
  for (const Conversion<T> &conversion : model.conversions)
    with_bodies(model.bodies, conversion, [&](auto &particles, auto &hexes) {
      set_facets(model.contacts[conversion.surface], model.nodes, surface_of(conversion, particles, hexes));
    });
}

/// Makes the particles `unborn` and the contacts ready to follow, before the first step: the hexes have all the mass.
template <class T, class Bodies> void begin_conversion(const Conversion<T> &conversion, Model<T, Bodies> &model) {
  with_bodies(model.bodies, conversion, [&](auto &particles, auto &hexes) {
    particles.unborn.assign(particles.points.size(), 1);
    for (Index i = 0; i < particles.points.size(); ++i) {
      T mass{};
      for (const T share : hexes.corner_mass[i]) mass += share;
      particles.point_mass[i] = mass;
      model.nodes.mass[particles.nodes.begin + i] = T(0);
    }
  });
  for (auto &contact : model.contacts) {
    contact.follows = true;
    contact.state.present_offset = contact.offset;
    contact.state.opposite.resize(contact.slaves.size());
    follow_slaves(contact, model.nodes, T(0));
  }
}

} // namespace ogive
