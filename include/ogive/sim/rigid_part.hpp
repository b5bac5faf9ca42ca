// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/parallel.hpp"
#include "ogive/core/rotation.hpp"
#include "ogive/core/symmetry.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace ogive {

/// Mass, momentum and inertia of a range of nodes. Of a half or quarter model they are those of the computed part.
template <class T> struct Inertia {
  T mass{};                                   ///< kg
  Vec3<T> centre = Vec3<T>::Zero();           ///< of mass, m
  Vec3<T> velocity = Vec3<T>::Zero();         ///< momentum over mass, m/s
  Vec3<T> angular_momentum = Vec3<T>::Zero(); ///< about the centre of mass, kg m2/s
  Mat3<T> tensor = Mat3<T>::Zero();           ///< about the centre of mass, kg m2
};

/// Those of `count` nodes, `node_at(i)` each, as points of mass. Symmetry decides where the whole's centre is: in a
/// mirror plane.
template <class T, class F>
Inertia<T> inertia_over(const Nodes<T> &nodes, Index count, F &&node_at, SymmetryPlanes symmetry) {
  Inertia<T> all;
  for (Index i = 0; i < count; ++i) {
    const Index n = node_at(i);
    all.mass += nodes.mass[n];
    all.centre += nodes.mass[n] * nodes.position[n];
    all.velocity += nodes.mass[n] * nodes.velocity[n];
  }
  all.centre /= all.mass, all.velocity /= all.mass;
  if (symmetry.x) all.centre[0] = all.velocity[0] = T(0);
  if (symmetry.y) all.centre[1] = all.velocity[1] = T(0);
  for (Index i = 0; i < count; ++i) {
    const Index n = node_at(i);
    const Vec3<T> arm = nodes.position[n] - all.centre;
    all.angular_momentum += nodes.mass[n] * cross<T>(arm, Vec3<T>(nodes.velocity[n] - all.velocity));
    all.tensor += nodes.mass[n] * (arm.squaredNorm() * Mat3<T>::Identity() - arm * arm.transpose());
  }
  return all;
}

///@{
/// Those of the nodes of a range or of a list, see inertia_over().
template <class T> Inertia<T> inertia_of(const Nodes<T> &nodes, NodeRange range, SymmetryPlanes symmetry = {}) {
  return inertia_over(
      nodes, range.size(), [&](Index i) { return range.begin + i; }, symmetry);
}
template <class T>
Inertia<T> inertia_of(const Nodes<T> &nodes, const std::vector<Index> &list, SymmetryPlanes symmetry = {}) {
  return inertia_over(
      nodes, static_cast<Index>(list.size()), [&](Index i) { return list[i]; }, symmetry);
}
///@}

/// Nodes that move as one. A part without `arms` keeps its direction, one of make_rigid_part() turns as well.
template <class T> struct RigidPart {
  NodeRange nodes{};                    ///< that move as one
  std::vector<Vec3<T>> arms{};          ///< m, of each node from the centre of mass, before the part has turned
  T mass{};                             ///< kg
  Mat3<T> inertia = Mat3<T>::Zero();    ///< kg m2, about the centre of mass, before the part has turned
  Mat3<T> compliance = Mat3<T>::Zero(); ///< 1/(kg m2): angular velocity over angular momentum in the free directions

  // State, with the time levels of the nodes.
  Vec3<T> centre = Vec3<T>::Zero();           ///< of mass, m
  Rotation<T> orientation{};                  ///< from the arms to the nodes
  Vec3<T> velocity = Vec3<T>::Zero();         ///< of the centre of mass, m/s
  Vec3<T> angular_momentum = Vec3<T>::Zero(); ///< about the centre of mass in the free directions, kg m2/s
};

/// Whether a part turns.
template <class T> bool turns(const RigidPart<T> &part) { return !part.arms.empty(); }

/// Directions in which a node of the range is held: bits of Held.
template <class T> std::uint8_t held_directions(const Nodes<T> &nodes, NodeRange range) {
  std::uint8_t held = held_none;
  for (Index n = range.begin; n < range.end; ++n) held |= nodes.held[n];
  return held;
}

/// Inverse of a tensor of inertia, restricted to the axes about which a part may turn. Nodes that are held in one
/// direction, as those in a mirror plane, leave the axis along it; in two directions, none.
template <class T> Mat3<T> free_compliance(const Mat3<T> &inertia, std::uint8_t held) {
  if (held == held_none) return inverse<T>(inertia);
  Mat3<T> compliance = Mat3<T>::Zero();
  for (int d = 0; d < 3; ++d)
    if (held == (1 << d)) compliance(d, d) = T(1) / inertia(d, d);
  return compliance;
}

