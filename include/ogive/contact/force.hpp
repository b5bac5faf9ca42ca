// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/contact/closest_point.hpp"
#include "ogive/contact/search.hpp"
#include "ogive/contact/side.hpp"
#include "ogive/core/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ogive {

/// Where and how deep a slave touches the surface.
template <class T> struct Touch {
  Index facet = -1;                    ///< -1: no contact
  std::array<T, 4> weights{};          ///< of the facet's nodes at the closest point
  Vec3<T> direction = Vec3<T>::Zero(); ///< unit vector out of the surface, as the slave sees it
  T depth{};                           ///< m, positive where the slave's sphere enters the surface
  bool lost = false;                   ///< no contact, because the slave is deeper inside than it may be
  Reflection reflection{};             ///< in which the slave sees the facet
  T room{};                            ///< m, without contact: how far both may approach before there can be one
};

/// The facet nearest to a slave, and its point there.
template <class T> struct NearestFacet {
  Index facet = -1;      ///< -1: none is near
  FacetPoint<T> point{}; ///< closest to the slave
  bool outside = true;   ///< the slave lies outside the surface

  /// Distance of the slave from the surface, m; negative inside.
  T gap() const { return (outside ? T(1) : T(-1)) * std::sqrt(point.distance_squared); }
};

/// True if a facet with the closest point `point` to `p` (m) faces it from the other side, seen from the facet with the
/// unit vector `out` that touches it.
template <class T> bool lies_across(const Vec3<T> &out, const FacetPoint<T> &point, const Vec3<T> &p) {
  const Vec3<T> gap = p - point.position;
  return point.normal.dot(gap) > T(0) && out.dot(gap) <= T(-0.3) * std::sqrt(point.distance_squared);
}

/// Closest point of the candidate facets to `p` (m), where slave `a` of the active list is, if nearer than `limit` (m).
/// With `across`, a unit vector out of a facet that touches `p`, only facets on the other side of `p` count that face
/// it.
template <class T>
NearestFacet<T> find_nearest(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a, const Vec3<T> &p, T limit,
                             const std::optional<Vec3<T>> &across = {}) {
  FacetPoint<T> best;
  T best_alignment{};
  Index facet = -1;
  for (Index k = contact.candidate_begin[a]; k < contact.candidate_begin[a + 1]; ++k) {
    const Index f = contact.candidates[k];
    if ((p - contact.facet_middle[f]).norm() > limit + contact.facet_radius[f]) continue;
    std::array<Vec3<T>, 4> corner;
    for (int c = 0; c < 4; ++c) corner[c] = nodes.position[contact.facets[f].nodes[c]];
    const FacetPoint<T> point = closest_on_facet(p, corner);
    if (across && !lies_across<T>(*across, point, p)) continue;
    const T alignment = std::abs(point.normal.dot(p - point.position));
    const T tie = T(1e-6) * (best.distance_squared + point.distance_squared);
    if (facet < 0 || point.distance_squared < best.distance_squared - tie ||
        (point.distance_squared <= best.distance_squared + tie && alignment > best_alignment)) {
      best = point;
      best_alignment = alignment;
      facet = f;
      limit = std::min(limit, std::sqrt(point.distance_squared) * T(1.001));
    }
  }
  if (facet < 0) return {};
  // On a convex surface, where few slaves are inside, one that seems outside by the nearest facet is outside.
  const bool seems_outside = best.normal.dot(p - best.position) >= T(0);
  const bool outside = across || (seems_outside && !contact.follows)
                           ? seems_outside
                           : is_outside(contact, nodes, a, p, std::sqrt(best.distance_squared));
  return {facet, best, outside};
}

/// The offset of slave `s` at present, m.
template <class T> T offset_now(const NodeToSurface<T> &contact, Index s) {
  return contact.present_offset.empty() ? contact.offset[s] : contact.present_offset[s];
}

