// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/perforation/shape.hpp"

using namespace ogive;

namespace {

auto plate_and_shot(Nose nose, Extent extent) {
  PerforationCase<double> c;
  c.thickness = 6e-3;
  c.clamp_radius = 60e-3;
  c.sph_radius = 16e-3;
  c.spacing = 1e-3;
  c.projectile = paper_projectile<double>(nose);
  c.extent = extent;
  auto model = make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
  prepare(plate_particles(model), model.nodes);
  return model;
}

} // namespace

TEST_CASE("a whole plate has no plug", "[perforation]") {
  const auto model = plate_and_shot(Nose::blunt, Extent::quarter);
  const auto f = find_fragments(model);
  CHECK(f.pieces == 0);
  CHECK(f.plug_mass == 0);
  CHECK(f.debris_mass == 0);
}

TEST_CASE("a cylinder moved out of the plate is the plug, a lone particle debris", "[perforation]") {
  const Extent extent = GENERATE(Extent::full, Extent::half, Extent::quarter);
  auto model = plate_and_shot(Nose::blunt, extent);
  auto &body = plate_particles(model);
  double mass = 0, debris = 0;
  Index lone = -1;
  for (Index i = 0; i < body.nodes.size(); ++i) {
    Vec3<double> &p = model.nodes.position[body.nodes.begin + i];
    const double r = std::hypot(p[0], p[1]);
    if (r < 10e-3) {
      mass += body.point_mass[i];
      p[2] -= 9e-3;
      model.nodes.velocity[body.nodes.begin + i] = {5, -3, -150};
    } else if (lone < 0 && r > 12e-3 && r < 14e-3) {
      lone = i;
      debris = body.point_mass[i];
      p[2] += 30e-3;
      model.nodes.velocity[body.nodes.begin + i] = {0, 0, 400};
    }
  }
  REQUIRE(lone >= 0);
  prepare(body, model.nodes);
  const auto f = find_fragments(model);
  CHECK(f.pieces == 2);
  CHECK(f.plug_mass == Approx(model.symmetry.copies() * mass));
  CHECK(f.plug_mass == Approx(7850 * 3.14159 * 100e-6 * 6e-3).epsilon(0.05)); // 15 g, the layout's staircase
  CHECK(f.plug_velocity == Approx(150));
  CHECK(f.debris_mass == Approx(model.symmetry.copies() * debris));
}

TEST_CASE("the intrusion is the depth of the deepest particle in the projectile", "[perforation]") {
  const Extent extent = GENERATE(Extent::full, Extent::quarter);
  auto model = plate_and_shot(Nose::blunt, extent);
  CHECK(largest_intrusion(model) == 0);
  auto &p = model.nodes.position;
  const Index first = plate_particles(model).nodes.begin;
  p[first] = {2.3e-3, 1.1e-3, 0.7e-3}; // above the flat face
  CHECK(largest_intrusion(model) == Approx(0.7e-3).epsilon(1e-6));
  p[first + 1] = {3.1e-3, 2.2e-3, 1.2e-3};
  CHECK(largest_intrusion(model) == Approx(1.2e-3).epsilon(1e-6));
  p[first + 2] = {6e-3, 4.5e-3, 40e-3}; // 2.5 mm inside the shank, whose polygon lies within 2 % of the circle
  CHECK(largest_intrusion(model) == Approx(2.5e-3).margin(0.2e-3));
  p[first + 3] = {8e-3, 7e-3, 5e-3}; // in the projectile's box but outside: at a radius of 10.6 mm
  CHECK(largest_intrusion(model) == Approx(2.5e-3).margin(0.2e-3));
  // Behind a facet, but the hex that held it is gone.
  auto &shot = projectile(model);
  allow_erosion(shot);
  for (Index e = 0; e < static_cast<Index>(shot.hexes.size()); ++e)
    if (lies_in_hex<double>(gather_corners(p, shot.hexes[e]), p[first + 2])) remove_hex(shot, model.nodes, e, 0.0);
  CHECK(largest_intrusion(model) == Approx(1.2e-3).epsilon(1e-6));
}

