// SPDX-License-Identifier: BSD-3-Clause
#include "box.hpp"
#include "catch.hpp"

#include "ogive/mesh/hex_mesh.hpp"

using namespace contact_test;
using fem_test::brick, fem_test::Noise;

namespace {

constexpr double edge = 1e-3, offset = 0.5e-3;

/// A cube of 2 x 2 x 2 hexes from 0 to 2 mm and one slave at `p`.
struct Touching {
  Nodes<double> nodes;
  NodeToSurface<double> contact;
  explicit Touching(const V &p, SymmetryPlanes planes = {},
                    const HexMesh<double> &mesh = brick<double>(2, 2, 2, V::Constant(2 * edge))) {
    const Surface cube = add_surface(nodes, mesh);
    const NodeRange slave = add_free(nodes, {p}, 1e-3);
    contact = contact_of(nodes, slave, offset, facets_off_planes(cube.facets, nodes.position, planes, 0.0), {}, planes);
    add_contact_force(contact, nodes, 0.0, 1e-7);
  }
  Touch<double> touch() const {
    return contact.candidates.active.empty() ? Touch<double>{} : find_touch(contact, nodes, Index(0));
  }
};

void check_touch(const V &p, const V &direction, double depth) {
  const Touching t(p);
  const auto touch = t.touch();
  INFO("slave at " << p.transpose());
  REQUIRE(touch.facet >= 0);
  CHECK((touch.direction - direction / direction.norm()).norm() < 1e-9);
  CHECK(touch.depth == Approx(depth).epsilon(1e-9));
}

} // namespace

TEST_CASE("a slave is pushed straight off faces, edges and corners", "[contact]") {
  check_touch({0.7 * edge, 1.2 * edge, 2.3 * edge}, {0, 0, 1}, 0.2 * edge);
  check_touch({-0.4 * edge, 1.2 * edge, 0.9 * edge}, {-1, 0, 0}, 0.1 * edge);
  check_touch({2.2 * edge, 0.6 * edge, 2.1 * edge}, {2, 0, 1}, offset - std::hypot(0.2, 0.1) * edge);
  check_touch({2.1 * edge, -0.1 * edge, 2.2 * edge}, {1, -1, 2}, offset - std::sqrt(0.06) * edge);
  // Just over the line between two facets of the same plane.
  check_touch({1.0 * edge, 1.0 * edge, 2.4 * edge}, {0, 0, 1}, 0.1 * edge);
}

TEST_CASE("a slave whose centre is inside is pushed out of the nearest face", "[contact]") {
  check_touch({0.7 * edge, 1.2 * edge, 1.8 * edge}, {0, 0, 1}, offset + 0.2 * edge);
  check_touch({1.9 * edge, 1.2 * edge, 1.7 * edge}, {1, 0, 0}, offset + 0.1 * edge);
}

TEST_CASE("out of reach there is no touch", "[contact]") {
  CHECK(Touching({0.7 * edge, 1.2 * edge, 2.51 * edge}).touch().facet < 0);
  CHECK(Touching({2.4 * edge, 0.6 * edge, 2.4 * edge}).touch().facet < 0); // beyond the rounded edge
  CHECK(Touching({9 * edge, 0.6 * edge, 2.4 * edge}).touch().facet < 0);
}

TEST_CASE("the direction turns smoothly around an edge and a corner", "[contact]") {
  // On a path around the cube's corner at a constant distance the direction may turn by the path over the distance.
  const double distance = 0.3 * edge, step = 0.01;
  V before = V(0, 0, 1);
  for (double t = 0; t <= 1; t += step) {
    const V from(std::sin(1.5 * t), 0.4 * t, std::cos(1.5 * t));
    const V p = V(2 * edge, 2 * edge, 2 * edge) + distance * from / from.norm();
    const auto touch = Touching(p).touch();
    REQUIRE(touch.facet >= 0);
    CHECK((touch.direction - from / from.norm()).norm() < 1e-9);
    CHECK(touch.depth == Approx(offset - distance).epsilon(1e-9));
    if (t > 0) CHECK((touch.direction - before).norm() < 2 * step);
    before = touch.direction;
  }
}

