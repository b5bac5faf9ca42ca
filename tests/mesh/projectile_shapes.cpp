// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "fem/brick.hpp"

#include "ogive/mesh/projectile.hpp"

#include <numbers>

using namespace fem_test;

namespace {

constexpr double pi = std::numbers::pi;

/// Volume of a chisel's nose by slices across x.
double sliced_chisel(const ProjectileShape<double> &s) {
  const int n = 200000;
  const double radius = s.diameter / 2;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = radius * (i + 0.5) / n;
    sum += 4 * std::sqrt(radius * radius - x * x) * (s.nose_length - chisel_depth(s, x)) * radius / n;
  }
  return sum;
}

/// A truncated cone in front of a cylinder, 20 mm in diameter.
const Profile<double> cone{{0, 2e-3}, {10e-3, 10e-3}, {40e-3, 10e-3}};

} // namespace

TEST_CASE("a chisel lacks two wedges, a boat tail the ring around a cone, a sphere nothing", "[mesh]") {
  const auto chisel = default_projectile<double>(Nose::chisel);
  CHECK(chisel_volume(chisel) == Approx(sliced_chisel(chisel)).epsilon(1e-8));
  CHECK(chisel_depth(chisel, 4e-3) == 0);
  CHECK(chisel_depth(chisel, -10e-3) == Approx(3.7e-3));
  CHECK(volume(default_projectile<double>(Nose::sphere)) == Approx(4.0 / 3 * pi * 1e-6));
  auto tailed = paper_projectile<double>(Nose::blunt);
  tailed.tail_length = 9e-3, tailed.tail_diameter = 10e-3;
  // Cylinder of 9 mm less the frustum between radii of 10 and 5 mm, by hand.
  CHECK(volume(paper_projectile<double>(Nose::blunt)) - volume(tailed) ==
        Approx(pi * 9e-3 * (1e-4 - (1e-4 + 5e-5 + 2.5e-5) / 3)));
  CHECK(radius_at(tailed, 71e-3) == Approx(10e-3));
  CHECK(radius_at(tailed, 75.5e-3) == Approx(7.5e-3));
  CHECK(radius_at(tailed, 80e-3) == Approx(5e-3));
}

TEST_CASE("a profile is the body of its frusta", "[mesh]") {
  CHECK(volume(cone) == Approx(pi * (10e-3 / 3 * (4e-6 + 2e-5 + 1e-4) + 30e-3 * 1e-4)));
  CHECK(radius_at(cone, 5e-3) == Approx(6e-3));
  CHECK(radius_at(cone, -1.0) == 2e-3);
  CHECK(radius_at(cone, 1.0) == 10e-3);
  CHECK(kinks(cone, 1e-3) == std::vector<double>{0, 10e-3, 40e-3});
  CHECK(kinks(cone, 15e-3) == std::vector<double>{0, 40e-3});
  const auto shape = projectile_of(cone);
  CHECK(shape.diameter == Approx(20e-3));
  CHECK(length(shape) == Approx(40e-3));
  CHECK(nose_height(shape) == Approx(10e-3));
  CHECK(is_sharp(shape));
}

TEST_CASE("meshes of all shapes have good hexes, the volume of the shape and a closed surface", "[mesh]") {
  auto tailed = paper_projectile<double>(Nose::ogival);
  tailed.tail_length = 10e-3, tailed.tail_diameter = 15e-3;
  auto blunt_tail = paper_projectile<double>(Nose::blunt);
  blunt_tail.tail_length = 10e-3, blunt_tail.tail_diameter = 15e-3;
  auto round_tail = paper_projectile<double>(Nose::hemispherical);
  round_tail.tail_length = 10e-3, round_tail.tail_diameter = 15e-3;
  const std::vector<ProjectileShape<double>> shapes{default_projectile<double>(Nose::chisel),
                                                    default_projectile<double>(Nose::sphere),
                                                    projectile_of(cone),
                                                    tailed,
                                                    blunt_tail,
                                                    round_tail};
  for (const auto &shape : shapes)
    for (const double spacing : {0.8e-3, 2.4e-3}) {
      CAPTURE(name(shape.nose), spacing, shape.tail_length);
      const auto quarter = projectile_mesh(shape, spacing, Extent::quarter);
      CHECK(mesh_quality(quarter).smallest_scaled_jacobian > 0.6);
      // Facets for curves: a sphere of 16 facets around lacks 1.3 %.
      CHECK(4 * volume(quarter) == Approx(volume(shape)).epsilon(0.015));
      double front = 1, rear = 0;
      for (const V &p : quarter.positions) front = std::min(front, p[2]), rear = std::max(rear, p[2]);
      CHECK(std::abs(front) < 1e-12);
      CHECK(rear == Approx(length(shape)).epsilon(0.007));
      const auto full = projectile_mesh(shape, spacing, Extent::full);
      CHECK(volume(full) == Approx(4 * volume(quarter)).epsilon(1e-12));
      // The outer surface of the quarter is a quarter of the full one's: no seam is open, inside or in a mirror plane.
      CHECK(4 * contact_facets(quarter, Extent::quarter).size() == boundary_facets(full).size());
    }
}

TEST_CASE("the front of a chisel's mesh lies on its flats", "[mesh]") {
  const auto shape = default_projectile<double>(Nose::chisel);
  const auto mesh = projectile_mesh(shape, 0.8e-3, Extent::half);
  int on_flats = 0;
  for (const Facet &f : boundary_facets(mesh)) {
    bool front = true;
    for (const Index n : f.nodes)
      front = front && std::abs(mesh.positions[n][2] - chisel_depth(shape, mesh.positions[n][0])) < 1e-12;
    on_flats += front;
  }
  CHECK(on_flats > 30);
}

TEST_CASE("a mesh that is badly shaped or lacks volume is refused", "[mesh]") {
  const auto refusal = [](const Profile<double> &profile, double spacing) {
    return setup_error_of([&] { projectile_mesh(projectile_of(profile), spacing, Extent::quarter); });
  };
  // The side of the cone is inclined by 84 degrees against the axis.
  CHECK(contains(refusal({{0, 2e-3}, {0.8e-3, 10e-3}, {40e-3, 10e-3}}, 0.6e-3), "smallest scaled Jacobian"));
  // A groove of 2 mm between hexes of 8 mm.
  CHECK(contains(refusal({{0, 10e-3}, {3e-3, 10e-3}, {4e-3, 5e-3}, {5e-3, 10e-3}, {10e-3, 10e-3}}, 5e-3),
                 "volume of the projectile's hexes"));
  CHECK(contains(refusal({{0, 1e-4}, {10e-3, 10e-3}}, 1e-3), "radius of point 1 of the profile (m) = 0.0001"));
  CHECK(contains(refusal({{0, 1e-3}, {0, 10e-3}}, 1e-3), "z of point 2 of the profile (m) = 0"));
  CHECK(contains(refusal({{0, 1e-3}}, 1e-3), "points of the profile = 1: must be 2 to 10000"));
  auto tail = paper_projectile<double>(Nose::blunt);
  tail.tail_length = 80e-3, tail.tail_diameter = 15e-3;
  CHECK(contains(setup_error_of([&] { check(tail); }), "tail length (m) = 0.08"));
  tail.tail_length = 8e-3, tail.tail_diameter = 4e-3;
  CHECK(contains(setup_error_of([&] { check(tail); }), "tail diameter (m) = 0.004"));
  auto chisel = default_projectile<double>(Nose::chisel);
  chisel.nose_length = 11e-3;
  CHECK(contains(setup_error_of([&] { check(chisel); }), "nose length (m) = 0.011"));
}