/// A rigid part of the nodes as they lie and move now: their mean velocity and their angular momentum become the
/// part's. It turns about every axis that the held nodes leave. A part that can turn about none is one without `arms`.
/// Throws SetupError for nodes without mass, or on a line.
template <class T> RigidPart<T> make_rigid_part(const Nodes<T> &nodes, NodeRange range) {
  const std::uint8_t held = held_directions(nodes, range);
  const bool one_direction = held == held_none || held == held_x || held == held_y || held == held_z;
  const Inertia<T> now = inertia_of(nodes, range);
  require(now.mass > T(0), "mass of a rigid part (kg)", now.mass, "must be positive");
  RigidPart<T> part{range};
  if (!one_direction) return part;
  for (int d = 0; d < 3; ++d)
    if (held == (1 << d))
      require(now.tensor(d, d) > T(0), "moment of inertia of a rigid part (kg m2)", now.tensor(d, d),
              "must be positive");
  require(held != held_none || determinant<T>(now.tensor) > T(1e-9) * std::pow(now.tensor.trace(), 3),
          "determinant of the inertia of a rigid part", determinant<T>(now.tensor),
          "must be positive: its nodes must not lie on a line");
  part.mass = now.mass, part.inertia = now.tensor, part.compliance = free_compliance<T>(now.tensor, held);
  part.centre = now.centre, part.velocity = now.velocity;
  part.angular_momentum = now.angular_momentum;
  for (int d = 0; d < 3; ++d) {
    if (held & (1 << d)) part.velocity[d] = T(0);
    if (held != held_none && held != (1 << d)) part.angular_momentum[d] = T(0);
  }
  for (Index n = range.begin; n < range.end; ++n) part.arms.push_back(nodes.position[n] - now.centre);
  return part;
}

/// The turn (rad, a vector along the axis) over `dt` (s) of a body with this inertia and angular momentum, all in the
/// body's axes at the start: the solution of sum m r x (turn of r) = dt l, with which the angular momentum of points of
/// mass that move along chords is exactly l (Moser & Veselov 1991, Commun. Math. Phys. 139:217).
template <class T>
Vec3<T> turn_of(const Mat3<T> &inertia, const Mat3<T> &compliance, const Vec3<T> &angular_momentum, T dt) {
  Vec3<T> turn = dt * (compliance * angular_momentum);
  // Contracts by about the angle, 1e-3 for a fast projectile, each time.
  for (int k = 0; k < 50; ++k) {
    const T angle2 = turn.squaredNorm(), angle = std::sqrt(angle2);
    const bool small = angle < T(1e-2);
    const T sine = small ? T(1) - angle2 / T(6) * (T(1) - angle2 / T(20)) : std::sin(angle) / angle;
    const T versed = small ? T(0.5) - angle2 / T(24) * (T(1) - angle2 / T(30)) : (T(1) - std::cos(angle)) / angle2;
    const Vec3<T> about = cross<T>(turn, Vec3<T>(inertia * turn));
    const Vec3<T> next = compliance * Vec3<T>(dt * angular_momentum - versed * about) / sine;
    const bool settled = (next - turn).norm() <= T(4) * std::numeric_limits<T>::epsilon() * next.norm();
    turn = next;
    if (settled) break;
  }
  return turn;
}

/// Gives the nodes of a rigid part that does not turn the forces that accelerate them as one.
template <class T> void accelerate_as_one(const RigidPart<T> &part, Nodes<T> &nodes) {
  const Index begin = part.nodes.begin, n = part.nodes.size();
  const T mass = ordered_sum(n, T(0), [&](Index i) { return nodes.mass[begin + i]; });
  const Vec3<T> force = ordered_sum(n, Vec3<T>(Vec3<T>::Zero()), [&](Index i) { return nodes.force[begin + i]; });
  std::uint8_t held = held_none;
  for (Index i = 0; i < n; ++i) held |= nodes.held[begin + i];
  Vec3<T> acceleration = force / mass;
  for (int d = 0; d < 3; ++d)
    if (held & (1 << d)) acceleration[d] = T(0);
  parallel_for(n, [&](Index i) { nodes.force[begin + i] = nodes.mass[begin + i] * acceleration; });
}

/// Moves a rigid part over `dt` (s) by the forces on its nodes, which change its velocities over `dt_mid` (s), and
/// gives the nodes the forces with which integrate() takes them there: along chords, so that the ledger of the energy
/// is that of points of mass. Distances between nodes never grow, because every step begins with the arms.
template <class T> void rigidify(RigidPart<T> &part, Nodes<T> &nodes, T dt_mid, T dt) {
  if (!turns(part)) return accelerate_as_one(part, nodes);
  const Index begin = part.nodes.begin, n = part.nodes.size();
  const std::uint8_t held = held_directions(nodes, part.nodes);
  const Vec3<T> force = ordered_sum(n, Vec3<T>(Vec3<T>::Zero()), [&](Index i) { return nodes.force[begin + i]; });
  const Vec3<T> moment = ordered_sum(n, Vec3<T>(Vec3<T>::Zero()), [&](Index i) -> Vec3<T> {
    return cross<T>(Vec3<T>(nodes.position[begin + i] - part.centre), nodes.force[begin + i]);
  });
  for (int d = 0; d < 3; ++d) {
    if (!(held & (1 << d))) part.velocity[d] += dt_mid / part.mass * force[d];
    if (held == held_none || held == (1 << d)) part.angular_momentum[d] += dt_mid * moment[d];
  }
  const Mat3<T> before = matrix_of(part.orientation);
  const Vec3<T> turn =
      turn_of<T>(part.inertia, part.compliance, Vec3<T>(before.transpose() * part.angular_momentum), dt);
  part.orientation = combined(part.orientation, rotation_by<T>(turn));
  part.centre += dt * part.velocity;
  const Mat3<T> after = matrix_of(part.orientation);
  parallel_for(n, [&](Index i) {
    const Index node = begin + i;
    const Vec3<T> target = part.centre + after * part.arms[i];
    const Vec3<T> velocity = (target - nodes.position[node]) / dt;
    nodes.force[node] = nodes.mass[node] / dt_mid * (velocity - nodes.velocity[node]);
  });
}

} // namespace ogive
