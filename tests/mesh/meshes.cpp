// SPDX-License-Identifier: BSD-3-Clause
#include "area_vector.hpp"
#include "catch.hpp"
#include "fem/brick.hpp"
#include "ogive/mesh/plate_rim.hpp"
#include "ogive/mesh/projectile.hpp"

#include <numeric>

using namespace fem_test;

namespace {

V total_area(const std::vector<Facet> &facets, const std::vector<V> &positions) {
  V sum = V::Zero();
  for (const Facet &f : facets) sum += area_vector(f, positions);
  return sum;
}

double total_size(const std::vector<Facet> &facets, const std::vector<V> &positions) {
  double sum = 0;
  for (const Facet &f : facets) sum += area_vector(f, positions).norm();
  return sum;
}

const RimShape<double> paper_rim{24e-3, 250e-3, 12e-3, 1.5e-3};

} // namespace

TEST_CASE("the boundary of a brick is its six sides, seen from outside", "[fem]") {
  const auto mesh = brick<double>(2, 3, 4, V(2, 3, 4));
  const auto facets = boundary_facets(mesh);
  CHECK(facets.size() == 2 * (2 * 3 + 3 * 4 + 4 * 2));
  const V centre(1, 1.5, 2);
  for (const Facet &f : facets) {
    const V from_centre = mesh.positions[f.nodes[0]] - centre;
    CHECK(area_vector(f, mesh.positions).dot(from_centre) > 0);
    const auto &hex = mesh.hexes[f.hex];
    for (Index n : f.nodes) CHECK(std::find(hex.begin(), hex.end(), n) != hex.end());
  }
  CHECK(total_area(facets, mesh.positions).norm() < 1e-13);
  CHECK(facets_off_planes(facets, mesh.positions, {true, false}, 0.0).size() == facets.size() - 12);
  CHECK(facets_off_planes(facets, mesh.positions, {true, true}, 0.0).size() == facets.size() - 12 - 8);
  CHECK(shifted(facets, 100)[5].nodes[2] == facets[5].nodes[2] + 100);
  CHECK(facets_where(facets, mesh.positions, [](const V &p) { return p[2] == 4; }).size() == 6);
}

TEST_CASE("projectiles have the analytic volume and mass", "[fem]") {
  for (Nose nose : paper_noses) {
    const auto shape = paper_projectile<double>(nose);
    INFO(name(nose));
    // Simpson's rule over the profile.
    const double end = length(shape), height = nose_height(shape);
    const int n = 2000;
    double integral = std::numbers::pi * 1e-4 * (end - height);
    for (int i = 0; i <= n && height > 0; ++i) {
      const double r = radius_at(shape, height * i / n), weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
      integral += weight * height / (3 * n) * std::numbers::pi * r * r;
    }
    CHECK(volume(shape) == Approx(integral).epsilon(1e-9));
    // The paper's 197 g; its conical projectile comes to 195.1 g, its ogival one to 197.5 g.
    CHECK(mass(shape, 7850.0) == Approx(0.197).epsilon(nose == Nose::conical ? 0.01 : 0.0025));
    for (double spacing : {0.6e-3, 1.2e-3}) {
      const auto mesh = projectile_mesh(shape, spacing, Extent::quarter);
      // Chords of a curved nose cut off a little, more at the coarse spacing.
      CHECK(4 * volume(mesh) == Approx(volume(shape)).epsilon(5e-4));
      double front = 1, back = 0, widest = 0;
      for (const V &p : mesh.positions) {
        front = std::min(front, p[2]), back = std::max(back, p[2]);
        widest = std::max(widest, std::hypot(p[0], p[1]));
      }
      // The nodes of a polygon of 16 sides (the fewest here) lie 1.3 % outside of the circle of the same area; the
      // hemispherical nose is longer by as much.
      CHECK(std::abs(front) < 1e-12);
      CHECK(back == Approx(end).margin(nose == Nose::hemispherical ? 6e-5 : 1e-9));
      CHECK(widest == Approx(0.01).epsilon(1.35e-2));
    }
  }
  CHECK(ogive_radius(paper_projectile<double>(Nose::ogival)) == Approx(59.45e-3).epsilon(1e-4));
}