TEST_CASE("a slave in a mirror plane gets no force across it from a surface in that plane", "[contact]") {
  // Seen in the plane x = 0 the top falls away from the plane or rises: one half of a ridge or of a valley. The slave's
  // nearest point lies in the plane on a ridge from outside, in a valley from inside. On the surface itself the
  // direction is the facet's normal, without its part across the plane.
  const auto force_at = [](double slope, double height) {
    auto mesh = brick<double>(2, 2, 2, V::Constant(2 * edge));
    for (V &p : mesh.positions) p[2] += slope * p[0] * p[2] / (2 * edge);
    const Touching t({0, 0.8 * edge, height * edge}, {true, false}, mesh);
    return V(t.nodes.force[t.contact.slaves[0]]);
  };
  for (const double steepness : {0.1, 0.5})
    for (const V &force :
         {force_at(-steepness, 2.1), force_at(-steepness, 2.0), force_at(steepness, 2.0), force_at(steepness, 1.99)}) {
      CHECK(force[0] == 0);
      CHECK(force[2] > 0);
    }
}

TEST_CASE("beside the mirror plane half a model gives the whole model's force", "[contact]") {
  // A ridge in the mirror plane, as a round shank of flat facets has one. Slaves beside the plane feel the ridge.
  for (const double slope : {-0.5, -0.2}) {
    auto half = brick<double>(2, 2, 2, V::Constant(2 * edge));
    for (V &p : half.positions) p[2] += slope * p[0] * p[2] / (2 * edge);
    const auto whole = with_mirror_image(half, 0);
    for (const double x : {0.02, 0.05, 0.2, 0.4}) {
      const V p(x * edge, 0.8 * edge, 2.3 * edge);
      const auto in_half = Touching(p, {true, false}, half).touch(), in_whole = Touching(p, {}, whole).touch();
      INFO("slope " << slope << ", x " << x);
      CHECK((in_half.direction - in_whole.direction).norm() < 1e-9);
      CHECK(in_half.depth == Approx(in_whole.depth));
    }
  }
}

TEST_CASE("a slave that was pushed across mirror planes feels the surface as its mirror image does", "[contact]") {
  auto mesh = brick<double>(2, 2, 2, V::Constant(2 * edge));
  for (V &p : mesh.positions) p[2] -= 0.3 * (p[0] + 0.5 * p[1]); // slopes, so that no component vanishes
  const SymmetryPlanes both{true, true};
  ContactOptions<double> rough;
  rough.friction = 0.3;
  struct Result {
    V force, reaction = V::Zero();
    double work;
  };
  const auto push = [&](const V &position, const V &velocity) {
    Touching t(position, both, mesh);
    t.contact.options = rough;
    t.nodes.velocity[t.contact.slaves[0]] = velocity;
    for (V &f : t.nodes.force) f.setZero();
    add_contact_force(t.contact, t.nodes, 1e-7, 1e-7);
    Result r{.force = t.nodes.force[t.contact.slaves[0]],
             .work = normal_energy(t.contact) + friction_energy(t.contact)};
    for (const V &f : t.nodes.force) r.reaction += f;
    r.reaction -= r.force;
    return r;
  };
  const V position(0.01 * edge, 0.02 * edge, 2.2 * edge), velocity(3, 5, -7);
  const Result inside = push(position, velocity);
  REQUIRE(inside.force.norm() > 0);
  for (const V &side : {V(-1, 1, 1), V(1, -1, 1), V(-1, -1, 1)}) {
    const Result across = push(side.cwiseProduct(position), side.cwiseProduct(velocity));
    CHECK((across.force - side.cwiseProduct(inside.force)).norm() < 1e-12 * inside.force.norm());
    CHECK((across.reaction - inside.reaction).norm() < 1e-12 * inside.force.norm());
    CHECK(across.work == Approx(inside.work).epsilon(1e-12));
  }
}