/// How deep inside the surface slave `s` may be, m. One that began inside is lost if it gets deeper than there by as
/// much as the others may.
template <class T> T deepest_place(const NodeToSurface<T> &contact, Index s) {
  return contact.search_margin - std::min(offset_now(contact, s), T(0));
}

/// How slave `a` of the active list touches the surface at `nearest`. At an edge or corner the direction is that from
/// the surface to the slave, so that it turns smoothly around the edge; in a mirror plane it stays in the plane.
template <class T>
Touch<T> touch_at(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a, const NearestFacet<T> &nearest) {
  const Index slave = contact.active[a];
  const Vec3<T> p = on_model_side(contact, nodes.position, slave);
  const T offset = offset_now(contact, slave), deepest = deepest_place(contact, slave);
  const Index facet = nearest.facet;
  const FacetPoint<T> &best = nearest.point;
  if (facet < 0) return {.room = deepest};
  const Vec3<T> gap = p - best.position;
  const T distance = std::sqrt(best.distance_squared);
  const bool outside = nearest.outside;
  const T depth = outside ? offset - distance : offset + distance;
  if (depth <= T(0)) return {.room = outside ? -depth : T(0)};
  if (!outside && distance > deepest) return {.lost = true};
  Vec3<T> direction = best.normal;
  if (distance > T(1e-3) * contact.facet_radius[facet]) direction = (outside ? T(1) : T(-1)) / distance * gap;
  const T near = T(1e-6) * contact.facet_radius[facet];
  if (contact.symmetry.x && std::abs(p[0]) < near) direction[0] = T(0);
  if (contact.symmetry.y && std::abs(p[1]) < near) direction[1] = T(0);
  const T length = direction.norm();
  if (length < T(0.1)) return {};
  const Reflection reflection = to_model_side(nodes.position[contact.slaves[slave]], contact.symmetry);
  return {facet, best.weights, reflected<T>(direction / length, reflection), depth, false, reflection};
}

/// How slave `a` of the active list touches the surface. `across` as in find_nearest().
template <class T>
Touch<T> find_touch(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a,
                    const std::optional<Vec3<T>> &across = {}) {
  const Index s = contact.active[a];
  const Vec3<T> p = on_model_side(contact, nodes.position, s);
  return touch_at(contact, nodes, a,
                  find_nearest(contact, nodes, a, p, contact.offset[s] + deepest_place(contact, s), across));
}

/// Velocity of the slave relative to the facet's point as the slave sees it, m/s. `touch` is a Touch or ContactForce.
template <class T, class Touching>
Vec3<T> relative_velocity(const NodeToSurface<T> &contact, const Nodes<T> &nodes, Index slave, const Touching &touch) {
  Vec3<T> v = Vec3<T>::Zero();
  for (int c = 0; c < 4; ++c) v += touch.weights[c] * nodes.velocity[contact.facets[touch.facet].nodes[c]];
  return nodes.velocity[contact.slaves[slave]] - reflected(v, touch.reflection);
}

/// Penalty force k depth with k = stiffness m/dt^2, and Coulomb friction, at most sticking m |v_t|/dt.
template <class T>
ContactForce<T> contact_force(const Touch<T> &touch, const ContactOptions<T> &options, const Vec3<T> &velocity, T mass,
                              T time_step) {
  ContactForce<T> c{.facet = touch.facet, .reflection = touch.reflection, .weights = touch.weights};
  const T pressing = options.stiffness * mass / (time_step * time_step) * touch.depth;
  c.normal = pressing * touch.direction;
  const Vec3<T> sliding = velocity - velocity.dot(touch.direction) * touch.direction;
  const T speed = sliding.norm();
  if (options.friction > T(0) && speed > T(0))
    c.friction = -std::min(options.friction * pressing / speed, options.sticking * mass / time_step) * sliding;
  return c;
}