TEST_CASE("a rounded edge takes its volume off the mesh and leaves the rest of it", "[fem]") {
  auto shape = paper_projectile<double>(Nose::blunt);
  const double spacing = 0.6e-3;
  const auto sharp = projectile_mesh(shape, spacing, Extent::quarter);
  for (double r : {0.2e-3, 0.5e-3, 1e-3}) {
    shape.edge_radius = r;
    // Pappus: the corner outside of a quarter of a circle has the area r^2 (1 - pi/4) and its centre of area lies
    // r (5/6 - pi/4)/(1 - pi/4) from the shank's side, by hand.
    const double pi = std::numbers::pi, area = r * r * (1 - pi / 4), offset = r * (5.0 / 6 - pi / 4) / (1 - pi / 4);
    CHECK(pi * edge_loss(shape) == Approx(2 * pi * (0.01 - offset) * area).epsilon(1e-9));
    CHECK(radius_at(shape, 0.0) == Approx(0.01 - r));
    CHECK(radius_at(shape, r * (1 - std::sqrt(0.5))) == Approx(0.01 - r * (1 - std::sqrt(0.5))));
    CHECK(radius_at(shape, r) == Approx(0.01));
    const auto mesh = projectile_mesh(shape, spacing, Extent::quarter);
    CHECK(4 * volume(sharp) - 4 * volume(mesh) == Approx(pi * edge_loss(shape)).epsilon(1e-6));
    REQUIRE(mesh.positions.size() == sharp.positions.size());
    const double outward = std::hypot(sharp.positions.back()[0], sharp.positions.back()[1]) / 0.01;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const V &p = mesh.positions[i], &q = sharp.positions[i];
      if (q[2] > 1e-3) CHECK(p == q);
      // No node outside of the arc by more than a chord that cuts off its area has to be, 0.07 r.
      const double x = std::hypot(p[0], p[1]) / outward - (0.01 - r), z = r - p[2];
      if (x > 0 && z > 0) CHECK(std::hypot(x, z) < 1.07 * r);
    }
  }
  shape.edge_radius = 2e-3;
  CHECK(contains(setup_error_of([&] { projectile_mesh(shape, spacing, Extent::quarter); }), "edge radius (m) = 0.002"));
  // With one hex along the axis the second station is the tail.
  shape.shank_length = 4e-3;
  CHECK_NOTHROW(projectile_mesh(shape, 1e-3, Extent::quarter));
  CHECK(contains(setup_error_of([&] { projectile_mesh(shape, 4e-3, Extent::quarter); }),
                 "if the projectile is one hex long"));
  shape.shank_length = 80e-3;
  shape.edge_radius = 3e-3;
  CHECK(contains(setup_error_of([&] { projectile_mesh(shape, 2e-3, Extent::quarter); }), "an eighth of the diameter"));
  auto cone = paper_projectile<double>(Nose::conical);
  cone.edge_radius = 1e-3;
  CHECK(contains(setup_error_of([&] { projectile_mesh(cone, 1e-3, Extent::quarter); }), "must be 0 unless blunt"));
}

TEST_CASE("the blunt projectile at 0.6 mm is as fine as asked for", "[fem]") {
  const auto mesh = projectile_mesh(paper_projectile<double>(Nose::blunt), 0.6e-3, Extent::quarter);
  CHECK(mesh.hexes.size() > 2500);
  CHECK(mesh.hexes.size() < 4000);
  double longest = 0, shortest = 1;
  for (const auto &hex : mesh.hexes) {
    if (mesh.positions[hex[0]][2] > 0) continue;
    for (std::size_t a = 0; a < 4; ++a) {
      const double edge = (mesh.positions[hex[a]] - mesh.positions[hex[(a + 1) % 4]]).norm();
      longest = std::max(longest, edge), shortest = std::min(shortest, edge);
    }
  }
  CHECK(longest < 1.95 * 0.6e-3);
  CHECK(shortest > 0.9 * 0.6e-3);
}

TEST_CASE("full, half and quarter meshes are 4 : 2 : 1 and closed", "[fem]") {
  const auto check_extents = [](auto &&make) {
    const HexMesh<double> quarter = make(Extent::quarter), half = make(Extent::half), full = make(Extent::full);
    CHECK(volume(half) == Approx(2 * volume(quarter)).epsilon(1e-12));
    CHECK(volume(full) == Approx(4 * volume(quarter)).epsilon(1e-12));
    CHECK(full.hexes.size() == 4 * quarter.hexes.size());
    for (const V &p : quarter.positions) CHECK((p[0] >= 0 && p[1] >= 0));
    for (const V &p : half.positions) CHECK(p[1] >= 0);
    const auto surface = boundary_facets(full);
    const double size = total_size(surface, full.positions);
    CHECK(total_area(surface, full.positions).norm() < 1e-13 * size);
    // No seam is left open: the outer surface of the quarter is a quarter of the full one's.
    const auto outer = facets_off_planes(boundary_facets(quarter), quarter.positions, {true, true}, 0.0);
    CHECK(4 * outer.size() == surface.size());
    CHECK(4 * total_size(outer, quarter.positions) == Approx(size).epsilon(1e-12));
  };
  for (Nose nose : paper_noses)
    check_extents([&](Extent extent) { return projectile_mesh(paper_projectile<double>(nose), 2e-3, extent); });
  check_extents([](Extent extent) { return rim_mesh(RimShape<double>{24e-3, 60e-3, 6e-3, 3e-3}, extent); });
}

