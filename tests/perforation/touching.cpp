// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "perforation/refusal.hpp"
#include "sim/blocks.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/perforation/motion.hpp"

#include <omp.h>

using namespace sim_test;

namespace {

using AnyMetal = Metal<double, AnyFlowLaw<double>>;
using fem_test::V;

constexpr double gravity = 1e7, mu = 0.2; ///< m/s2, Coulomb

/// A block on a fixed slab, two parts that touch: pressed down by `gravity`, it slides along x.
struct SlidingPart {
  Nodes<double> nodes;
  std::vector<Hex> parts;
  std::vector<NodeToSurface<double>> contacts;
  double dt = 0, impulse = 0; ///< s, N s of the supports along z

  SlidingPart() {
    const auto slab = brick_at(8, 4, 2, V(8e-3, 4e-3, 2e-3), V(0, 0, -2e-3));
    const auto block = brick_at(3, 2, 2, V(3e-3, 2e-3, 2e-3), V(1e-3, 1e-3, 0));
    std::vector<Facet> facets;
    for (const auto *mesh : {&slab, &block}) {
      for (const Facet &facet : shifted(boundary_facets(*mesh), nodes.size())) facets.push_back(facet);
      parts.push_back(add_hex_body(nodes, *mesh, fem_test::steel<double>(), mesh == &slab ? "slab" : "block"));
    }
    for (Index n = parts[0].nodes.begin; n < parts[0].nodes.end; ++n) nodes.held[n] = held_all;
    dt = stable_time_step(parts[1], nodes);
    // The contact of the plates, of which there are none but a particle far away.
    const NodeRange far = add_nodes(nodes, {V(1, 1, 1)});
    nodes.mass[far.begin] = 1;
    contacts.push_back(make_contact(nodes, {far.begin}, {0.0}, facets, "plate"));
    contacts.front().state.reference_time_step = dt;
    add_part_contacts(contacts, nodes, parts, mu);
  }

  void advance() {
    clear_forces(nodes);
    Lap lap(times);
    for (auto &part : parts) update_body(part, nodes, dt, lap);
    for (Index n = parts[1].nodes.begin; n < parts[1].nodes.end; ++n) nodes.force[n][2] -= gravity * nodes.mass[n];
    for (auto &contact : contacts) add_contact_force(contact, nodes, dt, dt);
    impulse += support_impulse(nodes, dt)[2];
    integrate(nodes, dt, dt);
  }
  PhaseTimes times{};
};

/// A core of 12 mm in a jacket, 20 mm in diameter and 30 mm long, before a small plate: parts that touch.
PerforationCase<double> jacketed() {
  auto c = small_case(Nose::blunt, Extent::quarter);
  c.projectile = ProjectileShape<double>{Nose::blunt, 20e-3, 30e-3};
  c.projectile.inner = {bore(6e-3, 30e-3, 30e-3)};
  c.parts = Parts::touching;
  return c;
}

auto shot_of(const PerforationCase<double> &c) {
  const auto steel = with_law<AnyFlowLaw<double>>(library::arne_tool_steel<double>());
  auto soft = with_law<AnyFlowLaw<double>>(library::weldox_460e_jc<double>());
  soft.name = "light";
  soft.density = 2700, soft.elasticity.young = 70e9;
  return make_perforation(c, std::vector{with_law<AnyFlowLaw<double>>(library::weldox_460e_mjc<double>())},
                          std::vector{soft, steel}, {}, AnyDiscretisation{});
}

} // namespace

TEST_CASE("a part that slides on another one loses its energy to friction, and both feel the same forces",
          "[perforation]") {
  SlidingPart sliding;
  const Hex &block = sliding.parts[1];
  const double speed = 20, mass = whole_mass(block.point_mass, {}), energy = 0.5 * mass * speed * speed;
  set_velocity(sliding.nodes, block.nodes, V(speed, 0, 0));
  // It stops after v/(mu g) = 10 us. While it slides, Coulomb's friction is mu times the normal force at every node:
  // the momentum that it has lost is mu times the impulse of the slab, here up to half of the time.
  double time = 0;
  for (; time < 5e-6; time += sliding.dt) sliding.advance();
  const double lost = mass * speed - momentum_of(sliding.nodes, block.nodes)[0];
  const double pressed = mass * gravity * time + momentum_of(sliding.nodes, block.nodes)[2];
  // Friction tips the block by some thousandths, and with it the normals of its lower face: 1 % of mu = 0.2.
  CHECK(lost == Approx(mu * pressed).epsilon(0.02));
  CHECK(std::abs(momentum_of(sliding.nodes, sliding.parts[0].nodes).norm()) == 0);
  // What the slab's supports take is what presses the block: action and reaction.
  CHECK(-sliding.impulse == Approx(-pressed).epsilon(1e-6));
  for (; time < 15e-6; time += sliding.dt) sliding.advance();
  double friction = 0;
  for (const auto &contact : sliding.contacts) friction += friction_energy(contact);
  // All of its energy, but for what bends and bounces under the sudden weight: the height of the bounce is
  // g (h/c)^2, 2 um, and the weight times that is 1 % of the energy.
  CHECK(friction == Approx(energy).epsilon(0.02));
}

