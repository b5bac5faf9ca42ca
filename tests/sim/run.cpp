// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/mesh/facets.hpp"

#include <cmath>
#include <limits>

using namespace sim_test;

namespace {

constexpr double spacing = 1e-3;

/// A block of particles and a brick of hexes that fly apart.
auto two_bodies() {
  Nodes<double> nodes;
  auto particles = add_sph_body(nodes, lattice(4, 4, 4, spacing), fem_test::steel<double>(), "particles");
  auto hexes =
      add_hex_body(nodes, brick_at(3, 3, 3, V::Constant(3e-3), V(0, 0, 6e-3)), fem_test::steel<double>(), "hexes");
  set_velocity(nodes, hexes.nodes, V(0, 0, 100));
  return model_of(std::move(nodes), std::move(particles), std::move(hexes));
}

const auto go_on = [](const auto &, const auto &) { return true; };

} // namespace

TEST_CASE("the observer is called at the start, at intervals and at the end", "[sim]") {
  auto model = two_bodies();
  std::vector<double> times;
  const double dt = stable_time_step(model);
  const RunResult result = run(model, RunOptions<double>{.end_time = 5.2e-6, .observe_every = 1e-6},
                               [&](const auto &m, const Energy<double> &ledger) {
                                 times.push_back(m.time);
                                 CHECK(total(ledger) == total(energy(m)));
                                 return true;
                               });
  CHECK(result.reason == StopReason::end_time);
  CHECK_FALSE(result.fault);
  REQUIRE(times.size() == 7);
  CHECK(times[0] == 0);
  for (int k = 1; k <= 5; ++k) {
    CHECK(times[k] >= k * 1e-6);
    CHECK(times[k] < k * 1e-6 + dt * 1.001);
  }
  CHECK(times[6] == model.time);
  CHECK(model.time >= 5.2e-6 * (1 - 1e-12));
  CHECK(model.time < 5.2e-6 + dt * 1.001);
}

TEST_CASE("the observer is called once for each time", "[sim]") {
  auto model = two_bodies(); // the end is an interval's end too
  std::vector<double> times;
  run(model, RunOptions<double>{.end_time = 3e-6, .observe_every = 1e-6}, [&](const auto &m, const auto &) {
    times.push_back(m.time);
    return true;
  });
  REQUIRE(times.size() >= 2);
  for (std::size_t k = 1; k < times.size(); ++k) CHECK(times[k] > times[k - 1]);
}

TEST_CASE("the observer ends a run by returning false", "[sim]") {
  for (const int last : {1, 3}) {
    auto model = two_bodies();
    int calls = 0;
    const RunResult result = run(model, RunOptions<double>{.end_time = 9e-6, .observe_every = 1e-6},
                                 [&](const auto &, const auto &) { return ++calls < last; });
    CHECK(result.reason == StopReason::observer);
    CHECK_FALSE(result.fault);
    CHECK(calls == last);
    CHECK(model.time < last * 1e-6);
  }
}

TEST_CASE("a velocity that is not a number stops the run with the body's name", "[sim]") {
  for (const bool in_hexes : {true, false}) {
    auto model = two_bodies();
    const Index broken = in_hexes ? std::get<1>(model.bodies).nodes.begin + 5 : 9;
    int calls = 0;
    double last = -1;
    const RunResult result =
        run(model, RunOptions<double>{.end_time = 20e-6, .observe_every = 1e-6}, [&](const auto &m, const auto &) {
          if (++calls == 3) model.nodes.velocity[broken][1] = std::nan("");
          last = m.time;
          return true;
        });
    REQUIRE(result.reason == StopReason::fault);
    REQUIRE(result.fault);
    CHECK(result.fault->body == (in_hexes ? "hexes" : "particles"));
    // It has spread for up to 20 steps; the first node of the body that is hit is named.
    CHECK(result.fault->id >= 0);
    CHECK(result.fault->id <= (in_hexes ? 5 : 9));
    CHECK(result.fault->what.find("not a finite number: (") != std::string::npos);
    CHECK(result.fault->what.find("nan") != std::string::npos);
    CHECK(result.fault->time_us == Approx(model.time * 1e6));
    CHECK(last == model.time); // a last look, at the fault
    CHECK(model.time < 3.5e-6 + 20 * stable_time_step(two_bodies()));
  }
}

