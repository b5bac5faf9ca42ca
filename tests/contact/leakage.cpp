// SPDX-License-Identifier: BSD-3-Clause
#include "area_vector.hpp"
#include "box.hpp"
#include "catch.hpp"

#include "ogive/mesh/projectile.hpp"

using namespace contact_test;
using fem_test::brick;

namespace {

constexpr double spacing = 1e-3, offset = spacing / 2, dt = 0.45 * spacing / 6000, speed = 400;

/// A plane of a facet.
struct Plane {
  V point, normal;
};

std::vector<Plane> planes_of(const std::vector<Facet> &facets, const std::vector<V> &positions) {
  std::vector<Plane> planes;
  for (const Facet &f : facets) {
    V middle = V::Zero();
    for (Index c : f.nodes) middle += 0.25 * positions[c];
    planes.push_back({middle, area_vector(f, positions).normalized()});
  }
  return planes;
}

/// Largest depth of slaves behind the planes of a convex body that has moved by `shift`, m; slaves that are farther
/// outside than `limit` count as -limit.
double deepest(const Nodes<double> &nodes, NodeRange slaves, const std::vector<Plane> &planes, const V &shift,
               double limit) {
  double deepest = -limit;
  for (Index n = slaves.begin; n < slaves.end; ++n) {
    double outside = -1e30;
    for (const Plane &p : planes) {
      outside = std::max(outside, p.normal.dot(nodes.position[n] - p.point - shift));
      if (outside > limit) break;
    }
    deepest = std::max(deepest, -outside);
  }
  return deepest;
}

/// Drives a rigid body with the surface `mesh` by `travel` at 400 m/s towards -z through a cloud of free slaves of
/// 1 mm distance. Returns the largest depth ever of a slave's centre and the number of slaves that were touched.
struct Passage {
  double deepest;
  int touched;
};

Passage drive_through(const HexMesh<double> &mesh, const std::vector<V> &cloud, double travel) {
  Nodes<double> nodes;
  const Surface body = add_surface(nodes, mesh);
  set_velocity(nodes, body.nodes, V(0, 0, -speed));
  const NodeRange slaves = add_free(nodes, cloud, 7850 * std::pow(spacing, 3));
  auto contact = contact_of(nodes, slaves, offset, body.facets, {.friction = 0.1});
  const auto planes = planes_of(body.facets, nodes.position);
  Passage passage{-1, 0};
  const int steps = static_cast<int>(travel / (dt * speed));
  for (int i = 1; i <= steps; ++i) {
    clear(nodes);
    add_contact_force(contact, nodes, dt, dt);
    move(nodes, slaves, dt);
    for (Index n = body.nodes.begin; n < body.nodes.end; ++n) nodes.position[n] += dt * nodes.velocity[n];
    if (i % 3 == 0) // a slave takes ten steps to enter and leave a spring
      passage.deepest = std::max(passage.deepest, deepest(nodes, slaves, planes, V(0, 0, -i * dt * speed), offset));
  }
  for (Index n = slaves.begin; n < slaves.end; ++n) passage.touched += nodes.velocity[n].norm() > 0;
  return passage;
}

} // namespace

TEST_CASE("no slave passes through a flat face, an edge or a cone at speed", "[contact]") {
  // A slave of mass m that meets the spring k = 0.1 m/dt^2 at the speed v enters it by v sqrt(m/k) = 3.2 v dt = 0.1 mm,
  // a fifth of its offset: its centre stays outside. Friction and the turn of the direction at edges change no more
  // than the other half of the offset.
  const double entry = speed * dt / std::sqrt(0.1);
  REQUIRE(entry < 0.2 * offset);
  std::vector<V> cloud; // a disc of three layers below z = 0, not aligned with any mesh
  for (int k = 0; k < 3; ++k)
    for (int j = -12; j <= 12; ++j)
      for (int i = -12; i <= 12; ++i) cloud.emplace_back(spacing * V(i + 0.31 + 0.2 * (k % 2), j + 0.17, -k - 0.55));
  SECTION("flat face and the rim around it") {
    const auto mesh = projectile_mesh(paper_projectile<double>(Nose::blunt), spacing, Extent::full);
    const Passage p = drive_through(mesh, cloud, 6e-3);
    CHECK(p.touched > 3 * 3.14 * 81); // all in front of the face at least
    CHECK(p.deepest < -0.5 * offset);
  }
  SECTION("edge of a block") {
    auto mesh = brick<double>(12, 2, 2, V(12e-3, 6e-3, 6e-3)); // turned by 45 degrees about x, lower edge first
    const auto turn = fem_test::rotation(V(1, 0, 0), 0.25 * 3.14159265358979);
    for (V &x : mesh.positions) x = turn * (x - V(6e-3, 0, 0));
    const Passage p = drive_through(mesh, cloud, 6e-3);
    CHECK(p.touched > 3 * 12 * 5);
    CHECK(p.deepest < -0.5 * offset);
  }
  SECTION("conical nose") {
    const auto mesh = projectile_mesh(paper_projectile<double>(Nose::conical), spacing, Extent::full);
    const Passage p = drive_through(mesh, cloud, 16e-3);
    CHECK(p.touched > 3 * 3.14 * 16);
    CHECK(p.deepest < -0.5 * offset);
  }
}

TEST_CASE("the spring carries a steady load up to its offset", "[contact]") {
  // The spring yields by F dt^2/(0.1 m): a centre stays outside up to F = 0.1 m offset/dt^2.
  Nodes<double> nodes;
  const Surface block = add_surface(nodes, brick<double>(4, 4, 2, V(4e-3, 4e-3, 2e-3)));
  const double mass = 7850 * std::pow(spacing, 3), limit = 0.1 * mass * offset / (dt * dt);
  const NodeRange slaves = add_free(nodes, {V(1.3e-3, 2.2e-3, 2e-3 + offset), V(2e-3, 2e-3, 2e-3 + offset)}, mass);
  auto contact = contact_of(nodes, slaves, offset, block.facets);
  double lowest = 1;
  for (int i = 0; i < 300; ++i) {
    clear(nodes);
    // Loaded slowly, as a dynamic load would go twice as deep.
    for (Index n = slaves.begin; n < slaves.end; ++n) nodes.force[n] = V(0, 0, -0.9 * limit * std::min(1.0, i / 200.0));
    add_contact_force(contact, nodes, dt, dt);
    move(nodes, slaves, dt);
    for (Index n = slaves.begin; n < slaves.end; ++n) lowest = std::min(lowest, nodes.position[n][2] - 2e-3);
  }
  CHECK(lowest > 0);
  CHECK(lowest < 0.2 * offset); // and it is the spring that carries the load, 0.9 of the offset deep
}
