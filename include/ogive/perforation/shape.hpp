// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/perforation/plug.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ogive {

/// Measures of a plate's deformation that distinguish modes of failure. SI units; a radius or a
/// layer is that of the undeformed plate, R the projectile's radius.
template <class T> struct PlateShape {
  T plug_thickness{};   ///< m, between the plug's front and rear faces within R/2; 0 without a plug or with a face gone
  T dishing{};          ///< m, mean deflection at radii of 1.4 R to 1.6 R, positive in the direction of flight
  T kept_fraction{};    ///< of the mass in the projectile's way (radius < R) that still hangs on the plate
  T petal_height{};     ///< m, how far what hangs on the plate reaches beyond its undeformed rear face
  int petals = 0;       ///< around the hole of the whole model, see count_petals()
  T hole_diameter{};    ///< m, see hole_diameter_of()
  T band_temperature{}; ///< K, mean within one particle distance of the radius R
  T core_temperature{}; ///< K, mean within R/2
  T most_temperature{}; ///< K, of the hottest particle
};

/// Positions of the particles of a plate, m, to be kept from before the first step.
template <class M> auto plate_positions(const M &model, std::size_t layer = 0) {
  const auto &x = model.nodes.position;
  const NodeRange range = plate_particles(model, layer).nodes;
  return std::vector(x.begin() + range.begin, x.begin() + range.end);
}

/// Mean deflection of a plate now at radii of 1.4 to 1.6 times `radius` (m) of the projectile, m, positive in
/// the direction of flight. `undeformed` are the positions before, m.
template <class M, class T>
T dishing_of(const M &model, const std::vector<Vec3<T>> &undeformed, T radius, std::size_t layer = 0) {
  const auto &body = plate_particles(model, layer);
  T sum{}, weight{};
  for (Index i = 0; i < body.points.size(); ++i) {
    const Vec3<T> &x0 = undeformed[i];
    if (!(std::abs(std::hypot(x0[0], x0[1]) - T(1.5) * radius) < T(0.1) * radius)) continue;
    sum += body.point_mass[i] * (x0[2] - model.nodes.position[body.nodes.begin + i][2]);
    weight += body.point_mass[i];
  }
  return weight > T(0) ? sum / weight : T(0);
}

/// Petals of a rim whose mass (kg) is given at equal angles around the whole hole. A petal is between two notches where
/// less than half of the mean is left; a tube without notches has none.
template <class T> int count_petals(const std::vector<T> &rim) {
  T mean{};
  for (const T m : rim) mean += m / static_cast<T>(rim.size());
  // Between the two bounds the state of the angle before holds, so that roughness of the rim does not count.
  int state = 0, first = 0, changes = 0;
  for (const T m : rim) {
    const int here = m > mean ? 1 : m < mean / T(2) ? -1 : state;
    if (first == 0) first = here;
    if (state != 0 && here != state) ++changes;
    state = here;
  }
  if (first != 0 && state != first) ++changes;
  return changes / 2;
}

namespace shape_detail {

/// Number of equal angles of the whole circle that are as wide as two particle distances (m) at `radius` (m).
template <class T> std::size_t angles_at(T radius, T spacing) {
  return 4 * static_cast<std::size_t>(std::max(T(2), std::floor(std::numbers::pi_v<T> / T(4) * radius / spacing)));
}

/// Calls visit(k) with the angle, of `count` equal ones of the whole circle, of a particle at p (m) and of its images.
template <class M, class T, class Visit>
void for_angles(const M &model, const Vec3<T> &p, std::size_t count, Visit &&visit) {
  const T angle = T(2) * std::numbers::pi_v<T> / static_cast<T>(count);
  for (const T x : {T(1), T(-1)})
    for (const T y : {T(1), T(-1)}) {
      if ((x < T(0) && !model.symmetry.x) || (y < T(0) && !model.symmetry.y)) continue;
      const T turned = std::atan2(y * p[1], x * p[0]);
      const T positive = turned < T(0) ? turned + T(2) * std::numbers::pi_v<T> : turned;
      visit(std::min(static_cast<std::size_t>(positive / angle), count - 1));
    }
}

} // namespace shape_detail

/// Mass of the particles of a plate by their angle about its axis, kg, for equal angles of the whole circle that are as
/// wide as two particle distances at `radius` (m). `mass_of(i)` is that of particle i which counts, kg.
template <class M, class T, class MassOf>
std::vector<T> mass_by_angle(const M &model, T radius, MassOf &&mass_of, std::size_t layer = 0) {
  const auto &body = plate_particles(model, layer);
  std::vector<T> sums(shape_detail::angles_at(radius, body.spacing), T(0));
  for (Index i = 0; i < body.points.size(); ++i)
    if (const T mass = mass_of(i); mass > T(0))
      shape_detail::for_angles(model, model.nodes.position[body.nodes.begin + i], sums.size(),
                               [&](std::size_t k) { sums[k] += mass; });
  return sums;
}

