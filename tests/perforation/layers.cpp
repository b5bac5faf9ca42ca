// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "perforation/refusal.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/io/frame.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/perforation/shape.hpp"
#include "ogive/sim/hash.hpp"

#include <numbers>
#include <omp.h>

using namespace ogive;

namespace {

/// A coarse target that is struck fast: 3 mm of steel and, behind, 3 mm of aluminium.
PerforationCase<double> two_plates(double gap = 0) {
  PerforationCase<double> c;
  c.thickness = 3e-3;
  c.clamp_radius = 40e-3;
  c.sph_radius = 15e-3;
  c.spacing = 1.5e-3;
  c.initial_velocity = 300;
  c.behind = {{gap, 3e-3}};
  return c;
}

auto build(const PerforationCase<double> &c) {
  std::vector plates{library::weldox_460e_mjc<double>(), library::aa5083_h116_mjc<double>()};
  plates.resize(1 + c.behind.size(), plates.back());
  return make_perforation(c, plates, library::arne_tool_steel<double>());
}

using Target = decltype(build({}));

double depth_of(const Target &model, Index node) { return -model.nodes.position[node][2]; }

} // namespace

TEST_CASE("plates stand behind each other with their masses, rims, ties and clamps", "[perforation]") {
  auto c = two_plates(2e-3);
  c.behind.push_back({0, 4.5e-3});
  CHECK(target_depth(c) == Approx(12.5e-3));
  const auto model = build(c);
  const auto layers = layers_of(c);
  REQUIRE(model.bodies.plate_particles.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const double area = std::numbers::pi * c.clamp_radius * c.clamp_radius, density = k == 0 ? 7850 : 2700;
    CHECK(whole_mass(plate_particles(model, k).point_mass, model.symmetry) +
              whole_mass(plate_hexes(model, k).point_mass, model.symmetry) ==
          Approx(density * area * layers[k].thickness).epsilon(0.01));
    CHECK(plate_particles(model, k).name == "disc_" + std::to_string(k + 1));
    CHECK(plate_hexes(model, k).name == "rim_" + std::to_string(k + 1));
    double top = 1, bottom = 0;
    for (Index n = plate_particles(model, k).nodes.begin; n < plate_particles(model, k).nodes.end; ++n)
      top = std::min(top, depth_of(model, n)), bottom = std::max(bottom, depth_of(model, n));
    CHECK(top == Approx(layers[k].front + plate_particles(model, k).spacing / 2));
    CHECK(bottom == Approx(layers[k].front + layers[k].thickness - plate_particles(model, k).spacing / 2));
    int clamped = 0;
    for (Index n = plate_hexes(model, k).nodes.begin; n < plate_hexes(model, k).nodes.end; ++n) {
      CHECK(depth_of(model, n) >= layers[k].front);
      CHECK(depth_of(model, n) <= layers[k].front + layers[k].thickness * (1 + 1e-12));
      clamped += model.nodes.held[n] == held_all;
    }
    CHECK(clamped > 20);
  }
  CHECK(model.ties.size() == 3);
  CHECK(model.contacts[0].slaves.size() == std::size_t(projectile(model).nodes.begin)); // all nodes of all plates
  CHECK(start_flight(c).plate_thickness == Approx(12.5e-3));
  const Frame frame = gather_frame(model);
  CHECK(frame.clouds.size() == 3);
  CHECK(frame.grids.size() == 4);
}

TEST_CASE("plates without a gap touch without any force", "[perforation]") {
  auto c = two_plates();
  c.behind.push_back({0, 3e-3});
  c.lattice = GENERATE(Lattice::ring, Lattice::cubic);
  auto model = build(c);
  auto &nodes = model.nodes;
  for (auto &f : nodes.force) f.setZero();
  for (std::size_t k = 1; k < model.contacts.size(); ++k) add_contact_force(model.contacts[k], nodes, 0.0, 1e-7);
  REQUIRE(model.particle_contacts.size() == 1);
  add_contact_force(model.particle_contacts[0], nodes, 0.0);
  CHECK_FALSE(model.particle_contacts[0].nearby.empty());
  for (const auto &f : nodes.force) CHECK(f.norm() == 0);
}

