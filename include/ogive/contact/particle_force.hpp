// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/particle_search.hpp"
#include "ogive/material/damage.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ogive {

/// Volume fraction of other bodies, weighted with the kernel, around particle `i` at `positions` (m): 0 far from them,
/// 1 within one.
template <class T> T fullness_at(const ParticleContact<T> &contact, std::span<const Vec3<T>> positions, Index i) {
  T sum{};
  for (const ParticleNearby &near : row(contact, i)) {
    const Vec3<T> gap = positions[i] - reflected(positions[near.particle], near.reflection);
    sum += contact.volume[near.particle] * kernel_value<CubicSpline>(gap.norm(), contact.smoothing_length);
  }
  return sum;
}

/// The pressure K (c_i - t_i) of particle `i` in this step, Pa; 0 where nothing touches it.
template <class T> T pressing(const ParticleContact<T> &contact, Index i) {
  return contact.stiffness * std::max(contact.fullness[i] - contact.threshold[i], T(0));
}

/// Makes a contact between bodies of particles whose nodes follow each other. `modulus` (Pa) is the pressure that a
/// depth of one particle distance would give if it went on as it begins, with two plane surfaces. Throws SetupError for
/// a number of bodies, a modulus or nodes that do not fit.
template <class T>
ParticleContact<T> make_particle_contact(const Nodes<T> &nodes, const std::vector<ContactBody<T>> &bodies, T modulus,
                                         std::string name, SymmetryPlanes symmetry = {}) {
  require(bodies.size() >= 2 && bodies.size() <= most_contact_bodies, name + " bodies", bodies.size(),
          "there must be 2 to " + std::to_string(most_contact_bodies));
  require(std::isfinite(modulus) && modulus > T(0), name + " modulus (Pa)", modulus, "must be positive");
  ParticleContact<T> c;
  c.name = std::move(name);
  c.symmetry = symmetry;
  c.nodes = {bodies.front().nodes.begin, bodies.front().nodes.begin};
  T spacing{};
  std::vector<Vec3<T>> touching;
  for (const ContactBody<T> &body : bodies) {
    require(body.nodes.begin == c.nodes.end, c.name + " first node of a body", body.nodes.begin,
            "must follow the last one of the body before");
    require(body.volumes.size() == std::size_t(body.nodes.size()), c.name + " volumes", body.volumes.size(),
            "there must be one for each particle");
    c.nodes.end = body.nodes.end;
    c.body.insert(c.body.end(), body.volumes.size(), static_cast<std::uint8_t>(&body - bodies.data()));
    c.volume.insert(c.volume.end(), body.volumes.begin(), body.volumes.end());
    spacing = std::max(spacing, body.spacing);
    for (Index n = body.nodes.begin; n < body.nodes.end; ++n)
      touching.push_back(nodes.position[n] + Vec3<T>(T(0), T(0), body.to_touch));
  }
  c.smoothing_length = T(1.2) * spacing;
  c.search_margin = T(0.5) * spacing;
  // With planes of particles on both sides the pressure is 2 K (s dc/dz)^2 depth/s, and s dc/dz is 0.47 at touch.
  c.stiffness = modulus / (T(2) * T(0.47) * T(0.47));
  c.forces.assign(touching.size(), Vec3<T>::Zero());
  c.normal_energy.assign(touching.size(), T(0));

  search(c, std::span<const Vec3<T>>(touching));
  std::vector<T> largest(bodies.size(), T(0));
  for (Index i = 0; i < c.nodes.size(); ++i) {
    c.threshold.push_back(fullness_at(c, std::span<const Vec3<T>>(touching), i));
    largest[c.body[i]] = std::max(largest[c.body[i]], c.threshold[i]);
  }
  // Each particle of a touching face has its own, so that no lattice shows; others may become a surface later on.
  for (Index i = 0; i < c.nodes.size(); ++i)
    if (c.threshold[i] < T(0.5) * largest[c.body[i]]) c.threshold[i] = largest[c.body[i]];
  for (const T t : largest)
    require(t > T(0), c.name + " fullness at touch", t, "the bodies must touch where `to_touch` brings them");
  c.searched_at.clear(), c.row_begin.clear(), c.nearby.clear();
  return c;
}

/// Deactivates the particles that have been removed from `body`.
template <class T, class Body> void release_removed(ParticleContact<T> &contact, const Body &body) {
  if (body.metal.damage.effect != FailureEffect::removal || body.nodes.begin < contact.nodes.begin ||
      body.nodes.end > contact.nodes.end)
    return;
  parallel_for(body.nodes.size(), [&](Index i) {
    if (is_node_removed(body, i)) contact.volume[body.nodes.begin - contact.nodes.begin + i] = T(0);
  });
}

/// Adds the forces between bodies to their particles, f_i = -sum_j V_i V_j (p_i + p_j) grad W_ij with the pressures p
/// of pressing(), and their work over the last interval `dt` (s) to the ledger (trapezoidal rule).
template <class T> void add_contact_force(ParticleContact<T> &contact, Nodes<T> &nodes, T dt) {
  if (is_search_due(contact, nodes)) search(contact, positions_of(contact, nodes));
  const auto positions = positions_of(contact, nodes);
  const Index count = contact.nodes.size();
  parallel_for(count, [&](Index i) { contact.fullness[i] = fullness_at(contact, positions, i); });
  const T inverse_h = T(1) / contact.smoothing_length;
  parallel_for(count, [&](Index i) {
    Vec3<T> force = Vec3<T>::Zero();
    const T own = pressing(contact, i);
    for (const ParticleNearby &near : row(contact, i)) {
      const T both = own + pressing(contact, near.particle);
      if (both == T(0)) continue;
      const Vec3<T> gap = positions[i] - reflected(positions[near.particle], near.reflection);
      const T volumes = contact.volume[i] * contact.volume[near.particle];
      force -= volumes * both * gradient_over_r<CubicSpline>(gap.squaredNorm(), inverse_h) * gap;
    }
    const Index node = contact.nodes.begin + i;
    contact.normal_energy[i] -= T(0.5) * dt * nodes.velocity[node].dot(contact.forces[i] + force);
    contact.forces[i] = force;
    nodes.force[node] += force;
  });
  if (contact.lost < 0)
    if (const Index first = parallel_min(
            count, count,
            [&](Index i) { return contact.fullness[i] > T(lost_fullness) && contact.volume[i] > T(0) ? i : count; });
        first < count)
      contact.lost = first;
}

/// Work taken by the contact's pressure, J.
template <class T> T normal_energy(const ParticleContact<T> &c) {
  return ordered_sum(c.nodes.size(), T(0), [&](Index i) { return c.normal_energy[i]; });
}

} // namespace ogive