TEST_CASE("particles that are not numbers do not bring the neighbour search down", "[sim]") {
  // The other particles fly apart, so that lists are built anew while one position is not a number.
  auto model = two_bodies();
  for (Index n = 0; n < std::get<0>(model.bodies).nodes.end; ++n)
    model.nodes.velocity[n] = 2e5 * model.nodes.position[n];
  model.nodes.velocity[21] = V::Constant(std::nan(""));
  const RunResult result = run(model, RunOptions<double>{.end_time = 20e-6}, go_on);
  REQUIRE(result.fault);
  CHECK(result.fault->body == "particles");
}

TEST_CASE("an inverted hex stops the run", "[sim]") {
  auto model = two_bodies();
  const Index corner = std::get<1>(model.bodies).nodes.begin; // it belongs to hex 0 only
  int calls = 0;
  double last = -1;
  const RunResult result =
      run(model, RunOptions<double>{.end_time = 20e-6, .observe_every = 1}, [&](const auto &m, const auto &) {
        if (++calls == 1) model.nodes.position[corner] += V::Constant(2e-3); // through the hex and out again
        last = m.time;
        return true;
      });
  REQUIRE(result.fault);
  CHECK(result.fault->what.find("a hex has no volume left: ") == 0);
  CHECK(result.fault->what.find(" mm3 at (") != std::string::npos);
  CHECK(result.fault->body == "hexes");
  CHECK(result.fault->id == 0);
  CHECK(calls == 2); // at the start, and a last look
  CHECK(last == model.time);
}

TEST_CASE("a facet that turns inside out stops the run", "[sim]") {
  Nodes<double> nodes;
  const auto mesh = brick_at(1, 1, 2, V(1e-3, 1e-3, 2e-3), V::Zero());
  auto target = add_hex_body(nodes, mesh, fem_test::steel<double>(), "target");
  auto block = add_sph_body(nodes, lattice(1, 1, 1, spacing, V(0, 0, 5e-3)), fem_test::steel<double>(), "block");
  auto contact = make_contact(nodes, {block.nodes.begin}, {0.5 * spacing}, boundary_facets(mesh), "block on target");
  auto model = model_of(std::move(nodes), std::move(target), std::move(block));
  model.contacts.push_back(std::move(contact));
  CHECK_FALSE(find_turned(model));
  // The upper face is mirrored in its diagonal and shrinks: the hex keeps some of its volume.
  const auto hex = std::get<0>(model.bodies).hexes[1];
  const V middle(0.5e-3, 0.5e-3, 2e-3);
  std::swap(model.nodes.position[hex[5]], model.nodes.position[hex[7]]);
  for (int a = 4; a < 8; ++a) model.nodes.position[hex[a]] = middle + 0.5 * (model.nodes.position[hex[a]] - middle);
  REQUIRE(hex_volume<double>(gather_corners(model.nodes.position, hex)) > 0);
  CHECK_FALSE(find_inverted(model));
  const RunOptions<double> options;
  const auto fault = find_fault(model, options, begin_run(model, options));
  REQUIRE(fault);
  CHECK(fault->kind == FaultKind::inverted);
  CHECK(fault->what == "a facet of the contact \"block on target\" has turned inside out, its hex has folded: at (0.5, "
                       "0.5, 2) mm");
  CHECK(fault->body == "target");
  CHECK(fault->id == 1);
}

TEST_CASE("a hex that is inverted at one of its points only stops the run", "[sim]") {
  Nodes<double> nodes;
  auto brick = add_hex_body<SelectiveReduced>(nodes, brick_at(2, 2, 2, V::Constant(2e-3), V::Zero()),
                                              fem_test::steel<double>(), "brick");
  auto model = model_of(std::move(nodes), std::move(brick));
  const auto &hex = std::get<0>(model.bodies).hexes[7];
  RunState<double> state = begin_run(model, RunOptions<double>{});
  model.nodes.position[hex[6]] -= V::Constant(0.7e-3); // the outer corner through the middle
  REQUIRE(hex_volume<double>(gather_corners(model.nodes.position, hex)) > 0);
  const auto fault = find_fault(model, RunOptions<double>{}, state);
  REQUIRE(fault);
  CHECK(fault->what.find("a hex has no volume left at its point 6 of 8: -") == 0);
  CHECK(fault->what.find(" mm3 at (1.") != std::string::npos);
  CHECK(fault->body == "brick");
  CHECK(fault->id == 7);
  // An energy error that comes of it is reported as what it comes from.
  state.initial_energy = 1;
  Energy<double> ledger;
  ledger.kinetic = 2;
  CHECK(find_energy_error(model, RunOptions<double>{}, state, ledger)->what == fault->what);
  // A run sees it after the first step: some steps later the point may have its volume back.
  model.nodes.position[hex[6]] += V::Constant(0.7e-3);
  const RunResult result = run(model, RunOptions<double>{.end_time = 20e-6}, [&](const auto &m, const auto &) {
    if (m.steps == 0) model.nodes.position[hex[6]] -= V::Constant(0.7e-3);
    return true;
  });
  REQUIRE(result.fault);
  CHECK(result.fault->what.find("a hex has no volume left at its point 6 of 8: -") == 0);
  CHECK(model.steps == 1);
}

