// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "sim/blocks.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/perforation/flight.hpp"
#include "ogive/sim/erosion.hpp"

#include <omp.h>

#include <map>
#include <utility>

using namespace sim_test;

namespace {

/// A block of 3 x 3 x 3 hexes of 1 mm that may be removed, with a particle that its surface may touch.
auto block() {
  Nodes<double> nodes;
  const auto mesh = brick_at(3, 3, 3, V::Constant(3e-3), V::Zero());
  auto body = add_hex_body(nodes, mesh, fem_test::steel<double>(), "block");
  allow_erosion(body);
  const NodeRange free = add_nodes(nodes, {V(1.5e-3, 1.5e-3, 3.2e-3)});
  nodes.mass[free.begin] = 1e-6;
  auto contact = make_contact(nodes, {free.begin}, {0.25e-3}, boundary_facets(mesh), "particle on block");
  contact.eroding = {0};
  auto model = model_of(std::move(nodes), std::move(body));
  model.contacts.push_back(std::move(contact));
  return model;
}

auto &hexes(auto &model) { return std::get<0>(model.bodies); }

/// Number of the hex in column i, row j and layer k.
Index at(Index i, Index j, Index k) { return (k * 3 + j) * 3 + i; }

double mass_of(const Nodes<double> &nodes) {
  double mass = 0;
  for (const double m : nodes.mass) mass += m;
  return mass;
}

} // namespace

TEST_CASE("the surface after a removal is that of the hexes that are left", "[sim]") {
  auto model = block();
  const auto facets = [&] { return exposed_facets(model, model.contacts.front()).size(); };
  const auto remove = [&](Index e) { remove_hex(hexes(model), model.nodes, e, 0.0); };
  CHECK(facets() == 54);
  remove(at(1, 1, 1)); // the one in the middle: its six faces lie open within
  CHECK(facets() == 60);
  remove(at(0, 0, 0)); // a corner: three go, three come
  CHECK(facets() == 60);
  remove(at(1, 1, 0)); // one above the hole: two go, four come
  CHECK(facets() == 62);
  for (Index e = 0; e < 9; ++e)
    if (!is_removed(hexes(model), e)) remove(e);
  // What is left are two layers, 2 x 9 + 4 x 6, with a hole in the lower one: a facet goes, five come.
  CHECK(facets() == 46);
  CHECK(removed_hexes(model).count == 10);
  CHECK(removed_hexes(model).mass == Approx(10 * hexes(model).metal.density * 1e-9));
  // Each edge of the surface belongs to two facets, or to four.
  std::map<std::pair<Index, Index>, int> edges;
  for (const Facet &facet : exposed_facets(model, model.contacts.front()))
    for (std::size_t k = 0; k < 4; ++k) ++edges[std::minmax({facet.nodes[k], facet.nodes[(k + 1) % 4]})];
  for (const auto &[edge, count] : edges) CHECK(count % 2 == 0);
}

TEST_CASE("faces that a removal exposes in a mirror plane are no surface", "[sim]") {
  auto model = block();
  model.symmetry.x = true;
  for (Index n = 0; n < model.nodes.size(); ++n)
    if (model.nodes.position[n][0] == 0) model.nodes.held[n] = held_x;
  CHECK(exposed_facets(model, model.contacts.front()).size() == 45);
  // Behind the middle of the plane: its face there is none, the other five come.
  remove_hex(hexes(model), model.nodes, at(0, 1, 1), 0.0);
  CHECK(exposed_facets(model, model.contacts.front()).size() == 50);
}

