// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "node_sums.hpp"
#include "sim/balance.hpp"
#include "sim/blocks.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/io/frame.hpp"
#include "ogive/perforation/method.hpp"
#include "ogive/perforation/shape.hpp"

#include <map>
#include <omp.h>

using namespace sim_test;

namespace {

/// A brick of nx x ny x nz hexes of edge `h` (m) that can all turn into particles, as a plate: contact 0 is between
/// particles and hexes. The projectile is a hex at rest, far away.
auto convertible_brick(Index nx, Index ny, Index nz, double h, double failure_strain = 0.1) {
  auto metal = brittle(library::weldox_460e_mjc<double>(), FailureEffect::no_tension);
  metal.damage.failure_strain.D1 = failure_strain;
  const auto mesh = brick_at(nx, ny, nz, V(double(nx) * h, double(ny) * h, double(nz) * h), V::Zero());
  ParticleLayout<double> layout{h, {}, {}};
  for (Index e = 0; e < static_cast<Index>(mesh.hexes.size()); ++e) {
    layout.positions.emplace_back(corners(mesh, e).colwise().mean().transpose());
    layout.volumes.push_back(hex_volume<double>(corners(mesh, e)));
  }
  Nodes<double> nodes;
  auto particles = add_sph_body(nodes, layout, metal, "particles");
  metal.damage.effect = FailureEffect::removal;
  auto hexes = add_hex_body(nodes, mesh, metal, "hexes");
  Conversion<double> conversion;
  conversion.options.every = 1;
  conversion.neighbours = face_neighbours(hexes.hexes, nodes, {});
  std::vector<Index> slaves;
  for (Index n = particles.nodes.begin; n < particles.nodes.end; ++n) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), h / 2),
                              exposed_facets(hexes.hexes, conversion.neighbours, [](Index) { return false; }), "own");
  contact.state.reference_time_step = 0.4 * h / sound_speed(metal);
  auto far =
      add_hex_body(nodes, brick_at(1, 1, 1, V(1, 1, 1), V(10, 10, 10)), library::arne_tool_steel<double>(), "far");
  PerforationBodies<decltype(particles), decltype(hexes), decltype(far)> bodies{{particles}, {hexes}, far};
  Model model{std::move(nodes), std::move(bodies), SymmetryPlanes{}};
  model.contacts.push_back(std::move(contact));
  begin_conversion(conversion, model);
  model.conversions.push_back(std::move(conversion));
  return model;
}

template <class M> auto &particles_of(M &model) { return plate_particles(model); }
template <class M> auto &hexes_of(M &model) { return plate_hexes(model); }

/// True if every edge of the facets is run through once in each direction: a closed surface.
bool is_closed(const std::vector<Facet> &facets) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Facet &f : facets)
    for (int k = 0; k < 4; ++k) ++edges[{f.nodes[k], f.nodes[(k + 1) % 4]}];
  for (const auto &[edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) return false;
  }
  return true;
}

auto adaptive_shot(Nose nose, double failure_strain, bool rigid, Extent extent = Extent::quarter) {
  auto c = small_case(nose, extent);
  c.rigid_projectile = rigid;
  auto metal = brittle(library::weldox_460e_mjc<double>(), FailureEffect::no_tension);
  metal.damage.failure_strain.D1 = failure_strain;
  metal.damage.softening = 0.3;
  return make_perforation(c, metal, library::arne_tool_steel<double>(), options_of<double>(Method::adaptive));
}

} // namespace

