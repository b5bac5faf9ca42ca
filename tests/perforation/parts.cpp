// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "perforation/refusal.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/mesh_io/own_projectile.hpp"
#include "ogive/sim/energy.hpp"

using namespace sim_test;

namespace {

using AnyMetal = Metal<double, AnyFlowLaw<double>>;

/// A core of 12 mm in a jacket, 20 mm in diameter and 30 mm long, before a small plate, with a mesh of its own.
PerforationCase<double> jacketed(bool one_part = false) {
  auto c = small_case(Nose::blunt, Extent::quarter);
  ProjectileShape<double> shape{Nose::blunt, 20e-3, 30e-3};
  shape.inner = {bore(6e-3, 30e-3, 30e-3)};
  c.own_mesh = nested_mesh(shape, 1.5e-3, Extent::quarter);
  if (one_part) c.own_mesh.part_of.clear(), c.own_mesh.parts = {"1"};
  c.projectile = shape_of(c.own_mesh, Extent::quarter, "test");
  return c;
}

AnyMetal steel() { return with_law<AnyFlowLaw<double>>(library::arne_tool_steel<double>()); }

/// A soft and heavy metal with another law.
AnyMetal soft() {
  auto metal = with_law<AnyFlowLaw<double>>(library::weldox_460e_jc<double>());
  metal.density = 11000;
  return metal;
}

auto shot_of(const PerforationCase<double> &c, const std::vector<AnyMetal> &metals) {
  return make_perforation(c, std::vector{with_law<AnyFlowLaw<double>>(library::weldox_460e_mjc<double>())}, metals, {},
                          AnyDiscretisation{});
}

template <class M> void advance(M &model, int steps, double dt) {
  for (int k = 0; k < steps; ++k) step(model, dt);
}

constexpr double dt = 2e-8;

} // namespace

TEST_CASE("two parts of one metal move as one part", "[perforation]") {
  auto one = shot_of(jacketed(true), {steel()});
  auto two = shot_of(jacketed(), {steel(), steel()});
  REQUIRE(two.bodies.projectile.size() == 2);
  CHECK(projectile(two).name == "projectile_jacket");
  CHECK(projectile(two, 1).name == "projectile_core");
  CHECK(projectile_mass(two) == Approx(projectile_mass(one)).epsilon(1e-12));
  // Analytic mass of the cylinder: the mesh has its volume exactly.
  CHECK(projectile_mass(one) == Approx(7850 * std::numbers::pi * 1e-4 * 30e-3).epsilon(1e-9));
  advance(one, 200, dt), advance(two, 200, dt);
  // The same forces, summed in another order: round-off of 1e-16, which 200 steps of a stable scheme do not raise far.
  double largest = 0;
  for (Index n = 0; n < one.nodes.size(); ++n)
    largest = std::max(largest, (one.nodes.position[n] - two.nodes.position[n]).norm());
  CHECK(largest < 1e-12);
  const auto a = energy(one), b = energy(two);
  CHECK(total(b) == Approx(total(a)).epsilon(1e-12));
  CHECK(b.plastic == Approx(a.plastic).epsilon(1e-9));
}

TEST_CASE("each part flows by its own metal, and the energy is kept", "[perforation]") {
  const auto c = jacketed();
  auto model = shot_of(c, {steel(), soft()});
  const double quarter = std::numbers::pi / 4 * 30e-3;
  const double expected = 4 * quarter * (7850 * (100e-6 - 36e-6) + 11000 * 36e-6);
  CHECK(projectile_mass(model) == Approx(expected).epsilon(1e-9));
  const double before = total(energy(model));
  advance(model, 400, dt);
  // The books of central differences close to some 1e-4 in so coarse a shot.
  CHECK(total(energy(model)) == Approx(before).epsilon(1e-3));
  const auto largest = [](const auto &body) {
    return *std::max_element(body.points.plastic_strain.begin(), body.points.plastic_strain.end());
  };
  CHECK(largest(projectile(model, 1)) > 2 * largest(projectile(model)));
  // A target mass changes all densities by one factor.
  auto heavy = c;
  heavy.projectile_mass = 2 * expected;
  const auto scaled = shot_of(heavy, {steel(), soft()});
  CHECK(projectile_mass(scaled) == Approx(2 * expected).epsilon(1e-12));
  CHECK(projectile(scaled).metal.density == Approx(2 * 7850));
  CHECK(projectile(scaled, 1).metal.density == Approx(2 * 11000));
}

TEST_CASE("a rigid projectile of parts moves as one, and keeps the mass of its parts", "[perforation]") {
  auto c = jacketed();
  c.rigid_projectile = true;
  auto model = shot_of(c, {steel(), soft()});
  const NodeRange range = projectile(model).nodes;
  advance(model, 200, dt);
  const auto velocity = model.nodes.velocity[range.begin];
  for (Index n = range.begin; n < range.end; ++n) CHECK((model.nodes.velocity[n] - velocity).norm() < 1e-9);
  CHECK(-velocity[2] < 300);
  CHECK(inertia_of(model.nodes, range, model.symmetry).mass == Approx(projectile_mass(model) / 4));
}

TEST_CASE("a shot of parts resumes from its checkpoint to the last bit", "[perforation]") {
  const TemporaryFolder folder;
  const auto file = folder.path / "checkpoint.bin";
  auto model = shot_of(jacketed(), {steel(), soft()});
  advance(model, 50, dt);
  write_checkpoint(file, model, RunState<double>{});
  advance(model, 50, dt);
  auto resumed = shot_of(jacketed(), {steel(), soft()});
  RunState<double> run;
  restore(read_checkpoint(file), resumed, run);
  advance(resumed, 50, dt);
  CHECK(state_hash(resumed) == state_hash(model));
  CHECK(fingerprint(resumed) != fingerprint(shot_of(jacketed(), {soft(), steel()})));
  // Pictures and files have a grid for each part, with its own nodes alone.
  const Frame frame = gather_frame(model);
  std::vector<std::string> names;
  std::size_t nodes = 0;
  for (const HexGrid &grid : frame.grids) {
    names.push_back(grid.name);
    if (!grid.name.starts_with("projectile")) continue;
    nodes += grid.positions.size();
    for (const auto &hex : grid.hexes)
      for (const Index n : hex) CHECK((n >= 0 && n < static_cast<Index>(grid.positions.size())));
  }
  CHECK(names == std::vector<std::string>{"rim", "projectile_jacket", "projectile_core"});
  CHECK(nodes > std::size_t(projectile(model).nodes.size()));     // those of the interface twice
  CHECK(nodes < 2 * std::size_t(projectile(model).nodes.size())); // but no others
}

TEST_CASE("a projectile needs a metal for each part", "[perforation]") {
  CHECK(refusal_of([] { shot_of(jacketed(), {steel()}); }) ==
        "number of the projectile's metals = 1: must be 2, one for each part");
}
