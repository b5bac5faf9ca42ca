// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/mesh/nested_mesh.hpp"

using namespace ogive;
using Catch::Matchers::StartsWith;

namespace {

template <class F> std::string refusal(F &&f) {
  try {
    f();
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

ProjectileShape<double> tube(double depth) {
  ProjectileShape<double> shape{Nose::blunt, 20e-3, 40e-3};
  shape.inner = {bore(7e-3, depth, 40e-3)};
  shape.is_hollow = true;
  return shape;
}

} // namespace

TEST_CASE("a tube and a cup have their analytic volume and good hexes", "[mesh]") {
  const double full = std::numbers::pi * 1e-4 * 40e-3;
  for (const double depth : {40e-3, 25e-3, 5e-3}) {
    const auto shape = tube(depth);
    CHECK(volume(shape) == Approx(full - std::numbers::pi * 49e-6 * depth));
    for (const double spacing : {1e-3, 2e-3}) {
      const auto quarter = nested_mesh(shape, spacing, Extent::quarter);
      // Nodes lie outside of the circles such that prisms have exactly their volume.
      CHECK(4 * volume(quarter.mesh) == Approx(volume(shape)).epsilon(1e-10));
      CHECK(mesh_quality(quarter.mesh).smallest_scaled_jacobian > 0.5);
      CHECK(quarter.parts == std::vector<std::string>{"1"});
      const auto half = nested_mesh(shape, spacing, Extent::half);
      CHECK(2 * volume(half.mesh) == Approx(volume(shape)).epsilon(1e-10));
    }
  }
  // Nothing lies within the bore of a tube.
  for (const auto &x : nested_mesh(tube(40e-3), 1e-3, Extent::quarter).mesh.positions)
    CHECK(std::hypot(x[0], x[1]) > 6.99e-3);
}

TEST_CASE("core, filler and jacket share nodes and have their volumes", "[mesh]") {
  auto shape = projectile_of(Profile<double>{{0, 1e-3}, {10e-3, 5e-3}, {30e-3, 5e-3}});
  shape.inner = {{{6e-3, 0.5e-3}, {12e-3, 3e-3}, {28e-3, 3e-3}}, {{2e-3, 1e-3}, {10e-3, 4.2e-3}, {30e-3, 4.2e-3}}};
  const auto expected = part_volumes(shape);
  CHECK(part_names(shape) == std::vector<std::string>{"jacket", "filler", "core"});
  CHECK(expected[2] == Approx(volume(shape.inner[0])));
  CHECK(expected[0] + expected[1] + expected[2] == Approx(volume(shape)));
  for (const double spacing : {0.5e-3, 1e-3}) {
    const auto body = nested_mesh(shape, spacing, Extent::quarter);
    const auto volumes = part_volumes(body);
    // Frusta are met exactly where there are nodes at their ends; a kink may lie half a particle distance off.
    for (std::size_t k = 0; k < 3; ++k) CHECK(4 * volumes[k] == Approx(expected[k]).epsilon(5e-3));
    CHECK(mesh_quality(body.mesh).smallest_scaled_jacobian > 0.4);
    // One closed body: all facets of its surface lie on the outer one, on the flats or in the mirror planes.
    const auto outer =
        facets_off_planes(boundary_facets(body.mesh), body.mesh.positions, symmetry_planes(Extent::quarter), 0.0);
    for (const Facet &facet : outer)
      for (const Index n : facet.nodes) {
        const auto &x = body.mesh.positions[n];
        const bool on_flat = x[2] == 0 || x[2] == 30e-3;
        CHECK((on_flat || std::hypot(x[0], x[1]) > 0.98 * radius_at(shape, x[2])));
      }
  }
}

TEST_CASE("separated parts have nodes and surfaces of their own", "[mesh]") {
  // A jacket around a core, each one hex: a row of 2 x 1 x 1 hexes has 12 nodes, of which both share 4.
  const std::vector<Vec3<double>> line = {{0, 0, 0}, {1e-3, 0, 0}, {2e-3, 0, 0}};
  PartMesh<double> row{{}, {1, 0}, {"jacket", "core"}};
  for (const double z : {0.0, 1e-3})
    for (const double y : {0.0, 1e-3})
      for (const auto &x : line) row.mesh.positions.push_back(x + Vec3<double>(0, y, z));
  row.mesh.hexes = {{0, 1, 4, 3, 6, 7, 10, 9}, {1, 2, 5, 4, 7, 8, 11, 10}};
  REQUIRE(boundary_facets(row.mesh).size() == 10);
  const auto apart = separated(row);
  CHECK(apart.mesh.positions.size() == 16);
  CHECK(boundary_facets(apart.mesh).size() == 12);
  CHECK(apart.part_of == row.part_of);
  CHECK(apart.parts == row.parts);
  // Nodes in the order of the parts: hex 1 is the jacket, its nodes are 1, 2, 4, 5, 7, 8, 10, 11 of the row.
  CHECK(apart.mesh.hexes[1] == std::array<Index, 8>{0, 1, 3, 2, 4, 5, 7, 6});
  CHECK(apart.mesh.hexes[0] == std::array<Index, 8>{8, 9, 11, 10, 12, 13, 15, 14});
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t a = 0; a < 8; ++a)
      CHECK(apart.mesh.positions[apart.mesh.hexes[e][a]] == row.mesh.positions[row.mesh.hexes[e][a]]);
  // What is apart stays as it is, and so does a body of one part.
  CHECK(separated(apart).mesh.hexes == apart.mesh.hexes);
  row.part_of.clear();
  CHECK(separated(row).mesh.positions.size() == 12);
}

TEST_CASE("a separated bullet has the volumes of its parts and each node of an interface twice", "[mesh]") {
  ProjectileShape<double> shape{Nose::blunt, 20e-3, 30e-3};
  shape.inner = {bore(6e-3, 30e-3, 30e-3)};
  const auto body = nested_mesh(shape, 1.5e-3, Extent::quarter), apart = separated(body);
  CHECK(part_volumes(apart)[0] == part_volumes(body)[0]);
  CHECK(part_volumes(apart)[1] == part_volumes(body)[1]);
  // The interface is the cylinder of the core: nodes of the body that hexes of both parts have.
  std::size_t shared = 0;
  std::vector<int> of_part(body.mesh.positions.size(), 0);
  for (std::size_t e = 0; e < body.part_of.size(); ++e)
    for (const Index n : body.mesh.hexes[e]) of_part[n] |= body.part_of[e] == 0 ? 1 : 2;
  for (const int bits : of_part) shared += bits == 3;
  CHECK(shared > 20);
  CHECK(apart.mesh.positions.size() == body.mesh.positions.size() + shared);
}

TEST_CASE("surfaces within a projectile that cannot be are refused", "[mesh]") {
  auto shape = tube(25e-3);
  shape.inner.front()[1].radius = 9.9e-3;
  CHECK_THAT(refusal([&] { check_inner(shape); }),
             StartsWith("radius at z = 0.040000 m of inner surface 1 (m) = 0.0099: "
                        "must be at most 0.98 of the surface around it"));
  shape = tube(25e-3);
  shape.inner.front()[1].z = 41e-3;
  CHECK_THAT(refusal([&] { check_inner(shape); }),
             StartsWith("last z of inner surface 1 (m) = 0.041: must be at most"));
  shape.inner.front()[0].z = -1e-3;
  CHECK_THAT(refusal([&] { check_inner(shape); }), StartsWith("first z of inner surface 1 (m) = -0.001: must not be"));
  shape = tube(25e-3);
  shape.nose = Nose::sphere;
  CHECK_THAT(refusal([&] { check_inner(shape); }),
             StartsWith("nose of a projectile with parts or a bore = sphere: must be"));
  shape = tube(25e-3);
  shape.inner.resize(3, shape.inner.front());
  CHECK_THAT(refusal([&] { check_inner(shape); }), StartsWith("surfaces within the projectile = 3: must be at most 2"));
}
