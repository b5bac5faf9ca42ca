// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/small_shot.hpp"

#include "ogive/perforation/motion.hpp"
#include "ogive/perforation/projectile_library.hpp"

#include <numbers>
#include <set>

using namespace sim_test;

namespace {

using V = Vec3<double>;

/// A projectile of the library before a small plate, with a metal of this law.
auto shot_of(const Projectile<double> &p, Extent extent = Extent::quarter) {
  auto c = small_case(Nose::blunt, extent);
  c.projectile = p.shape, c.projectile_mass = p.mass, c.rigid_projectile = p.rigid;
  // The programs have lead and gilding metal; here all parts are of the core's steel.
  return make_perforation(c, std::vector{with_law<AnyFlowLaw<double>>(library::weldox_460e_mjc<double>())},
                          std::vector(part_names(p.shape).size(), p.metal), {}, AnyDiscretisation{});
}

} // namespace

TEST_CASE("projectiles of the library have the mass and the sizes of their sources", "[perforation]") {
  std::set<std::string> names;
  for (const auto &p : library::all_projectiles<double>()) {
    CAPTURE(p.name);
    names.insert(p.name);
    CHECK_FALSE(p.source.empty());
    CHECK_NOTHROW(check(p.shape));
    CHECK_NOTHROW(check(p.metal));
    const auto model = shot_of(p);
    const double expected = p.mass > 0 ? p.mass : mass(p.shape, p.metal.density);
    // A given mass is that of the hexes; others lack 1.3 % where a coarse mesh of a sphere has facets.
    CHECK(projectile_mass(model) ==
          Approx(expected).epsilon(p.mass > 0 && p.shape.nose == Nose::chisel ? 1e-12 : 0.015));
    if (!p.part_metals.empty()) {
      CHECK(p.part_metals.size() == model.bodies.projectile.size());
      continue; // not all of steel
    }
    // A given mass leaves the metal a steel: the sizes of the bullet's core are quoted, and 3.6 % off.
    CHECK(projectile(model).metal.density == Approx(7850).epsilon(0.04));
  }
  CHECK(names == std::set<std::string>{"blunt", "conical", "ogival", "hemispherical", "sphere", "apm2_762",
                                       "apm2_762_core", "fsp_20mm", "fsp_127mm"});
  const auto core = library::apm2_762_core<double>();
  CHECK(length(core.shape) == Approx(27.6e-3));
  CHECK(ogive_radius(core.shape) == Approx(3 * 6.17e-3));
  CHECK(core.rigid);
  const auto fsp = library::fsp_20mm<double>();
  // 22.0 mm of a plain cylinder, and the two wedges.
  CHECK(length(fsp.shape) == Approx(22.66e-3).epsilon(0.01));
  CHECK(volume(fsp.shape) * 7850 == Approx(53.78e-3));
}

TEST_CASE("a projectile of any law flows by it", "[perforation]") {
  auto p = library::tool_steel_projectile<double>(Nose::blunt);
  const auto hard = shot_of(p);
  p.metal = with_law<AnyFlowLaw<double>>(library::weldox_460e_jc<double>());
  auto soft = shot_of(p);
  for (auto *model : {&soft})
    for (int k = 0; k < 60; ++k) step(*model, stable_time_step(*model));
  const auto &strain = projectile(soft).points.plastic_strain;
  CHECK(*std::max_element(strain.begin(), strain.end()) > 0.01);
  CHECK(fingerprint(soft) != fingerprint(hard));
}

TEST_CASE("pitch and yaw turn the projectile about its centre, on the line of flight", "[perforation]") {
  auto c = small_case(Nose::conical, Extent::full);
  c.clamp_radius = 60e-3;
  c.sph_radius = 40e-3, c.spacing = 2e-3;
  c.obliquity = 0.3, c.pitch = 0.2, c.yaw = -0.1;
  const HexMesh<double> straight = projectile_mesh(c.projectile, c.spacing, Extent::full);
  const HexMesh<double> turned = in_line_of_flight(straight, c);
  const V axis = direction_of_axis(c), flight = direction_of_flight(c);
  CHECK(axis.norm() == Approx(1));
  CHECK(std::acos(axis.dot(flight)) == Approx(std::acos(std::cos(0.2) * std::cos(0.1))));
  CHECK(axis[1] == Approx(std::sin(-0.1)));
  double lowest = 1, tip = -1, tail = 1;
  for (const V &p : turned.positions)
    lowest = std::min(lowest, p[2]), tip = std::max(tip, p.dot(axis)), tail = std::min(tail, p.dot(axis));
  CHECK(std::abs(lowest) < 1e-12);
  CHECK(tip - tail == Approx(98e-3));
  // The centre of volume, by the volumes of the hexes: on the line of flight through the middle of the plate.
  V centre = V::Zero();
  for (Index e = 0; e < static_cast<Index>(turned.hexes.size()); ++e) {
    const Corners<double> x = corners(turned, e);
    centre += hex_volume<double>(x) * x.colwise().mean().transpose();
  }
  centre /= volume(turned);
  CHECK((centre - flight * flight.dot(centre)).norm() < 1e-6);
  CHECK(volume(turned) == Approx(volume(straight)).epsilon(1e-12));
  CHECK_NOTHROW(check(c));
  c.extent = Extent::half;
  CHECK_THROWS_AS(check(c), SetupError);
  c.yaw = 0;
  CHECK_NOTHROW(check(c));
  c.sph_radius = 22e-3;
  CHECK_THROWS_AS(check(c), SetupError);
}

TEST_CASE("the motion of a projectile: speed, direction, turn of the axis and spin", "[perforation]") {
  auto c = turning_case(Extent::half);
  c.pitch = 0.1;
  c.sph_radius = 30e-3;
  auto model = small_shot(c);
  const auto places = axial_places(model, c);
  auto motion = motion_of(model, c, places);
  CHECK(motion.speed == Approx(300));
  CHECK(motion.deflection < 1e-12);
  CHECK(motion.turn < 1e-6);
  CHECK((motion.axis - direction_of_axis(c)).norm() < 1e-6);
  CHECK(motion.spin.norm() < 1e-9);
  // Turned by 0.2 rad about +y, and with a spin and a velocity of its own.
  const NodeRange range = projectile(model).nodes;
  const V centre = inertia_of(model.nodes, range, model.symmetry).centre;
  for (Index n = range.begin; n < range.end; ++n) {
    const V arm = model.nodes.position[n] - centre;
    V &p = model.nodes.position[n];
    p = centre +
        V(std::cos(0.2) * arm[0] + std::sin(0.2) * arm[2], arm[1], std::cos(0.2) * arm[2] - std::sin(0.2) * arm[0]);
    model.nodes.velocity[n] = V(0, 0, -100) + cross<double>(V(0, 500, 0), V(p - centre));
  }
  motion = motion_of(model, c, places);
  CHECK(motion.speed == Approx(100));
  CHECK(motion.deflection == Approx(std::numbers::pi / 6));
  CHECK(motion.turn == Approx(0.2));
  CHECK((motion.spin - V(0, 500, 0)).norm() < 1e-9);
}