/// Mass that the penalty stiffness of slave `s` is made with, kg: the smaller of its own and the facet's at the point
/// of contact, so that light facet nodes stay stable.
template <class T> T penalty_mass(const NodeToSurface<T> &contact, Index s, const Touch<T> &touch) {
  if (contact.master_mass.empty()) return contact.slave_mass[s];
  T facet_mass{};
  for (int c = 0; c < 4; ++c) facet_mass += touch.weights[c] * contact.master_mass[touch.facet][c];
  return std::min(contact.slave_mass[s], facet_mass);
}

/// The same for a slave whose offset is less than its own: the offset grows, no faster than the slave leaves the
/// surface, so that one that began inside is not thrown out.
template <class T> Touch<T> find_growing_touch(NodeToSurface<T> &contact, const Nodes<T> &nodes, Index a) {
  const Index s = contact.active[a];
  const T full = contact.offset[s], reach = full + contact.search_margin;
  const Vec3<T> p = on_model_side(contact, nodes.position, s);
  const NearestFacet<T> nearest = find_nearest(contact, nodes, a, p, reach);
  T &present = contact.present_offset[s];
  present = std::max(present, nearest.facet < 0 ? full : std::min(full, nearest.gap()));
  const bool is_near = nearest.facet >= 0 && nearest.point.distance_squared <= reach * reach;
  if (is_near || full + deepest_place(contact, s) <= reach) return touch_at(contact, nodes, a, nearest);
  return find_touch(contact, nodes, a);
}

/// Adds half of the work of a force on slave `s` over `dt` (s), done at the velocities now, to the ledger.
template <class T>
void add_half_work(NodeToSurface<T> &contact, const Nodes<T> &nodes, Index s, const ContactForce<T> &c, T dt) {
  if (c.facet < 0) return;
  const Vec3<T> v = relative_velocity(contact, nodes, s, c);
  contact.normal_energy[s] -= T(0.5) * dt * v.dot(c.normal);
  contact.friction_energy[s] -= T(0.5) * dt * v.dot(c.friction);
}

/// Adds the reaction to a force on a slave, times `sign`, to the forces of the facet's nodes.
template <class T>
void add_reaction(const NodeToSurface<T> &contact, Nodes<T> &nodes, const ContactForce<T> &c, T sign) {
  if (c.facet < 0) return;
  const Vec3<T> reaction = reflected<T>(sign * (c.normal + c.friction), c.reflection);
  for (int k = 0; k < 4; ++k) nodes.force[contact.facets[c.facet].nodes[k]] -= c.weights[k] * reaction;
}

/// Takes a force on slave `s` and its reaction out of the forces of the nodes.
template <class T> void take_back(const NodeToSurface<T> &contact, Nodes<T> &nodes, Index s, const ContactForce<T> &c) {
  if (c.facet < 0) return;
  nodes.force[contact.slaves[s]] -= c.normal + c.friction;
  add_reaction(contact, nodes, c, T(-1));
}

/// Takes the way that each slave and the surface may have come closer since the last look from its room.
template <class T> void use_up_room(NodeToSurface<T> &contact, const Nodes<T> &nodes) {
  const Box<T> surface = box_of_moves(nodes, contact.seen_at, contact.masters);
  parallel_for(static_cast<Index>(contact.active.size()), [&](Index a) {
    const Index s = contact.active[a];
    if (!(contact.room[s] > T(0))) return;
    const Vec3<T> u = on_model_side(contact, nodes.position, s) - on_model_side(contact, contact.seen_at, s);
    contact.room[s] -= (u - surface.low).cwiseAbs().cwiseMax((u - surface.high).cwiseAbs()).norm();
  });
}

/// The room of slave `s` after a look at it, m: until it is used up, what it touches need not be looked for. None for
/// one that touches, or whose offset grows.
template <class T> T room_after(const NodeToSurface<T> &contact, Index s, const Touch<T> &touch) {
  if (offset_now(contact, s) < contact.offset[s]) return T(0);
  return T(0.99) * touch.room; // the closest point is known to 1e-6 of its distance
}