TEST_CASE("a hex that fails becomes a particle with its mass, momentum and state", "[sim]") {
  auto model = convertible_brick(3, 3, 3, 1e-3);
  auto &nodes = model.nodes;
  for (Index n = 0; n < nodes.size(); ++n) {
    const V &x = nodes.position[n];
    nodes.velocity[n] = V(20 + 3e3 * x[1], -7e3 * x[2], 40 + 1e6 * x[0] * x[1]);
  }
  auto &hexes = hexes_of(model);
  auto &particles = particles_of(model);
  const Index middle = 13;
  hexes.points.damage[middle] = 1.25;
  hexes.points.temperature[middle] = 700;
  hexes.points.plastic_strain[middle] = 1.5;
  hexes.points.internal_energy[middle] = 5000;
  hexes.points.density[middle] = 7900;
  const double mass = total_mass(nodes), before = total(energy(model));
  const V p = momentum(model), moment = first_moment(nodes);
  convert(model.conversions[0], model);

  CHECK(total_mass(nodes) == Approx(mass).epsilon(1e-15));
  CHECK((momentum(model) - p).norm() < 1e-15 * p.norm());
  CHECK((first_moment(nodes) - moment).norm() < 1e-15 * moment.norm());
  CHECK(total(energy(model)) == Approx(before).epsilon(1e-14));
  CHECK(energy(model).conversion > 0);
  CHECK(model.conversions[0].failed == 1);
  CHECK(model.conversions[0].distorted == 0);
  CHECK_FALSE(is_unborn(particles, middle));
  CHECK(is_removed(hexes, middle));
  CHECK(particles.points.damage[middle] == 1.25);
  CHECK(particles.points.temperature[middle] == 700);
  CHECK(particles.points.plastic_strain[middle] == 1.5);
  CHECK(particles.points.internal_energy[middle] == 5000);
  CHECK(particles.points.density[middle] == 7900);
  CHECK(particles.points.pressure[middle] > 0);
  for (Index i = 0; i < 27; ++i) CHECK(is_unborn(particles, i) == (i != middle));
  // The hole has the six faces of its neighbours, so that the surface stays closed, inside too.
  CHECK(model.contacts[0].facets.size() == 54 + 6);
  CHECK(is_closed(model.contacts[0].facets));
  // It goes on, and nothing is lost.
  for (int i = 0; i < 100; ++i) step(model, stable_time_step(model));
  CHECK_FALSE(find_not_finite(model));
  CHECK((momentum(model) - p).norm() < 1e-12 * p.norm());
  CHECK(total(energy(model)) == Approx(before).epsilon(1e-3));
}

TEST_CASE("the time step is looked at as often as hexes are, and every so many steps", "[sim]") {
  auto model = convertible_brick(2, 2, 1, 1e-3);
  model.conversions[0].options.every = 4;
  const double dt = stable_time_step(model);
  std::vector<std::int64_t> due;
  for (; model.steps < 11; step(model, dt))
    if (is_time_step_due(model, 10)) due.push_back(model.steps);
  CHECK(due == std::vector<std::int64_t>{0, 4, 8, 10});
}

TEST_CASE("the work of what ends between two steps is in the ledger as far as it has come", "[sim]") {
  auto model = convertible_brick(16, 4, 4, 1e-3, 100);
  auto &nodes = model.nodes;
  for (Index n = 0; n < nodes.size(); ++n) nodes.velocity[n] = V(400 * (2 * nodes.position[n][0] / 16e-3 - 1), 3, 0);
  for (int i = 0; i < 60; ++i) step(model, stable_time_step(model));
  auto &hexes = hexes_of(model);
  const Index e = 2 * 64 + 2 * 16 + 8; // inside
  double half = 0;
  for (int a = 0; a < 8; ++a)
    half += 0.5 * model.last_step * nodes.velocity[hexes.hexes[e][a]].dot(hexes.corner_force[8 * e + a]);
  REQUIRE(std::abs(half) > 1e-4);
  const double before = total(energy(model));
  hexes.points.damage[e] = 1;
  convert(model.conversions[0], model);
  REQUIRE(model.conversions[0].failed == 1);
  // What is left: the stress is that of the beginning of the half step, the rotation in it is small.
  CHECK(std::abs(total(energy(model)) - before) < 0.02 * std::abs(half));
}