TEST_CASE("a hex is too distorted without volume, with a face turned inside out or with a short time step", "[sim]") {
  auto model = block();
  auto &body = hexes(model);
  const double step = stable_time_step_of_hex(body, model.nodes, 0);
  for (Index e = 0; e < 27; ++e) CHECK_FALSE(is_too_distorted(body, model.nodes, e, 0.9 * step));
  CHECK(is_too_distorted(body, model.nodes, 0, 1.1 * step));
  // The upper layer is squashed to a quarter of its height: less than the share that may be left.
  for (V &x : model.nodes.position)
    if (x[2] > 2.5e-3) x[2] = 2e-3 + 0.31 * (x[2] - 2e-3);
  CHECK_FALSE(is_too_distorted(body, model.nodes, at(1, 1, 2), 0.0));
  for (V &x : model.nodes.position)
    if (x[2] > 2.2e-3) x[2] = 2.29e-3;
  CHECK(is_too_distorted(body, model.nodes, at(1, 1, 2), 0.0));
  CHECK_FALSE(is_too_distorted(body, model.nodes, at(1, 1, 1), 0.0));
  // A corner that is pushed through the opposite faces, with half of the volume left.
  auto other = block();
  other.nodes.position[0] = V::Constant(1.5e-3);
  CHECK(has_turned_face(gather_corners(other.nodes.position, hexes(other).hexes[0])));
  CHECK(is_too_distorted(hexes(other), other.nodes, 0, 0.0));
}

TEST_CASE("the books close over a removal, and the mass stays at the nodes", "[sim]") {
  auto model = block();
  fem_test::Noise noise;
  for (Index n = 0; n < 64; ++n) model.nodes.velocity[n] = 20 * noise.vector();
  const double dt = 0.5 * stable_time_step(model);
  for (int k = 0; k < 40; ++k) step(model, dt);
  const auto e = total(energy(model));
  const V p = momentum(model);
  const double mass = mass_of(model.nodes), stored = energy(model).elastic;
  // A quarter of all hexes.
  for (const Index hex : {0, 4, 8, 12, 13, 20, 26}) remove_hex(hexes(model), model.nodes, hex, dt);
  CHECK(mass_of(model.nodes) == mass);
  CHECK(energy(model).elastic < 0.9 * stored);
  step(model, dt);
  // An elastic block keeps its energy to 1e-5 in a step of finite strain. Half a step's work of the removed forces,
  // which are a quarter of all, would be missing otherwise: f v dt/2 with v of 20 m/s is some 1e-2 of the energy.
  CHECK(total(energy(model)) == Approx(e).epsilon(2e-4));
  CHECK((momentum(model) - p).norm() < 1e-12 * mass * 20);
  const auto gone = energy(model);
  for (int k = 0; k < 40; ++k) step(model, dt);
  CHECK(total(energy(model)) == Approx(e).epsilon(2e-3));
  CHECK(hexes(model).points.internal_energy[13] == hexes(model).points.internal_energy[13]);
  CHECK(energy(model).elastic < 2 * gone.elastic + stored);
  // A corner of the block that has no hex any more flies on.
  const V velocity = model.nodes.velocity[0];
  step(model, dt);
  CHECK((model.nodes.velocity[0] - velocity).norm() == 0);
}

TEST_CASE("a slave keeps its force while its facet stays, and gives it up with its work where it goes", "[sim]") {
  auto model = block();
  auto &contact = model.contacts.front();
  model.nodes.position[64][2] = 3.25e-3 - 1e-7; // the particle touches the middle of the upper face
  model.nodes.velocity[64] = V(0, 0, -10);
  for (int k = 0; k < 2; ++k) step(model, 1e-8);
  REQUIRE(contact.state.near.forces[0].facet >= 0);
  const auto corners = contact.facets[contact.state.near.forces[0].facet].nodes;
  const double before = total(energy(model));
  remove_hex(hexes(model), model.nodes, at(0, 0, 0), 1e-8); // far away: other facets come and go
  replace_facets(contact, model.nodes, exposed_facets(model, contact), 1e-8);
  REQUIRE(contact.state.near.forces[0].facet >= 0);
  CHECK(contact.facets[contact.state.near.forces[0].facet].nodes == corners);
  remove_hex(hexes(model), model.nodes, at(1, 1, 2), 1e-8); // the one that it touches
  const double energy_before = normal_energy(contact);
  const auto force = contact.state.near.forces[0];
  replace_facets(contact, model.nodes, exposed_facets(model, contact), 1e-8);
  CHECK(contact.state.near.forces[0].facet == -1);
  // The second half of the step's work, -f v dt/2; the facet moves too, by a tenth of that.
  CHECK(normal_energy(contact) - energy_before ==
        Approx(-0.5e-8 * force.normal[2] * model.nodes.velocity[64][2]).epsilon(0.2));
  step(model, 1e-8);
  CHECK(total(energy(model)) == Approx(before).epsilon(1e-3));
}