TEST_CASE("wrong contacts are refused", "[contact]") {
  Nodes<double> nodes;
  const Surface cube = add_surface(nodes, brick<double>(1, 1, 1, V::Constant(edge)));
  const NodeRange slave = add_free(nodes, {V(0, 0, 2 * edge)}, 1.0);
  const auto make = [&](std::vector<Index> slaves, std::vector<double> offsets, std::vector<Facet> facets, double mu) {
    return make_contact(nodes, std::move(slaves), std::move(offsets), std::move(facets), "c",
                        ContactOptions<double>{.friction = mu});
  };
  CHECK_NOTHROW(make({slave.begin}, {0.1}, cube.facets, 0.1));
  CHECK_THROWS_WITH(make({slave.begin}, {0.1}, cube.facets, -0.1), "c friction = -0.1: must not be negative");
  CHECK_THROWS_WITH(make({slave.begin}, {}, cube.facets, 0.0), Catch::Contains("offsets"));
  CHECK_THROWS_WITH(make({slave.begin}, {0.1}, {}, 0.0), Catch::Contains("facets"));
  CHECK_THROWS_WITH(make({0}, {0.1}, cube.facets, 0.0), Catch::Contains("must not belong to a facet"));
  nodes.mass[slave.begin] = 0;
  CHECK_THROWS_WITH(make({slave.begin}, {0.1}, cube.facets, 0.0), Catch::Contains("mass of slave node 8"));
}

TEST_CASE("the search finds candidates again after any move", "[contact]") {
  // Slaves wander through and around the cube, by up to 0.4 mm a step or so little that most have room left from the
  // last look, and now and then far away. The contact that was kept gives the same forces as one made anew.
  const double way = GENERATE(0.4, 0.01) * edge;
  Nodes<double> nodes;
  const Surface cube = add_surface(nodes, brick<double>(2, 2, 2, V::Constant(2 * edge)));
  Noise noise;
  std::vector<V> start;
  for (int i = 0; i < 60; ++i) start.emplace_back(V::Constant(edge) + 2 * edge * noise.vector());
  const NodeRange slaves = add_free(nodes, start, 1e-3);
  auto kept = contact_of(nodes, slaves, offset, cube.facets);
  int touching = 0, with_room = 0;
  for (int step = 0; step < 200; ++step) {
    for (Index n = slaves.begin; n < slaves.end; ++n) nodes.position[n] += way * noise.vector();
    if (step % 50 == 20)
      for (Index n = slaves.begin; n < slaves.end; ++n) nodes.position[n] += V(50, 0, 0) * edge;
    if (step % 50 == 25)
      for (Index n = slaves.begin; n < slaves.end; ++n) nodes.position[n] = start[n - slaves.begin];
    for (Index n = cube.nodes.begin; n < cube.nodes.end; ++n) nodes.position[n] += V(0, 0, 0.01 * edge);
    clear(nodes);
    add_contact_force(kept, nodes, 0.0, 1e-7);
    const std::vector<V> forces = nodes.force;
    for (const double room : kept.state.near.room) with_room += room > 0;
    clear(nodes);
    auto fresh = contact_of(nodes, slaves, offset, cube.facets);
    add_contact_force(fresh, nodes, 0.0, 1e-7);
    REQUIRE(forces == nodes.force);
    for (Index n = slaves.begin; n < slaves.end; ++n) touching += forces[n].norm() > 0;
  }
  CHECK(touching > 500);
  CHECK(with_room > 500);
}

TEST_CASE("a slave has room for its distance from what it can touch", "[contact]") {
  // 0.3 mm above the sphere's touch, beside an edge, where the distance goes past the rounded edge; in touch; inside.
  const auto room = [](const V &p) { return Touching(p).contact.state.near.room.at(0); };
  CHECK(room({0.7 * edge, 1.2 * edge, 2.8 * edge}) == Approx(0.99 * 0.3 * edge));
  CHECK(room({2.4 * edge, 0.6 * edge, 2.4 * edge}) == Approx(0.99 * (std::hypot(0.4, 0.4) * edge - offset)));
  CHECK(room({0.7 * edge, 1.2 * edge, 2.3 * edge}) == 0);
  CHECK(room({0.7 * edge, 1.2 * edge, 1.8 * edge}) == 0);
  // It is used up by the slave's way and the surface's, whichever way they go.
  Touching t({0.7 * edge, 1.2 * edge, 2.8 * edge});
  t.nodes.position.back() += V(0.03, 0, 0.04) * edge;
  add_contact_force(t.contact, t.nodes, 1e-7, 1e-7);
  CHECK(t.contact.state.near.room.at(0) == Approx((0.99 * 0.3 - 0.05) * edge));
  for (V &p : t.nodes.position) p += V(0, 0, 0.2) * edge;
  t.nodes.position.back() += V(0, 0, -0.1) * edge;
  add_contact_force(t.contact, t.nodes, 1e-7, 1e-7);
  CHECK(t.contact.state.near.room.at(0) == Approx((0.99 * 0.3 - 0.15) * edge));
}