TEST_CASE("a node whose hexes have all gone has no mass, takes part in nothing and is not drawn", "[sim]") {
  auto model = convertible_brick(2, 2, 2, 1e-3);
  auto &hexes = hexes_of(model);
  for (Index e = 0; e < 4; ++e) hexes.points.damage[e] = 1;
  const double mass = total_mass(model.nodes);
  for (int i = 0; i < 20; ++i) step(model, stable_time_step(model));
  CHECK(total_mass(model.nodes) == Approx(mass).epsilon(1e-15));
  Index bare = 0;
  for (Index n = hexes.nodes.begin; n < hexes.nodes.end; ++n) {
    CHECK((model.nodes.mass[n] == 0) == is_node_removed(hexes, n - hexes.nodes.begin));
    bare += model.nodes.mass[n] == 0 ? 1 : 0;
  }
  CHECK(bare == 9);
  CHECK_FALSE(find_not_finite(model));
  CHECK(stable_time_step(model) > 1e-8);
  CHECK(is_closed(model.contacts[0].facets));
  const Frame frame = gather_frame(model);
  CHECK(frame.clouds[0].positions.size() == 4);
  CHECK(frame.grids[0].hexes.size() == 4);
  CHECK(frame.grids[0].positions.size() == 18);
}

TEST_CASE("a hex that is about to invert becomes a particle before it fails, and the run goes on", "[sim]") {
  auto model = convertible_brick(3, 3, 1, 1e-3, 100);
  auto &nodes = model.nodes;
  auto &hexes = hexes_of(model);
  SECTION("its metal has twice its density") { hexes.points.density[4] = 2.01 * hexes.metal.density; }
  SECTION("it has flowed until it is thin") {
    for (int a = 4; a < 8; ++a) nodes.position[hexes.hexes[4][a]][2] = 0.002e-3;
    hexes.points.plastic_strain[4] = 3;
    CHECK(is_too_distorted(hexes, nodes, 4, model.conversions[0].options, 1e-3));
    hexes.points.plastic_strain[4] = 0.1; // what is thin from the start may stay
    CHECK_FALSE(is_too_distorted(hexes, nodes, 4, model.conversions[0].options, 1e-3));
    hexes.points.plastic_strain[4] = 3;
  }
  SECTION("it is folded: one corner lies beyond its opposite face, the volume is sound") {
    nodes.position[hexes.hexes[4][6]][2] = -0.5e-3;
    hexes.points.plastic_strain[4] = 0.5;
    REQUIRE(hex_volume<double>(gather_corners(nodes.position, hexes.hexes[4])) > 0.5e-9);
  }
  SECTION("it is inside out") {
    for (int a = 4; a < 8; ++a) nodes.position[hexes.hexes[4][a]][2] = -0.1e-3;
    hexes.points.plastic_strain[4] = 3;
    CHECK(find_inverted(model));
  }
  hexes.points.pressure[4] = 1e9;
  const double before = total(energy(model)), mass = total_mass(nodes);
  convert(model.conversions[0], model);
  CHECK(model.conversions[0].distorted == 1);
  CHECK(model.conversions[0].failed == 0);
  CHECK(particles_of(model).points.damage[4] == 1);
  CHECK(total_mass(nodes) == Approx(mass).epsilon(1e-15));
  CHECK(total(energy(model)) == Approx(before).margin(1e-12));
}

TEST_CASE("a bar of hexes tears into particles and keeps momentum, mass and energy", "[sim]") {
  auto model = convertible_brick(16, 4, 4, 1e-3);
  auto &nodes = model.nodes;
  for (Index n = 0; n < nodes.size(); ++n) nodes.velocity[n] = V(400 * (2 * nodes.position[n][0] / 16e-3 - 1), 3, 0);
  const double mass = total_mass(nodes), before = total(energy(model));
  const V p = momentum(model);
  double worst = 0;
  while (model.time < 20e-6) {
    step(model, stable_time_step(model));
    if (model.steps % 5 == 0) worst = std::max(worst, std::abs(total(energy(model)) / before - 1));
  }
  CHECK(model.conversions[0].failed > 10);
  CHECK_FALSE(find_not_finite(model));
  CHECK(total_mass(nodes) == Approx(mass).epsilon(1e-14));
  CHECK((momentum(model) - p).norm() < 1e-11 * p.norm());
  CHECK(worst < 0.002);
  CHECK(is_closed(model.contacts[0].facets));
}

