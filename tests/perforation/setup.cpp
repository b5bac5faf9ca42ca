// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "perforation/refusal.hpp"

#include "ogive/perforation/setup.hpp"

#include <Eigen/Geometry>

#include <numbers>

using namespace ogive;
using V3 = Vec3<double>;

namespace {

auto build(const PerforationCase<double> &c) {
  return make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
}

PerforationCase<double> coarse_case() {
  PerforationCase<double> c;
  c.thickness = 8e-3;
  c.clamp_radius = 100e-3;
  c.sph_radius = 18e-3;
  c.spacing = 1e-3;
  return c;
}

template <class M> double mass_of(const M &model, NodeRange range) {
  double mass = 0;
  for (Index n = range.begin; n < range.end; ++n) mass += model.nodes.mass[n];
  return mass * model.symmetry.copies();
}

} // namespace

TEST_CASE("plate and projectile have their masses", "[perforation]") {
  const Nose nose = GENERATE(Nose::blunt, Nose::conical, Nose::ogival, Nose::hemispherical);
  const Lattice lattice = GENERATE(Lattice::cubic, Lattice::ring);
  const Extent extent = GENERATE(Extent::half, Extent::quarter);
  auto c = coarse_case();
  c.projectile = paper_projectile<double>(nose), c.lattice = lattice, c.extent = extent;
  const auto model = build(c);
  const double plate = 7850 * std::numbers::pi * c.clamp_radius * c.clamp_radius * c.thickness;
  // The rim's edges are polygons, the cubic lattice's a staircase.
  const double found = whole_mass(plate_particles(model).point_mass, model.symmetry) +
                       whole_mass(plate_hexes(model).point_mass, model.symmetry);
  CHECK(found == Approx(plate).epsilon(0.01));
  // The tie moves mass from particles to hexes and loses none.
  CHECK(mass_of(model, plate_particles(model).nodes) + mass_of(model, plate_hexes(model).nodes) ==
        Approx(found).epsilon(1e-12));
  // Liu et al. 2012: 197 g; the conical one's drawing gives 195.1 g.
  const double shot = whole_mass(projectile(model).point_mass, model.symmetry);
  CHECK(shot == Approx(0.197).epsilon(nose == Nose::conical ? 0.012 : 0.005));
  CHECK(shot == Approx(mass(paper_projectile<double>(nose), 7850.0)).epsilon(0.002)); // facets for curved noses
  CHECK(mass_of(model, projectile(model).nodes) >= shot * (1 - 1e-12));
  CHECK(mass_of(model, projectile(model).nodes) <= shot * (1.01 + 1e-12)); // raised at the tip by 1 % at most
}

TEST_CASE("a model of a method has all that the method chooses", "[perforation]") {
  const auto steel = library::arne_tool_steel<double>();
  auto plate = library::weldox_460e_mjc<double>();
  auto c = coarse_case();
  c.lattice = Lattice::cubic;
  c.projectile = paper_projectile<double>(Nose::conical);
  const auto model = make_perforation(Method::stabilised, c, plate, steel);
  const auto &particles = plate_particles(model);
  CHECK(particles.metal.damage.law == DamageLaw::johnson_cook);
  CHECK(particles.metal.damage.softening == 0.3);
  CHECK(has_bands(particles.metal.shear_band));
  CHECK(particles.options.control.stiffness == 0.3);
  CHECK(model.contacts[0].options.friction == 0.02);
  c.lattice = Lattice::ring;
  CHECK(model.nodes.position == build(c).nodes.position);
  c.friction = 0.1;
  CHECK(make_perforation(Method::stabilised, c, plate, steel).contacts[0].options.friction == 0.1);
  c.friction = 0, c.projectile = paper_projectile<double>(Nose::blunt);
  CHECK(make_perforation(Method::stabilised, c, plate, steel).contacts[0].options.friction == 0);
  plate.damage.failure_strain = {}; // a metal without
  const auto undamaged = make_perforation(Method::stabilised, c, plate, steel);
  CHECK(plate_particles(undamaged).metal.damage.law == DamageLaw::none);

  const auto paper = make_perforation(Method::paper, c, plate, steel);
  CHECK_FALSE(has_bands(plate_particles(paper).metal.shear_band));
  c.lattice = Lattice::cubic;
  CHECK(paper.nodes.position == build(c).nodes.position);
}