TEST_CASE("the plate's shape tells a plug from a bulge", "[perforation]") {
  auto model = plate_and_shot(Nose::blunt, Extent::quarter);
  auto &body = plate_particles(model);
  const auto undeformed = plate_positions(model);
  const auto place = [&](auto &&moved) {
    for (Index i = 0; i < body.nodes.size(); ++i) {
      const Vec3<double> &x0 = undeformed[i];
      model.nodes.position[body.nodes.begin + i] = moved(x0, std::hypot(x0[0], x0[1]));
    }
    prepare(body, model.nodes);
    return plate_shape(model, undeformed, 10e-3, 6e-3);
  };

  const auto whole = place([](const Vec3<double> &x, double) { return x; });
  CHECK(whole.plug_thickness == 0);
  CHECK(whole.dishing == 0);
  CHECK(whole.kept_fraction == Approx(1));
  CHECK(whole.hole_diameter == 0);
  CHECK(whole.petal_height == Approx(0).margin(1e-12)); // the rear layer lies half a particle distance inside
  CHECK(whole.band_temperature == Approx(293));

  // A plug compressed by a tenth leaves; the plate dishes by 0.4 mm where it is read.
  for (Index i = 0; i < body.nodes.size(); ++i)
    body.points.temperature[i] = std::abs(std::hypot(undeformed[i][0], undeformed[i][1]) - 10e-3) < 1e-3 ? 900 : 350;
  const auto plugged = place([](const Vec3<double> &x, double r) {
    if (r < 10e-3) return Vec3<double>(x[0], x[1], 0.9 * x[2] - 20e-3);
    return Vec3<double>(x[0], x[1], x[2] - 0.4e-3);
  });
  // Layers stand one particle distance apart, so that the faces lie half of one beyond the outermost.
  CHECK(plugged.plug_thickness == Approx(0.9 * 5e-3 + 1e-3).epsilon(1e-6));
  CHECK(plugged.dishing == Approx(0.4e-3).epsilon(1e-6));
  CHECK(plugged.kept_fraction == 0);
  CHECK(plugged.hole_diameter == Approx(20e-3).margin(1e-3)); // to a particle distance
  CHECK(plugged.petal_height == Approx(0.4e-3).epsilon(1e-6));
  CHECK(plugged.band_temperature == Approx(900));
  CHECK(plugged.core_temperature == Approx(350));
  CHECK(plugged.most_temperature == 900);
}

TEST_CASE("petals are counted around the whole hole", "[perforation]") {
  const auto rim = [](int petals, double notch) {
    std::vector<double> mass;
    for (int k = 0; k < 48; ++k) mass.push_back(5e-3 * (petals > 0 && (k * petals) % 48 < petals * 2 ? notch : 1));
    return mass;
  };
  CHECK(count_petals(rim(0, 0)) == 0);                                 // a tube
  CHECK(count_petals(rim(4, 0)) == 4);                                 // cracks
  CHECK(count_petals(rim(4, 0.6)) == 0);                               // an uneven rim
  CHECK(count_petals(std::vector{1.0, 6.0, 4.0, 6.0, 1.0, 6.0}) == 2); // through the first angle

  // A lip behind the plate, 4 mm high, with a notch along the diagonal of a quarter: four in the whole plate.
  auto model = plate_and_shot(Nose::conical, Extent::quarter);
  const auto undeformed = plate_positions(model);
  auto &body = plate_particles(model);
  const auto petals = [&](double height, double notch) {
    for (Index i = 0; i < body.nodes.size(); ++i) {
      const Vec3<double> &x = undeformed[i];
      const double r = std::hypot(x[0], x[1]);
      const bool lip = r < 13e-3 && r > 9e-3 && std::abs(x[0] - x[1]) >= notch;
      model.nodes.position[body.nodes.begin + i] = x - Vec3<double>(0, 0, lip ? height : 0);
    }
    prepare(body, model.nodes);
    return plate_shape(model, undeformed, 10e-3, 6e-3).petals;
  };
  CHECK(petals(4e-3, 2.5e-3) == 4);
  CHECK(petals(4e-3, 0) == 0);        // a tube
  CHECK(petals(1.2e-3, 2.5e-3) == 0); // lower than two particle distances
}