TEST_CASE("a time step that falls too far stops the run", "[sim]") {
  auto model = two_bodies();
  Hex &hexes = std::get<1>(model.bodies);
  // Squeezed at 900 m/s from both ends, 0.15 of the sound speed: strains, and the step, change by about as much.
  for (Index n = hexes.nodes.begin; n < hexes.nodes.end; ++n)
    model.nodes.velocity[n][2] = -6e5 * (model.nodes.position[n][2] - 7.5e-3);
  const double first = stable_time_step(model);
  const RunResult result =
      run(model, RunOptions<double>{.end_time = 20e-6, .time_step_every = 1, .smallest_step_fraction = 0.9}, go_on);
  REQUIRE(result.fault);
  CHECK(result.fault->what.find("the stable time step fell to") == 0);
  CHECK(stable_time_step(model) < 0.9 * first);
  // Where it fell: hexes of the squeezed body.
  CHECK(result.fault->body == hexes.name);
  const auto step_alone = [&](Index e) { return stable_time_step_of_hex(hexes, model.nodes, e); };
  for (Index e = 0; e < static_cast<Index>(hexes.hexes.size()); ++e)
    CHECK(step_alone(result.fault->id) <= step_alone(e));
}

TEST_CASE("a time step that falls with one particle names it", "[sim]") {
  auto model = two_bodies();
  const RunOptions<double> options;
  RunState<double> state = begin_run(model, options);
  CHECK_FALSE(find_small_step(model, options, state));
  auto &particles = std::get<0>(model.bodies);
  // A step strains no particle by more than 0.05 (default): 0.05/dt at 0.01 of the first step.
  particles.points.velocity_gradient[5](2, 2) = particles.options.largest_strain / (0.01 * state.first_step);
  state.time_step = stable_time_step(model);
  CHECK(state.time_step == Approx(0.01 * state.first_step).epsilon(1e-12));
  const auto fault = find_small_step(model, options, state);
  REQUIRE(fault);
  CHECK(fault->body == particles.name);
  CHECK(fault->id == 5);
}

TEST_CASE("energy from nowhere stops the run", "[sim]") {
  auto model = two_bodies();
  int calls = 0;
  const auto push = [&](const auto &, const auto &) {
    if (++calls == 3)
      for (V &v : model.nodes.velocity) v *= 1.1;
    return true;
  };
  SECTION("beyond the limit") {
    const RunResult result = run(model, RunOptions<double>{.end_time = 9e-6, .largest_energy_error = 0.2}, push);
    REQUIRE(result.fault);
    CHECK(result.fault->what.find("the error of the energy balance is 21") == 0); // 1.1^2
    CHECK(result.fault->what.find(" J, from ") != std::string::npos);
    CHECK(calls == 4); // and a last look
  }
  SECTION("within the limit") {
    CHECK(run(model, RunOptions<double>{.end_time = 9e-6, .largest_energy_error = 0.22}, push).reason ==
          StopReason::end_time);
  }
}

TEST_CASE("a node that leaves the domain stops the run", "[sim]") {
  for (const bool in_hexes : {true, false}) {
    auto model = two_bodies();
    const Index n = std::get<1>(model.bodies).nodes.begin + 5, stray = in_hexes ? n : 9;
    int calls = 0;
    // The corner flies off through its own hex or away from it; the particle away from all others.
    const RunResult result =
        run(model, RunOptions<double>{.end_time = 20e-6, .observe_every = 1}, [&](const auto &, const auto &) {
          if (++calls == 1) model.nodes.position[stray] += V(-0.1, 0.2, 0.3);
          return true;
        });
    REQUIRE(result.fault);
    CHECK(calls == 2);
    if (in_hexes && result.fault->what.find("a hex") == 0) continue;
    CHECK(result.fault->what.find("is out of the domain, farther than ") == 0);
    CHECK(result.fault->what.find(" m/s") != std::string::npos);
    CHECK(result.fault->body == (in_hexes ? "hexes" : "particles"));
    CHECK(result.fault->id == (in_hexes ? 5 : 9));
  }
}