TEST_CASE("the parts of a shot stand where they belong", "[perforation]") {
  const Lattice lattice = GENERATE(Lattice::cubic, Lattice::ring);
  auto c = coarse_case();
  c.lattice = lattice;
  const auto model = build(c);
  const auto &nodes = model.nodes;
  const auto radius = [&](Index n) { return std::hypot(nodes.position[n][0], nodes.position[n][1]); };
  for (Index n = plate_particles(model).nodes.begin; n < plate_particles(model).nodes.end; ++n) {
    REQUIRE(radius(n) < c.sph_radius);
    REQUIRE(nodes.position[n][2] < 0);
    REQUIRE(nodes.position[n][2] > -c.thickness);
  }
  int clamped = 0;
  for (Index n = plate_hexes(model).nodes.begin; n < plate_hexes(model).nodes.end; ++n) {
    const auto &p = nodes.position[n];
    REQUIRE(radius(n) > c.sph_radius * (1 - 1e-6));
    if (nodes.held[n] == held_all) ++clamped;
    REQUIRE((nodes.held[n] == held_all) == (radius(n) > c.clamp_radius * (1 - 1e-6)));
    if (nodes.held[n] == held_all) continue;
    REQUIRE(bool(nodes.held[n] & held_x) == (p[0] == 0));
    REQUIRE(bool(nodes.held[n] & held_y) == (p[1] == 0));
  }
  CHECK(clamped > 0);
  for (Index n = projectile(model).nodes.begin; n < projectile(model).nodes.end; ++n) {
    REQUIRE(nodes.position[n][2] >= 0);
    REQUIRE(nodes.velocity[n] == Vec3<double>(0, 0, -c.initial_velocity));
  }

  REQUIRE(model.ties.size() == 1);
  std::vector<bool> tied(nodes.position.size(), false);
  for (const auto &t : model.ties[0].nodes) {
    tied[t.slave] = true;
    REQUIRE(t.slave < plate_particles(model).nodes.end);
    REQUIRE(radius(t.slave) > c.sph_radius - 1.2 * plate_particles(model).spacing); // on the edge only
    REQUIRE(nodes.mass[t.slave] == 0);
  }
  // And everywhere on the edge: what lies within half a particle distance and a bit (staircases, polygons) of it.
  for (Index n = plate_particles(model).nodes.begin; n < plate_particles(model).nodes.end; ++n)
    if (radius(n) > c.sph_radius - 0.6 * plate_particles(model).spacing) REQUIRE(tied[n]);
  REQUIRE(model.contacts.size() == 1);
  CHECK(model.contacts[0].slaves.size() ==
        std::size_t(plate_particles(model).nodes.size() + plate_hexes(model).nodes.size()));
  CHECK(model.rigid_parts.empty());
  c.rigid_projectile = true;
  REQUIRE(build(c).rigid_parts.size() == 1);
  CHECK_FALSE(turns(build(c).rigid_parts[0])); // both mirror planes
}