TEST_CASE("a particle rests on hexes, and one that is born overlapping them gains no energy", "[sim]") {
  auto model = convertible_brick(4, 4, 3, 1e-3, 100);
  auto &nodes = model.nodes;
  auto &hexes = hexes_of(model);
  const Index e = 2 * 16 + 5; // in the upper layer
  hexes.points.damage[e] = 1;
  convert(model.conversions[0], model);
  const Index n = particles_of(model).nodes.begin + e;
  const auto &contact = model.contacts[0];
  SECTION("it falls into its hole and comes back no faster") {
    nodes.position[n] += V(0, 0, 1e-3);
    nodes.velocity[n] = V(0, 0, -20);
    const double before = total(energy(model));
    double lowest = 1;
    while (model.time < 150e-6) {
      step(model, stable_time_step(model));
      lowest = std::min(lowest, nodes.position[n][2]);
    }
    CHECK(lowest > 2e-3 + 0.4e-3); // its radius is half a millimetre
    CHECK(nodes.velocity[n].norm() < 20.5);
    CHECK(total(energy(model)) == Approx(before).epsilon(1e-3));
  }
  SECTION("born with its middle 0.2 mm deep in the floor") {
    nodes.position[n] = V(1.5e-3, 1.5e-3, 1.8e-3);
    const double before = total(energy(model));
    for (int i = 0; i < 50; ++i) step(model, stable_time_step(model));
    CHECK(contact.state.present_offset[e] == Approx(-0.2e-3).epsilon(1e-6));
    CHECK(nodes.velocity[n].norm() == Approx(0).margin(1e-9));
    CHECK(std::abs(total(energy(model)) - before) < 1e-9);
    // Pulled out it has its full size again, and no energy from that.
    nodes.velocity[n] = V(0, 0, 50);
    while (nodes.position[n][2] < 3.5e-3) step(model, stable_time_step(model));
    CHECK(contact.state.present_offset[e] == 0.5e-3);
    CHECK(nodes.velocity[n][2] == Approx(50).epsilon(1e-9));
  }
  SECTION("born as deep as a slave may get, it is not lost when it is pressed on, and comes back no faster") {
    REQUIRE(contact.search_margin == Approx(1e-3));
    nodes.position[n] = V(2e-3, 2e-3, 2.02e-3);
    nodes.velocity[n] = V(0, 0, -20);
    double lowest = 1;
    for (int i = 0; i < 100; ++i) {
      step(model, stable_time_step(model));
      lowest = std::min(lowest, nodes.position[n][2]);
    }
    CHECK(lowest < 2e-3);
    CHECK(contact.state.lost < 0);
    CHECK(nodes.velocity[n][2] > 0);
    CHECK(nodes.velocity[n].norm() < 20.5);
  }
}

