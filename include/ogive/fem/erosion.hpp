// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/fem/hex_time_step.hpp"
#include "ogive/mesh/facets.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// \file
/// Hexes that are too distorted to be computed with: which they are, and how they are removed. They would stop the run:
/// without volume they have no gradients, turned inside out their surface has no outside, and the time step of a flat
/// one goes to zero. Codes for impact remove such hexes, by their volume and their time step. That is a remedy of the
/// numerics and no model of fracture.

namespace ogive {

/// Share of its first volume below which a hex, or one of several points, is removed. Metal keeps most of its volume:
/// at 1500 m/s a pressure of some 30 GPa leaves 0.85 of that of steel.
inline constexpr double least_volume_share = 0.3;

/// True if a face of a hex with the corners `x` (m) has turned inside out: its area points to the middle of the hex.
template <class T> bool has_turned_face(const Corners<T> &x) {
  const Vec3<T> inside = x.colwise().mean().transpose();
  for (const std::array<int, 4> &face : hex_faces) {
    const auto at = [&](int k) { return Vec3<T>(x.row(face[k]).transpose()); };
    const Vec3<T> area = cross<T>(Vec3<T>(at(2) - at(0)), Vec3<T>(at(3) - at(1)));
    const Vec3<T> middle = T(0.25) * (at(0) + at(1) + at(2) + at(3));
    if (!(area.dot(middle - inside) > T(0))) return true;
  }
  return false;
}

/// True if hex e is too distorted to be computed with: it or one of several points has lost most of its volume, one of
/// its faces has turned inside out, or its own stable step lies below `least_step` (s).
template <class T, class Law, class Rule>
bool is_too_distorted(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e, T least_step) {
  const Corners<T> x = gather_corners(nodes.position, body.hexes[e]);
  const bool has_volume = with_choice(body.rule, [&]<class Chosen>(Chosen) {
    for (int p = 0; p < Chosen::points; ++p) {
      const T first = body.point_mass[e * Chosen::points + p] / body.metal.density;
      if (!(point_volume<Chosen>(x, p) > T(least_volume_share) * first)) return false;
    }
    return true;
  });
  return !has_volume || has_turned_face(x) || !(stable_time_step_of_hex(body, nodes, e) >= least_step);
}

/// True if the middle of hex e has got across a mirror plane, where its image is: it has lost the hexes that kept it on
/// its side.
template <class T, class Law, class Rule>
bool is_across(const HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e, SymmetryPlanes planes) {
  const Corners<T> x = gather_corners(nodes.position, body.hexes[e]);
  return (planes.x && x.col(0).sum() < T(0)) || (planes.y && x.col(1).sum() < T(0));
}

/// Removes hex e between two steps, the last of which was `dt` (s). It acts on its nodes no more, and they keep their
/// masses. The energy stored in it counts as dissipated, and so does the work that its last forces would still do in
/// the second half of that step: with it the books of central differences close.
template <class T, class Law, class Rule>
void remove_hex(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, Index e, T dt) {
  T power{}, mass{};
  for (int a = 0; a < 8; ++a) {
    Vec3<T> &force = body.corner_force[8 * e + a];
    power += force.dot(nodes.velocity[body.hexes[e][a]]);
    force = Vec3<T>::Zero();
  }
  const Index points = points_of_hex(body);
  for (Index i = e * points; i < (e + 1) * points; ++i) mass += body.point_mass[i];
  for (Index i = e * points; i < (e + 1) * points; ++i) {
    body.points.internal_energy[i] -= T(0.5) * dt * power / mass;
    body.points.deviator[i] = Sym3<T>{};
    body.points.pressure[i] = body.points.plastic_strain_rate[i] = T(0);
    body.points.velocity_gradient[i] = Mat3<T>::Zero();
    body.points.damage[i] = std::max(body.points.damage[i], T(1));
  }
  if (!body.hourglass_force.empty()) body.hourglass_force[e] = HourglassModes<T>::Zero();
  body.viscous_pressure[e] = T(0);
}

/// Removes the hexes of a body that are too distorted or across a mirror plane, see is_too_distorted(), is_across() and
/// remove_hex(), if it erodes and its hexes have at least `least_points` material points. Returns how many there were.
template <class T, class Law, class Rule>
Index erode(HexBody<T, Law, Rule> &body, const Nodes<T> &nodes, SymmetryPlanes planes, T least_step, T dt,
            Index least_points) {
  if (!body.erodes || points_of_hex(body) < least_points) return 0;
  const auto count = static_cast<Index>(body.hexes.size());
  std::vector<std::uint8_t> goes(body.hexes.size(), 0);
  parallel_for(count, [&](Index e) {
    if (!is_removed(body, e))
      goes[e] = is_too_distorted(body, nodes, e, least_step) || is_across(body, nodes, e, planes);
  });
  Index removed = 0;
  for (Index e = 0; e < count; ++e)
    if (goes[e]) remove_hex(body, nodes, e, dt), ++removed;
  return removed;
}

/// Lets the hexes of a body be removed. Those of a metal whose damage grows are removed by that damage alone: no
/// change.
template <class T, class Law, class Rule> void allow_erosion(HexBody<T, Law, Rule> &body) {
  if (body.metal.damage.law != DamageLaw::none) return;
  body.erodes = true;
  body.metal.damage.effect = FailureEffect::removal;
}

/// Number and mass of hexes.
template <class T> struct RemovedHexes {
  Index count = 0; ///< of hexes, in the computed part
  T mass{};        ///< kg, of the computed part
};

/// The hexes of a body that erodes which have been removed.
template <class T, class Law, class Rule> RemovedHexes<T> removed_hexes(const HexBody<T, Law, Rule> &body) {
  RemovedHexes<T> all;
  if (!body.erodes) return all;
  const Index points = points_of_hex(body);
  for (Index e = 0; e < static_cast<Index>(body.hexes.size()); ++e) {
    if (!is_removed(body, e)) continue;
    ++all.count;
    for (Index i = e * points; i < (e + 1) * points; ++i) all.mass += body.point_mass[i];
  }
  return all;
}

} // namespace ogive