/// Adds the forces of a contact to slaves and masters, and their work over the last interval `dt` (s; the step to come
/// is `next`) to the ledger (trapezoidal rule between the forces before and now).
template <class T> void add_contact_force(NodeToSurface<T> &contact, Nodes<T> &nodes, T dt, T next) {
  if (is_search_due(contact, nodes)) {
    search(contact, nodes);
    contact.room.assign(contact.slaves.size(), T(0));
  } else {
    use_up_room(contact, nodes);
  }
  if (contact.reference_time_step == T(0)) contact.reference_time_step = next;
  parallel_for(static_cast<Index>(contact.facets.size()), [&](Index f) {
    Vec3<T> middle = Vec3<T>::Zero();
    for (Index n : contact.facets[f].nodes) middle += T(0.25) * nodes.position[n];
    T r2{};
    for (Index n : contact.facets[f].nodes) r2 = std::max(r2, (nodes.position[n] - middle).squaredNorm());
    contact.facet_middle[f] = middle;
    contact.facet_radius[f] = std::sqrt(r2);
  });

  parallel_for(static_cast<Index>(contact.active.size()), [&](Index a) {
    const Index s = contact.active[a], node = contact.slaves[s];
    if (contact.room[s] > T(0)) return;
    ContactForce<T> now, opposite;
    const auto force_of = [&](const Touch<T> &touch) {
      const Vec3<T> velocity = relative_velocity(contact, nodes, s, touch);
      return contact_force(touch, contact.options, velocity, penalty_mass(contact, s, touch),
                           contact.reference_time_step);
    };
    const bool grows = offset_now(contact, s) < contact.offset[s];
    const Touch<T> touch = grows ? find_growing_touch(contact, nodes, a) : find_touch(contact, nodes, a);
    contact.room[s] = room_after(contact, s, touch);
    if (touch.lost) {
      if (contact.options.may_bury)
        contact.present_offset[s] = std::numeric_limits<T>::lowest();
      else
        now.lost = contact.slave_mass[s] > T(0); // what has been let go may be anywhere
    } else if (touch.facet >= 0) {
      now = force_of(touch);
      // In a gap narrower than the sphere, the nearer wall alone would throw the slave to and fro between both.
      if (!contact.opposite.empty() && contact.offset[s] > T(0))
        if (const Touch<T> other = find_touch<T>(contact, nodes, a, reflected(touch.direction, touch.reflection));
            other.facet >= 0)
          opposite = force_of(other);
    }
    add_half_work(contact, nodes, s, contact.forces[s], dt);
    add_half_work(contact, nodes, s, now, dt);
    contact.forces[s] = now;
    nodes.force[node] += now.normal + now.friction;
    if (contact.opposite.empty()) return;
    add_half_work(contact, nodes, s, contact.opposite[s], dt);
    add_half_work(contact, nodes, s, opposite, dt);
    contact.opposite[s] = opposite;
    nodes.force[node] += opposite.normal + opposite.friction;
  });

  contact.seen_at = nodes.position;

  // Masters share nodes; the slaves in contact are few, so one thread hands over their reactions in a fixed order.
  for (Index s : contact.active) {
    if (contact.forces[s].lost && contact.lost < 0) contact.lost = s;
    add_reaction(contact, nodes, contact.forces[s], T(1));
    if (!contact.opposite.empty()) add_reaction(contact, nodes, contact.opposite[s], T(1));
  }
}

/// Work taken by the penalty springs, J.
template <class T> T normal_energy(const NodeToSurface<T> &c) {
  return ordered_sum(static_cast<Index>(c.slaves.size()), T(0), [&](Index s) { return c.normal_energy[s]; });
}

/// Work taken by friction, J.
template <class T> T friction_energy(const NodeToSurface<T> &c) {
  return ordered_sum(static_cast<Index>(c.slaves.size()), T(0), [&](Index s) { return c.friction_energy[s]; });
}

} // namespace ogive
