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
