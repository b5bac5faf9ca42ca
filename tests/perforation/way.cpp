// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/perforation/way.hpp"

using namespace ogive;

namespace {

/// A plate and a blunt projectile, `scale` times as large as 6 mm and 20 mm.
auto plate_and_shot(Extent extent, double scale = 1, double obliquity = 0) {
  PerforationCase<double> c;
  c.thickness = 6e-3 * scale;
  c.clamp_radius = 60e-3 * scale;
  c.sph_radius = 30e-3 * scale;
  c.spacing = 1.5e-3 * scale;
  c.projectile = paper_projectile<double>(Nose::blunt);
  c.projectile.diameter *= scale;
  c.projectile.shank_length *= scale;
  c.obliquity = obliquity;
  c.extent = extent;
  auto model = make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
  prepare(plate_particles(model), model.nodes);
  return std::pair(model, direction_of_flight(c));
}

/// Moves the particles nearer than `radius` (m) to the axis through the origin by `shift` (m).
template <class M>
void move_core(M &model, const Vec3<double> &axis, double radius, const Vec3<double> &shift, double velocity) {
  auto &body = plate_particles(model);
  for (Index i = 0; i < body.nodes.size(); ++i) {
    Vec3<double> &p = model.nodes.position[body.nodes.begin + i];
    if ((p - p.dot(axis) * axis).norm() > radius) continue;
    p += shift;
    model.nodes.velocity[body.nodes.begin + i] = velocity * axis;
  }
  prepare(body, model.nodes);
}

template <class M> void move_projectile(M &model, const Vec3<double> &shift) {
  for (Index n = projectile(model).nodes.begin; n < projectile(model).nodes.end; ++n) model.nodes.position[n] += shift;
}

} // namespace

TEST_CASE("a whole plate is in the way, a hole without it not, at any scale and extent", "[perforation]") {
  const Extent extent = GENERATE(Extent::full, Extent::half, Extent::quarter);
  const double scale = GENERATE(0.05, 1, 5);
  auto [model, direction] = plate_and_shot(extent, scale);
  const double radius = 10e-3 * scale;
  CHECK_FALSE(find_way(model, direction, radius, 1.0).clear);
  CHECK(find_way(model, direction, radius, 1.0).plate_velocity == 0);
  SECTION("the plug is ahead, however light") {
    move_core(model, direction, radius, 20e-3 * scale * direction, 150);
    CHECK(find_way(model, direction, radius, 1.0).clear);
  }
  SECTION("the plug is bent to the rear and hangs") {
    move_core(model, direction, radius, 1e-3 * scale * direction, 150);
    CHECK_FALSE(find_way(model, direction, radius, 1.0).clear);
  }
  SECTION("the projectile is beyond everything") {
    move_projectile(model, 200e-3 * scale * direction);
    CHECK(find_way(model, direction, radius, 1.0).clear);
    CHECK(find_way(model, direction, radius, 1.0).plate_velocity == 0);
  }
}

TEST_CASE("a loose plug that is slower takes velocity once it is hit again, a faster one none", "[perforation]") {
  auto [model, direction] = plate_and_shot(GENERATE(Extent::full, Extent::quarter));
  set_velocity(model.nodes, projectile(model).nodes, Vec3<double>(200 * direction));
  double mass = 0, ahead = 0;
  for (Index n = projectile(model).nodes.begin; n < projectile(model).nodes.end; ++n) mass += model.nodes.mass[n];
  move_core(model, direction, 10e-3, 20e-3 * direction, 150);
  const auto &body = plate_particles(model);
  for (Index i = 0; i < body.nodes.size(); ++i) {
    const Vec3<double> &p = model.nodes.position[body.nodes.begin + i];
    if (p[2] < -15e-3 && std::hypot(p[0], p[1]) < 7.5e-3) ahead += body.point_mass[i];
  }
  CHECK(ahead > 0.02 * mass);
  // Momentum is shared: m v = (m + m_plug) v'.
  CHECK(find_way(model, direction, 10e-3, 1.0).later_loss == Approx(50 * ahead / (mass + ahead)));
  move_core(model, direction, 10e-3, {0, 0, 0}, 250);
  CHECK(find_way(model, direction, 10e-3, 1.0).later_loss == 0);
}

TEST_CASE("the plate's velocity is that of what hangs beside the projectile", "[perforation]") {
  auto [model, direction] = plate_and_shot(Extent::quarter);
  const auto range = plate_particles(model).nodes;
  move_core(model, direction, 10e-3, 60e-3 * direction, 150);
  for (Index n = range.begin; n < range.end; ++n)
    if (model.nodes.position[n][2] > -6e-3) model.nodes.velocity[n] = {0, 0, -12};
  move_projectile(model, 10e-3 * direction);
  const auto way = find_way(model, direction, 10e-3, 1.0);
  CHECK(way.clear);
  CHECK(way.inside);
  CHECK(way.plate_velocity == Approx(12));
}

TEST_CASE("a projectile that hardly moves has its way along the line of flight", "[perforation]") {
  auto [model, direction] = plate_and_shot(Extent::full);
  const auto range = projectile(model).nodes;
  for (const Vec3<double> &v : {Vec3<double>(0, 0, 0.5), Vec3<double>(3, 0, -0.5), Vec3<double>(0, 0, 0)}) {
    set_velocity(model.nodes, range, v);
    CHECK_FALSE(find_way(model, direction, 10e-3, 1.0).clear);
  }
}

TEST_CASE("the way of an oblique projectile lies along its motion", "[perforation]") {
  auto [model, direction] = plate_and_shot(Extent::half, 1, 0.5);
  CHECK_FALSE(find_way(model, direction, 10e-3, 1.0).clear);
  move_core(model, direction, 11e-3, 40e-3 * direction, 150);
  CHECK(find_way(model, direction, 10e-3, 1.0).clear);
}