TEST_CASE("bodies that fly far in a long time stay in the domain", "[sim]") {
  auto model = two_bodies();
  set_velocity(model.nodes, {0, model.nodes.size()}, V(0, 0, 5e4));
  CHECK(run(model, RunOptions<double>{.end_time = 20e-6}, go_on).reason == StopReason::end_time);
  CHECK(model.nodes.position[0][2] > 0.9); // many times its own size
}

TEST_CASE("a particle that contact has lost inside a body stops the run", "[sim]") {
  const double soft = GENERATE(1e-9, 0.1);
  Nodes<double> nodes;
  const auto mesh = brick_at(5, 5, 5, V::Constant(5e-3), V(-2.5e-3, -2.5e-3, -5e-3));
  auto target = add_hex_body(nodes, mesh, fem_test::steel<double>(), "target");
  auto block =
      add_sph_body(nodes, lattice(2, 2, 2, spacing, V(-1e-3, -1e-3, 0.1e-3)), fem_test::steel<double>(), "block");
  set_velocity(nodes, block.nodes, V(0, 0, -200));
  std::vector<Index> slaves;
  for (Index n = block.nodes.begin; n < block.nodes.end; ++n) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), 0.5 * spacing), boundary_facets(mesh),
                              "block on target", ContactOptions<double>{.stiffness = soft});
  const double margin = contact.search_margin;
  auto model = model_of(std::move(nodes), std::move(target), std::move(block));
  model.contacts.push_back(std::move(contact));
  double last = -1;
  const RunResult result = run(model, RunOptions<double>{.end_time = 15e-6}, [&](const auto &m, const auto &) {
    last = m.time;
    return true;
  });
  if (soft > 1e-3) {
    CHECK(result.reason == StopReason::end_time);
    CHECK(model.contacts[0].state.lost == -1);
    return;
  }
  REQUIRE(result.reason == StopReason::fault);
  REQUIRE(result.fault);
  CHECK(result.fault->what.find("lies more than 1 mm behind the surface of the contact \"block on target\", at (") ==
        0);
  CHECK(result.fault->body == "block");
  CHECK(result.fault->id >= 0);
  CHECK(result.fault->id < 4); // the lower four come first
  CHECK(result.fault->time_us == Approx(model.time * 1e6));
  CHECK(last == model.time);
  const Index node = model.contacts[0].slaves[model.contacts[0].state.lost];
  CHECK(model.nodes.position[node][2] < -margin);
  CHECK(model.nodes.position[node][2] > -margin - 200 * 25 * 1.1e-7); // found within 20 steps and a few
}

TEST_CASE("what has been let go may lie anywhere", "[sim]") {
  Nodes<double> nodes;
  const auto mesh = brick_at(5, 5, 5, V::Constant(5e-3), V(-2.5e-3, -2.5e-3, -5e-3));
  auto target = add_hex_body(nodes, mesh, fem_test::steel<double>(), "target");
  auto block = add_sph_body(nodes, lattice(1, 1, 1, spacing, V(0, 0, 0)), fem_test::steel<double>(), "block");
  set_velocity(nodes, block.nodes, V(0, 0, -200));
  auto contact = make_contact(nodes, {block.nodes.begin}, {0.5 * spacing}, boundary_facets(mesh), "contact");
  contact.state.slave_mass[0] = 0;
  auto model = model_of(std::move(nodes), std::move(target), std::move(block));
  model.contacts.push_back(std::move(contact));
  CHECK(run(model, RunOptions<double>{.end_time = 15e-6}, go_on).reason == StopReason::end_time);
  CHECK(model.nodes.position.back()[2] < -2e-3);
}

TEST_CASE("a value that is not a number is not lost in the choice of the time step", "[sim]") {
  auto model = two_bodies();
  std::get<0>(model.bodies).points.velocity_gradient[7](1, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(stable_time_step(model)));
  const RunResult result = run(model, RunOptions<double>{.end_time = 1e-6}, go_on);
  REQUIRE(result.fault);
  CHECK(result.fault->body == "particles");
  CHECK(result.fault->id == 7);
  CHECK(model.steps == 0);
}
