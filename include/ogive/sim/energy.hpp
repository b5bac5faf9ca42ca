// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/ledger.hpp"
#include "ogive/contact/particle_force.hpp"
#include "ogive/fem/hex_force.hpp"
#include "ogive/sim/model.hpp"
#include "ogive/sph/body.hpp"

#include <vector>

namespace ogive {

/// Parts of the energy of the whole model, J (symmetric copies included). All but `kinetic` and `elastic` are work done
/// since the start.
template <class T> struct Energy {
  T kinetic{};   ///< of all nodes
  T elastic{};   ///< stored in the metal
  T plastic{};   ///< work of the stresses that is not elastic
  T hourglass{}; ///< work of hourglass control
  T viscous{};   ///< artificial and bulk viscosity
  T contact{};   ///< in penalty springs
  T friction{};  ///< heat of Coulomb friction
};

/// Sum of all parts, J: constant in time.
template <class T> T total(const Energy<T> &e) {
  return e.kinetic + e.elastic + e.plastic + e.hourglass + e.viscous + e.contact + e.friction;
}

/// Kinetic energy of nodes at the time of the latest forces, J: m/2 v_before . v_after (exact for central differences).
template <class T> T kinetic_energy(const Nodes<T> &nodes, NodeRange range, T dt_mid) {
  return ordered_sum(range.size(), T(0), [&](Index i) {
    const Index n = range.begin + i;
    const Vec3<T> &v = nodes.velocity[n];
    return T(0.5) * (nodes.mass[n] * v.squaredNorm() - dt_mid * v.dot(nodes.force[n]));
  });
}

/// Elastic energy stored in a body, J: deviatoric s:s/4G and volumetric p^2/2K.
template <class T, class Body> T elastic_energy(const Body &body) {
  const T shear = shear_modulus(body.metal.elasticity), bulk = bulk_modulus(body.metal.elasticity);
  return ordered_sum(body.points.size(), T(0), [&](Index i) {
    const auto &p = body.points;
    return body.point_mass[i] / p.density[i] *
           (double_dot(p.deviator[i], p.deviator[i]) / (T(4) * shear) + p.pressure[i] * p.pressure[i] / (T(2) * bulk));
  });
}

/// The energy ledger of a model at the time of its latest forces.
template <class T, class Bodies> Energy<T> energy(const Model<T, Bodies> &model) {
  Energy<T> e;
  e.kinetic = kinetic_energy(model.nodes, NodeRange{0, model.nodes.size()}, model.last_mid_step);
  for_each_body(model, [&](const auto &body) {
    const T elastic = elastic_energy<T>(body);
    e.elastic += elastic;
    e.plastic += internal_energy(body) - elastic;
    e.hourglass += hourglass_energy(body);
    e.viscous += viscous_energy(body);
  });
  for (const auto &contact : model.contacts) {
    e.contact += normal_energy(contact);
    e.friction += friction_energy(contact);
  }
  for (const auto &contact : model.particle_contacts) e.contact += normal_energy(contact);
  const T copies = T(model.symmetry.copies());
  for (T *part : {&e.kinetic, &e.elastic, &e.plastic, &e.hourglass, &e.viscous, &e.contact, &e.friction})
    *part *= copies;
  return e;
}

/// Momentum of the whole model, kg m/s; components normal to mirror planes cancel.
template <class T, class Bodies> Vec3<T> momentum(const Model<T, Bodies> &model) {
  const Nodes<T> &nodes = model.nodes;
  Vec3<T> p = T(model.symmetry.copies()) * ordered_sum(nodes.size(), Vec3<T>(Vec3<T>::Zero()), [&](Index n) -> Vec3<T> {
                return nodes.mass[n] * nodes.velocity[n];
              });
  if (model.symmetry.x) p[0] = T(0);
  if (model.symmetry.y) p[1] = T(0);
  return p;
}

/// Mean velocity of nodes (momentum over mass), m/s.
template <class T> Vec3<T> mean_velocity(const Nodes<T> &nodes, NodeRange range) {
  const T mass = ordered_sum(range.size(), T(0), [&](Index i) { return nodes.mass[range.begin + i]; });
  const Vec3<T> momentum = ordered_sum(range.size(), Vec3<T>(Vec3<T>::Zero()), [&](Index i) -> Vec3<T> {
    return nodes.mass[range.begin + i] * nodes.velocity[range.begin + i];
  });
  return momentum / mass;
}

/// Mean velocity of the nodes of a list, m/s.
template <class T> Vec3<T> mean_velocity(const Nodes<T> &nodes, const std::vector<Index> &list) {
  const auto count = static_cast<Index>(list.size());
  const T mass = ordered_sum(count, T(0), [&](Index i) { return nodes.mass[list[i]]; });
  const Vec3<T> momentum = ordered_sum(count, Vec3<T>(Vec3<T>::Zero()), [&](Index i) -> Vec3<T> {
    return nodes.mass[list[i]] * nodes.velocity[list[i]];
  });
  return momentum / mass;
}

} // namespace ogive