TEST_CASE("a jacket that touches its core is left behind, and the shot is that of the core", "[perforation]") {
  const auto c = jacketed();
  const TemporaryFolder folder;
  const auto file = folder.path / "checkpoint.bin";
  struct End {
    std::uint64_t hash;
    double core, jacket, energy_error, momentum_error, depth, turn;
  };
  const auto shoot = [&](int threads, bool restart) {
    omp_set_num_threads(threads);
    auto model = shot_of(c);
    REQUIRE(parts_touch(model));
    REQUIRE(main_part(model) == 1);
    REQUIRE(projectile(model, 1).nodes.begin == projectile(model).nodes.end);
    const auto places = axial_places(model, c);
    const Flight<double> flight = start_flight(c, model);
    // Both end at the same plane.
    CHECK(flight.shorter == 0);
    const double first = total(energy(model)), start = -momentum(model)[2];
    End end{};
    RunState<double> state;
    const auto observe = [&](const auto &now, const Energy<double> &e) {
      end.energy_error = std::max(end.energy_error, std::abs(total(e) / first - 1));
      const double supports = -4 * now.support_impulse[2];
      end.momentum_error = std::max(end.momentum_error, std::abs(-momentum(now)[2] - start - supports) / start);
      return true;
    };
    const RunOptions<double> options{.end_time = 60e-6};
    const auto pause = [&](const auto &now, const auto &run) {
      if (restart && now.steps == 100) write_checkpoint(file, now, run);
      return restart && now.steps == 100;
    };
    auto result = run(model, options, state, observe, pause);
    if (restart) {
      model = shot_of(c);
      restore(read_checkpoint(file), model, state);
      result = run(model, options, state, observe, [](const auto &, const auto &) { return false; });
    }
    if (result.fault) FAIL_CHECK(result.fault->what);
    end.hash = state_hash(model);
    end.jacket = -mean_velocity(model.nodes, nodes_of_part(model, 0))[2];
    end.core = -mean_velocity(model.nodes, nodes_of_part(model, 1))[2];
    const auto sample = observe_flight(model, c.projectile, flight);
    CHECK(sample.velocity == Approx(end.core).epsilon(1e-12));
    end.depth = sample.nose;
    end.turn = motion_of(model, c, places).turn;
    return end;
  };
  const int before = omp_get_max_threads();
  const End one = shoot(1, false), two = shoot(2, false), resumed = shoot(2, true);
  omp_set_num_threads(before);
  CHECK(one.hash == two.hash);
  CHECK(one.hash == resumed.hash);
  INFO("core " << one.core << " jacket " << one.jacket << " m/s, depth " << one.depth);
  // The core is heavier for the area on which the plate brakes it.
  CHECK(one.jacket < one.core - 5);
  CHECK(one.energy_error < 5e-3);
  CHECK(one.momentum_error < 1e-8); // round-off of a thousand steps; a force without its reaction is of order 1
  CHECK(one.turn < 1e-6);
}

TEST_CASE("parts that touch keep mass and names, and need a projectile that deforms", "[perforation]") {
  auto c = jacketed();
  const auto apart = shot_of(c);
  c.parts = Parts::tied;
  const auto tied = shot_of(c);
  CHECK_FALSE(parts_touch(tied));
  CHECK(projectile_mass(apart) == Approx(projectile_mass(tied)).epsilon(1e-12));
  CHECK(projectile_nodes(apart).size() > projectile_nodes(tied).size());
  CHECK(followed_nodes(tied).size() == std::size_t(projectile_nodes(tied).size()));
  REQUIRE(apart.contacts.size() == 3);
  CHECK(apart.contacts[1].name == "parts on projectile_jacket");
  CHECK(apart.contacts[2].name == "parts on projectile_core");
  CHECK(apart.contacts[1].facets.size() + apart.contacts[2].facets.size() == apart.contacts[0].facets.size());
  // Of a quarter neither has facets in the mirror planes.
  for (const Facet &facet : apart.contacts[2].facets) {
    double x = 0, y = 0;
    for (const Index n : facet.nodes) x += apart.nodes.position[n][0], y += apart.nodes.position[n][1];
    CHECK((x > 0 && y > 0));
  }
  CHECK(fingerprint(apart) != fingerprint(tied));
  c.parts = Parts::touching, c.rigid_projectile = true;
  CHECK(refusal_of([&] { shot_of(c); }) == "parts of a rigid projectile = touching: must be tied, it moves as one");
  c.rigid_projectile = false, c.part_friction = -0.1;
  CHECK(refusal_of([&] { shot_of(c); }) == "friction between the projectile's parts = -0.1: must not be negative");
}