TEST_CASE("what flies through the hole of a plate is not taken for within its rim", "[perforation]") {
  auto c = two_plates();
  auto model = build(c);
  auto &nodes = model.nodes;
  const Index flying = plate_particles(model).nodes.begin;
  const auto force_at = [&](double radius, double depth) {
    nodes.position[flying] = Vec3<double>(0.6 * radius, 0.8 * radius, -depth);
    for (auto &f : nodes.force) f.setZero();
    for (std::size_t k = 1; k < 3; ++k) add_contact_force(model.contacts[k], nodes, 0.0, 1e-7);
    return Vec3<double>(nodes.force[flying]);
  };
  const double half = 0.5 * c.spacing;
  for (const double radius : {5e-3, 12e-3, c.sph_radius - 1.5 * half})
    for (const double depth : {2e-3, 3.2e-3, 4.5e-3, 5.9e-3, 6.1e-3}) CHECK(force_at(radius, depth).norm() == 0);
  CHECK(force_at(c.sph_radius + 5e-3, 3e-3 + 0.1e-3 - half)[2] > 0); // on the second rim's front face
  CHECK(force_at(c.sph_radius + 5e-3, 6e-3 - 0.1e-3 + half)[2] < 0); // on its rear face
  CHECK(model.contacts[1].state.lost == -1);
  CHECK(model.contacts[2].state.lost == -1);
}

TEST_CASE("one plate is built as it was: no contact but that with the projectile", "[perforation]") {
  auto c = two_plates();
  c.behind.clear();
  const auto model = build(c);
  CHECK(model.contacts.size() == 1);
  CHECK(model.particle_contacts.empty());
  CHECK(plate_particles(model).name == "disc");
  CHECK(plate_hexes(model).name == "rim");
}

TEST_CASE("a shot through two plates keeps its energy and lets nothing through", "[perforation]") {
  const double gap = GENERATE(0.0, 4e-3);
  const auto c = two_plates(gap);
  auto model = build(c);
  Flight<double> flight = start_flight(c);
  double error = 0, first = 0, fullest = 0;
  double early = 0;
  const auto before = plate_positions(model, 1);
  const auto result = run(model, RunOptions<double>{.end_time = 150e-6}, [&](const auto &now, const auto &ledger) {
    if (first == 0) first = total(ledger);
    error = std::max(error, std::abs(total(ledger) / first - 1));
    for (const double full : now.particle_contacts[0].fullness) fullest = std::max(fullest, full);
    // 4 mm at 300 m/s are 13 us; the first plate's plug is there a little earlier.
    if (gap > 0 && now.time < 9e-6)
      for (Index i = 0; i < Index(before.size()); ++i)
        early = std::max(early, (now.nodes.position[plate_particles(now, 1).nodes.begin + i] - before[i]).norm());
    record(flight, observe_flight(now, c.projectile, flight), [&] { return find_way(now, flight); });
    return flight.state == FlightState::in_progress;
  });
  REQUIRE_FALSE(result.fault);
  CHECK(flight.state == FlightState::perforated);
  CHECK(early < 1e-12);
  CHECK(error < 5e-3);
  CHECK(fullest > 0.1);
  CHECK(fullest < 0.6); // no particle's centre is more than a tenth of a particle distance within the other plate
  CHECK(largest_intrusion(model) < 0.5 * c.spacing);
  const auto whole = find_fragments(model), upper = find_fragments_of(model, 0), lower = find_fragments_of(model, 1);
  CHECK(whole.plug_mass == Approx(upper.plug_mass + lower.plug_mass));
  CHECK(upper.plug_mass > 3e-3);    // 7.4 g of steel and 2.5 g of aluminium lie in the projectile's way
  CHECK(lower.plug_mass > 0.25e-3); // petals stay on; a loose plug is its share of a gram
  // What the projectile has pushed out lies below what hangs on, in the order of the plates.
  for (std::size_t k = 0; k < 2; ++k) {
    const auto shape = plate_shape(model, k == 0 ? plate_positions(build(c), 0) : before, 10e-3, layers_of(c)[k], k);
    CHECK(shape.kept_fraction < 0.7); // the aluminium leaves petals
    CHECK(shape.dishing > 0);
  }
}