TEST_CASE("a shot whose soft projectile loses hexes keeps its books, and resumes to the last bit", "[sim]") {
  const TemporaryFolder folder;
  const auto file = folder.path / "checkpoint.bin";
  auto c = small_case(Nose::blunt, Extent::quarter);
  c.projectile = ProjectileShape<double>{Nose::blunt, 20e-3, 20e-3};
  c.initial_velocity = 900;
  auto copper = library::arne_tool_steel<double>();
  copper.flow = {150e6, 100e6};
  const auto make = [&] { return make_perforation(c, library::weldox_460e_mjc<double>(), copper); };
  struct End {
    std::uint64_t hash;
    Index removed, facets;
    double mass, energy_error, momentum_error;
    std::int64_t first;
  };
  const auto shoot = [&](int threads, std::int64_t pause_at) {
    omp_set_num_threads(threads);
    auto model = make();
    const double whole = total(energy(model)), mass = mass_of(model.nodes), start = -momentum(model)[2];
    End end{};
    end.first = -1;
    RunState<double> state;
    const auto observe = [&](const auto &now, const Energy<double> &e) {
      end.energy_error = std::max(end.energy_error, std::abs(total(e) / whole - 1));
      const double supports = -4 * now.support_impulse[2];
      end.momentum_error = std::max(end.momentum_error, std::abs(-momentum(now)[2] - start - supports) / start);
      return true;
    };
    const RunOptions<double> options{.end_time = 40e-6};
    const auto pause = [&](const auto &now, const auto &run) {
      if (end.first < 0 && removed_hexes(now).count > 0) end.first = now.steps;
      if (now.steps != pause_at) return false;
      write_checkpoint(file, now, run);
      return true;
    };
    auto result = run(model, options, state, observe, pause);
    if (result.reason == StopReason::pause) {
      model = make();
      restore(read_checkpoint(file), model, state);
      result = run(model, options, state, observe, [](const auto &, const auto &) { return false; });
    }
    if (result.fault) FAIL_CHECK(result.fault->what);
    CHECK(mass_of(model.nodes) == mass);
    end.hash = state_hash(model);
    end.removed = removed_hexes(model).count, end.mass = removed_hexes(model).mass;
    end.facets = static_cast<Index>(model.contacts.front().facets.size());
    const Flight<double> flight = start_flight(c);
    CHECK(observe_flight(model, c.projectile, flight).velocity < 900);
    CHECK(followed_nodes(model).size() <= std::size_t(projectile_nodes(model).size()));
    return end;
  };
  const int before = omp_get_max_threads();
  const End one = shoot(1, -1);
  INFO("removed " << one.removed << " from step " << one.first);
  REQUIRE(one.removed > 3);
  const End two = shoot(2, -1), early = shoot(1, one.first), late = shoot(2, one.first + 37);
  omp_set_num_threads(before);
  for (const End &other : {two, early, late}) {
    CHECK(other.hash == one.hash);
    CHECK(other.facets == one.facets);
  }
  CHECK(one.mass < 0.5 * projectile_mass(make()) / 4); // so soft and fast a projectile loses a quarter
  CHECK(one.energy_error < 5e-3);
  CHECK(one.momentum_error < 1e-9);

  // Without removal the same shot does not come to its end.
  c.erosion = false;
  auto model = make();
  const auto go_on = [](const auto &, const auto &) { return true; };
  const auto result = run(model, RunOptions<double>{.end_time = 40e-6}, go_on);
  REQUIRE(result.fault);
  CHECK(removed_hexes(model).count == 0);
}