TEST_CASE("contact facets of a quarter projectile are its outer surface", "[fem]") {
  const auto mesh = projectile_mesh(paper_projectile<double>(Nose::blunt), 1.2e-3, Extent::quarter);
  const auto facets = contact_facets(mesh, Extent::quarter);
  // A quarter of both ends and the mantle; the polygon's mantle differs by (pi/(8 n))^2/6 and the like.
  const double expected = std::numbers::pi * (2 * 1e-4 + 0.02 * 0.08) / 4;
  CHECK(total_size(facets, mesh.positions) == Approx(expected).epsilon(3e-3));
}

TEST_CASE("the paper's rim: size, layers and an exact inner cylinder", "[fem]") {
  const auto mesh = rim_mesh(paper_rim, Extent::quarter);
  CHECK(mesh.hexes.size() > 4000);
  CHECK(mesh.hexes.size() < 6000);
  const auto inner = inner_facets(mesh, paper_rim);
  CHECK(inner.size() == 25 * 8);
  double below = 0, above = -1, outer = 0;
  for (const V &p : mesh.positions) {
    const double r = std::hypot(p[0], p[1]);
    CHECK(r > 24e-3 * (1 - 1e-12));
    below = std::min(below, p[2]), above = std::max(above, p[2]), outer = std::max(outer, r);
  }
  CHECK(below == -12e-3);
  CHECK(above == 0);
  CHECK(outer == Approx(250e-3));
  // Outward of the hexes is towards the axis.
  for (const Facet &f : inner) CHECK(area_vector(f, mesh.positions).dot(mesh.positions[f.nodes[0]]) < 0);
  // Chords of 3.6 and more: the polygonal ring has sin(a)/a of the ring's area.
  const double ring = std::numbers::pi / 4 * (0.25 * 0.25 - 0.024 * 0.024) * 12e-3, a = std::numbers::pi / 50;
  CHECK(volume(mesh) == Approx(ring * std::sin(a) / a).epsilon(1e-12));
  const auto thin = rim_mesh(RimShape<double>{24e-3, 250e-3, 1e-3, 1.5e-3}, Extent::quarter);
  CHECK(inner_facets(thin, RimShape<double>{24e-3, 250e-3, 1e-3, 1.5e-3}).size() == 25 * 2);
}

TEST_CASE("the quality of a mesh is that of its worst hex", "[fem]") {
  auto mesh = brick<double>(2, 1, 1, V(4, 1, 2)); // hexes of 2 x 1 x 2
  auto q = mesh_quality(mesh);
  CHECK(q.shortest_edge == Approx(1));
  CHECK(q.longest_edge == Approx(2));
  CHECK(q.largest_aspect == Approx(2));
  CHECK(q.smallest_scaled_jacobian == Approx(1));
  // Sheared by 45 degrees in the plane of x and z: the sine of the angle between the edges.
  for (V &p : mesh.positions) p[0] += p[2];
  CHECK(mesh_quality(mesh).smallest_scaled_jacobian == Approx(std::sqrt(0.5)));
}

TEST_CASE("impossible shapes are refused", "[fem]") {
  CHECK(contains(setup_error_of([&] {
                   rim_mesh(RimShape<double>{24e-3, 20e-3, 12e-3, 1.5e-3}, Extent::quarter);
                 }),
                 "rim outer radius (m) = 0.02"));
  CHECK_THROWS_AS(rim_mesh(RimShape<double>{24e-3, 250e-3, 12e-3, 0.0}, Extent::quarter), SetupError);
  CHECK_THROWS_AS(rim_mesh(RimShape<double>{24e-3, 250e-3, 12e-3, 1.5e-3, 0.9}, Extent::quarter), SetupError);
  auto cone = paper_projectile<double>(Nose::conical);
  CHECK_THROWS_AS(projectile_mesh(cone, 0.0, Extent::quarter), SetupError);
  CHECK_THROWS_AS(projectile_mesh(cone, 6e-3, Extent::quarter), SetupError);
  cone.tip_diameter = 0;
  CHECK(contains(setup_error_of([&] { projectile_mesh(cone, 1e-3, Extent::quarter); }), "tip diameter (m) = 0"));
  auto ogive_shape = paper_projectile<double>(Nose::ogival);
  ogive_shape.nose_length = 5e-3;
  CHECK_THROWS_AS(projectile_mesh(ogive_shape, 1e-3, Extent::quarter), SetupError);
}