/// Mean diameter of the hole in a plate, m: over equal angles as wide as two particle distances at `radius` (m), of
/// what lies nearest to the axis there, at any depth. `hangs(i)`: whether particle i belongs to the plate; what lies
/// within two particle distances of the axis closes the hole, which then is 0.
template <class M, class T, class Hangs>
T hole_diameter_of(const M &model, T radius, Hangs &&hangs, std::size_t layer = 0) {
  const auto &body = plate_particles(model, layer);
  std::vector<T> nearest(shape_detail::angles_at(radius, body.spacing), std::numeric_limits<T>::infinity());
  for (Index i = 0; i < body.points.size(); ++i) {
    if (!hangs(i)) continue;
    const Vec3<T> &p = model.nodes.position[body.nodes.begin + i];
    const T r = std::hypot(p[0], p[1]);
    if (r < T(2) * body.spacing) return T(0);
    shape_detail::for_angles(model, p, nearest.size(), [&](std::size_t k) { nearest[k] = std::min(nearest[k], r); });
  }
  T sum{}, count{};
  for (const T r : nearest)
    if (std::isfinite(r)) sum += T(2) * r - body.spacing, count += T(1);
  return count > T(0) ? sum / count : T(0);
}

/// A plate's shape now, from its particles and their undeformed positions (m), for a projectile of this radius (m) and
/// a plate at `plate`.
template <class M, class T>
PlateShape<T> plate_shape(const M &model, const std::vector<Vec3<T>> &undeformed, T radius, const Layer<T> &plate,
                          std::size_t layer = 0) {
  const auto &body = plate_particles(model, layer);
  const T spacing = body.spacing, rear_face = plate.front + plate.thickness;
  const Pieces pieces = find_pieces(model, 1.5, layer);
  struct Mean {
    T sum{}, weight{};
    void add(T value, T w) { sum += w * value, weight += w; }
    T value() const { return weight > T(0) ? sum / weight : T(0); }
  };
  Mean front, rear, kept, band, core;
  PlateShape<T> shape;
  std::vector<T> reach(body.points.size(), T(0));
  for (Index i = 0; i < body.points.size(); ++i) {
    const Vec3<T> &x0 = undeformed[i], &x = model.nodes.position[body.nodes.begin + i];
    const T r = std::hypot(x0[0], x0[1]), mass = body.point_mass[i], temperature = body.points.temperature[i];
    const bool in_plug = pieces.of[i] == pieces.plug, hangs = pieces.hangs(i);
    if (in_plug && r < radius / T(2)) {
      if (x0[2] > -plate.front - spacing) front.add(x[2], mass);
      if (x0[2] < spacing - rear_face) rear.add(x[2], mass);
    }
    if (r < radius) kept.add(hangs ? T(1) : T(0), mass);
    if (hangs) reach[i] = -x[2] - rear_face + spacing / T(2);
    if (std::abs(r - radius) < spacing) band.add(temperature, mass);
    if (r < radius / T(2)) core.add(temperature, mass);
    shape.most_temperature = std::max(shape.most_temperature, temperature);
  }
  if (front.weight > T(0) && rear.weight > T(0)) shape.plug_thickness = front.value() - rear.value() + spacing;
  shape.dishing = dishing_of(model, undeformed, radius, layer);
  shape.kept_fraction = kept.value();
  for (const T h : reach) shape.petal_height = std::max(shape.petal_height, h);
  // Cracks between petals are seen above half of their height, and where the metal is now.
  const auto of_rim = [&](Index i) { return reach[i] > shape.petal_height / T(2) ? body.point_mass[i] : T(0); };
  if (shape.petal_height > T(2) * spacing) shape.petals = count_petals(mass_by_angle(model, radius, of_rim, layer));
  shape.hole_diameter = hole_diameter_of(
      model, radius, [&](Index i) { return pieces.hangs(i); }, layer);
  shape.band_temperature = band.value();
  shape.core_temperature = core.value();
  return shape;
}

/// Shape of the only plate, or the first one, of this thickness (m).
template <class M, class T>
PlateShape<T> plate_shape(const M &model, const std::vector<Vec3<T>> &undeformed, T radius, T thickness) {
  return plate_shape(model, undeformed, radius, Layer<T>{T(0), thickness});
}

} // namespace ogive