TEST_CASE("a shot at two plates has the same bits with any number of threads and across a restart", "[perforation]") {
  const TemporaryFolder folder;
  auto plates = std::vector{library::weldox_460e_mjc<double>(), library::aa5083_h116_mjc<double>()};
  for (auto &plate : plates) {
    plate.damage.law = DamageLaw::johnson_cook;
    plate.damage.effect = FailureEffect::removal;
    plate.damage.failure_strain = {0.1, 0, 0, 0, 0, 1};
  }
  const auto make = [&] { return make_perforation(two_plates(0.5e-3), plates, library::arne_tool_steel<double>()); };
  const RunOptions<double> options{.end_time = 25e-6};
  const auto go_on = [](const auto &, const auto &) { return true; };
  const auto hash_with = [&](int threads, int stop) {
    omp_set_num_threads(threads);
    auto model = make();
    RunState<double> state;
    const auto result = run(model, options, state, go_on, [&](const auto &now, const auto &run_state) {
      if (now.steps == stop) write_checkpoint(folder.path / "c", now, run_state);
      return now.steps == stop;
    });
    INFO((result.fault ? result.fault->what : "no fault"));
    if (stop > 0) {
      const double before = total(energy(model));
      model = make();
      omp_set_num_threads(4 - threads);
      restore(read_checkpoint(folder.path / "c"), model, state);
      CHECK(total(energy(model)) == before);
      run(model, options, state, go_on, [](const auto &, const auto &) { return false; });
    }
    REQUIRE(model.time >= options.end_time);
    CHECK(normal_energy(model.particle_contacts[0]) != 0);
    CHECK(find_fragments(model).failed > 3);
    return std::pair(state_hash(model), total(energy(model)));
  };
  const int before = omp_get_max_threads();
  const auto one = hash_with(1, -1);
  for (const int threads : {2, 3}) CHECK(hash_with(threads, -1) == one);
  for (const int stop : {1, 67, 103, 151}) CHECK(hash_with(1 + stop % 3, stop) == one);
  omp_set_num_threads(before);
}

TEST_CASE("targets that do not fit together are refused with a line that says why", "[perforation]") {
  const auto refused = [](auto change) {
    auto c = two_plates();
    change(c);
    return refusal_of([&] { build(c); });
  };
  using Case = PerforationCase<double>;
  CHECK(refused([](Case &) {}) == "accepted");
  CHECK(refused([](Case &c) { c.behind[0].gap = -1e-3; }) == "gap before plate 2 (m) = -0.001: must not be negative");
  CHECK(refused([](Case &c) { c.behind[0].thickness = 0; }) == "thickness of plate 2 (m) = 0: must be positive");
  CHECK_THAT(refused([](Case &c) { c.behind[0].thickness = std::nan(""); }), Catch::Contains("thickness of plate 2"));
  CHECK_THAT(refused([](Case &c) { c.behind[0].thickness = 2e-3; }), Catch::Contains("particle distance (m) = 0.0015"));
  CHECK(refused([](Case &c) { c.behind.resize(8, c.behind[0]); }) == "number of plates = 9: must be 1 to 8");
  CHECK_THROWS_WITH(make_perforation(two_plates(), std::vector{library::weldox_460e_mjc<double>()},
                                     library::arne_tool_steel<double>()),
                    "number of the plates' metals = 1: must be 2, one for each plate");
}