TEST_CASE("a plate of hexes has the particle's size, a ring astride the projectile's edge, and is closed", "[sim]") {
  const auto extent = GENERATE(Extent::quarter, Extent::half, Extent::full);
  const auto model = adaptive_shot(Nose::blunt, 1, false, extent);
  const auto &hexes = plate_hexes(model);
  double mass = 0;
  Index onto = 0;
  for (Index n = hexes.nodes.begin; n < hexes.nodes.end; ++n) {
    const V &x = model.nodes.position[n];
    mass += model.nodes.mass[n];
    const double r = std::hypot(x[0], x[1]);
    onto += r > 9.4e-3 && r < 10.6e-3 ? 1 : 0; // the ring astride the edge is 1.5 mm wide
  }
  CHECK(onto == 0);
  // That ring is as wide as the hexes are high, 6 mm in four layers: the plug is sheared off in it.
  for (const double r : {9.25e-3, 10.75e-3}) {
    Index on = 0;
    for (Index n = hexes.nodes.begin; n < hexes.nodes.end; ++n)
      on += std::abs(std::hypot(model.nodes.position[n][0], model.nodes.position[n][1]) - r) < 1e-9 ? 1 : 0;
    CHECK(on >= 5 * 9);
  }
  const double pi = 3.14159265358979;
  CHECK(mass * model.symmetry.copies() == Approx(7850 * pi * 40e-3 * 40e-3 * 6e-3).epsilon(0.02));
  for (Index i = 0; i < plate_particles(model).points.size(); ++i) {
    CHECK(is_unborn(plate_particles(model), i));
    CHECK(model.nodes.mass[plate_particles(model).nodes.begin + i] == 0);
  }
  if (extent == Extent::full) CHECK(is_closed(model.contacts[1].facets));
  CHECK(find_fragments(model).plug_mass == 0);
  CHECK(gather_frame(model).clouds[0].positions.empty());
}

TEST_CASE("a shot through a plate of hexes keeps momentum and energy, and a plug comes out", "[sim]") {
  const bool rigid = GENERATE(false, true);
  auto model = adaptive_shot(Nose::blunt, 0.5, rigid);
  const auto undeformed = plate_positions(model);
  const Balance balance = follow(model, 60e-6);
  CHECK(balance.energy_error < 0.005);
  CHECK(balance.momentum_error < 1e-10);
  CHECK(model.conversions[0].failed > 10);
  const auto fragments = find_fragments(model);
  CHECK(fragments.failed == model.conversions[0].failed + model.conversions[0].distorted);
  CHECK(fragments.plug_mass > 4e-3);
  CHECK(fragments.plug_velocity > 100);
  CHECK(largest_intrusion(model) < 0.2e-3);
  const auto shape = plate_shape(model, undeformed, 10e-3, 6e-3);
  CHECK(shape.plug_thickness > 3e-3);
  CHECK(shape.plug_thickness < 8e-3);
  CHECK(shape.most_temperature > 350);
}

TEST_CASE("a plate of hexes has the same bits with any number of threads and across a restart", "[sim]") {
  const TemporaryFolder folder;
  const auto go_on = [](const auto &, const auto &) { return true; };
  const RunOptions<double> options{.end_time = 20e-6};
  const auto make = [] { return adaptive_shot(Nose::conical, 0.3, false); };
  const auto hash_with = [&](int threads, std::int64_t stop) {
    omp_set_num_threads(threads);
    auto model = make();
    RunState<double> state;
    const auto saved = [&](const auto &m, const auto &s) {
      if (m.steps == stop) write_checkpoint(folder.path / "c", m, s);
      return m.steps == stop;
    };
    run(model, options, state, go_on, saved);
    if (stop >= 0) {
      model = make();
      omp_set_num_threads(5 - threads);
      restore(read_checkpoint(folder.path / "c"), model, state);
      run(model, options, state, go_on, [](const auto &, const auto &) { return false; });
    }
    REQUIRE(model.time >= options.end_time);
    REQUIRE(model.conversions[0].failed > 5);
    const auto e = energy(model);
    return std::tuple(state_hash(model), total(e), e.conversion, e.contact, find_fragments(model).plug_mass,
                      model.contacts[1].facets.size(), model.steps);
  };
  const int before = omp_get_max_threads();
  const auto one = hash_with(1, -1);
  for (const int threads : {2, 4}) CHECK(hash_with(threads, -1) == one);
  for (const std::int64_t stop : {0, 1, 90, 91, 92, 93, 94, 150}) CHECK(hash_with(stop % 2 == 0 ? 1 : 3, stop) == one);
  omp_set_num_threads(before);
}