TEST_CASE("an oblique projectile lies in its line of flight and touches the plate", "[perforation]") {
  const Nose nose = GENERATE(Nose::blunt, Nose::ogival);
  auto c = coarse_case();
  c.projectile = paper_projectile<double>(nose);
  c.sph_radius = 22e-3;
  c.extent = Extent::half;
  const auto straight = build(c);
  c.obliquity = 0.5;
  const auto oblique = build(c);
  CHECK(whole_mass(projectile(oblique).point_mass, oblique.symmetry) ==
        Approx(whole_mass(projectile(straight).point_mass, straight.symmetry)).epsilon(1e-9));
  const V3 flight(std::sin(0.5), 0, -std::cos(0.5));
  const NodeRange nodes = projectile(oblique).nodes;
  double lowest = 1, longest = 0;
  for (Index n = nodes.begin; n < nodes.end; ++n) {
    const V3 &p = oblique.nodes.position[n];
    lowest = std::min(lowest, p[2]);
    longest = std::max(longest, -p.dot(flight));
    REQUIRE(p.cross(flight).norm() < 10.2e-3); // its axis goes through the middle of the front face
    REQUIRE((oblique.nodes.velocity[n] - c.initial_velocity * flight).norm() < 1e-9);
    REQUIRE(bool(oblique.nodes.held[n] & held_y) == (p[1] == 0));
    REQUIRE_FALSE(oblique.nodes.held[n] & held_x);
  }
  CHECK(std::abs(lowest) < 1e-12);
  // The foremost point of a blunt face is its edge, R tan(obliquity) ahead of where the axis meets the plate.
  const double ahead = nose == Nose::blunt ? 10e-3 * std::tan(0.5) : 0.5e-3 * std::tan(0.5);
  CHECK(longest == Approx(length(c.projectile) + ahead).epsilon(2e-3));
}

TEST_CASE("a projectile gets the mass that is asked for", "[perforation]") {
  auto c = coarse_case();
  c.projectile_mass = 0.3;
  const auto model = build(c);
  CHECK(whole_mass(projectile(model).point_mass, model.symmetry) == Approx(0.3).epsilon(1e-3)); // facets
}

TEST_CASE("cases that do not fit together are refused with a line that says why", "[perforation]") {
  const auto refused = [](auto change) {
    auto c = coarse_case();
    change(c);
    return refusal_of([&] { build(c); });
  };
  using Case = PerforationCase<double>;
  CHECK(refused([](Case &) {}) == "accepted");
  CHECK_THAT(refused([](Case &c) { c.sph_radius = 9e-3; }), Catch::Contains("particle disc (m) = 0.009"));
  CHECK_THAT(refused([](Case &c) { c.clamp_radius = 17e-3; }), Catch::Contains("clamp radius (m) = 0.017"));
  CHECK_THAT(refused([](Case &c) { c.initial_velocity = 0; }), Catch::Contains("initial velocity (m/s) = 0"));
  CHECK_THAT(refused([](Case &c) { c.initial_velocity = -300; }), Catch::Contains("initial velocity (m/s) = -300"));
  CHECK_THAT(refused([](Case &c) { c.obliquity = 0.3; }), Catch::Contains("must be 0 in a quarter model"));
  CHECK_THAT(refused([](Case &c) { c.obliquity = 0.6, c.extent = Extent::half; }),
             Catch::Contains("particle disc (m) = 0.018") && Catch::Contains("room for the oblique projectile"));
  CHECK_THAT(refused([](Case &c) { c.projectile_mass = -1; }), Catch::Contains("projectile's mass (kg) = -1"));
  CHECK_THAT(refused([](Case &c) { c.projectile.diameter = 0; }), Catch::Contains("projectile diameter (m) = 0"));
  CHECK_THAT(refused([](Case &c) { c.friction = -0.1; }), Catch::Contains("friction = -0.1"));
  CHECK_THAT(refused([](Case &c) { c.spacing = 0; }), Catch::Contains("particle distance (m) = 0"));
  CHECK_THAT(refused([](Case &c) { c.spacing = 5e-3; }), Catch::Contains("particle distance (m) = 0.005"));
  CHECK_THAT(refused([](Case &c) { c.thickness = 1e-3; }), Catch::Contains("particle distance (m) = 0.001"));
  CHECK_THAT(refused([](Case &c) { c.thickness = -1; }), Catch::Contains("thickness (m) = -1"));
  CHECK_THAT(refused([](Case &c) { c.sph_radius = std::nan(""); }), Catch::Contains("particle disc (m) = nan"));
}
