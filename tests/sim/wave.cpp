#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/fem/facets.hpp"

#include <numbers>

using namespace sim_test;

namespace {

constexpr double spacing = 1e-3, push = 1.0;
constexpr int across = 3;

/// Node velocities along a bar and what happened to a pulse in it.
struct Pulse {
  double centre;  ///< m
  double highest; ///< m/s
};

Pulse pulse_between(const Nodes<double> &nodes, double from, double to) {
  double sum = 0, moment = 0, highest = 0;
  for (Index n = 0; n < nodes.size(); ++n) {
    const double z = nodes.position[n][2], v = nodes.velocity[n][2];
    if (z < from || z > to) continue;
    sum += nodes.mass[n] * v * v, moment += nodes.mass[n] * v * v * z, highest = std::max(highest, std::abs(v));
  }
  return {moment / sum, highest};
}

/// Lets a body carry a smooth compressive pulse v = push sin^2 of length `length` around `centre` that travels to +z:
/// the strain is -v/c.
template <class Body, class PointZ>
void give_pulse(Body &body, Nodes<double> &nodes, double centre, double length, PointZ &&point_z) {
  const auto v = [&](double z) {
    const double s = (z - centre) / length;
    return std::abs(s) < 0.5 ? push * std::pow(std::cos(std::numbers::pi * s), 2) : 0.0;
  };
  for (Index n = body.nodes.begin; n < body.nodes.end; ++n) nodes.velocity[n][2] = v(nodes.position[n][2]);
  for (Index i = 0; i < body.points.size(); ++i) {
    const double strain = -v(point_z(i)) / sound_speed(body.metal), shear = shear_modulus(body.metal.elasticity);
    body.points.density[i] = body.metal.density * (1 - strain);
    body.points.pressure[i] = -bulk_modulus(body.metal.elasticity) * strain;
    body.points.deviator[i] = deviator(Sym3<double>{0, 0, 2 * shear * strain, 0, 0, 0});
  }
}

void hold_laterally(Nodes<double> &nodes) {
  for (auto &held : nodes.held) held = held_x | held_y;
}

template <class M> void travel(M &model, double time) {
  const double dt = stable_time_step(model);
  while (model.time < time) step(model, dt);
}

constexpr double from = 60 * spacing, width = 36 * spacing;

Sph particle_bar(Nodes<double> &nodes, Index count, double z, SphOptions<double> options = {}) {
  return add_sph_body(nodes, lattice(across, across, count, spacing, V(0, 0, z)), fem_test::steel<double>(),
                      "particles", {}, options);
}

Hex hex_bar(Nodes<double> &nodes, Index count, double edge, double z) {
  return add_hex_body(nodes, brick_at(1, 1, count, V(across * spacing, across * spacing, count * edge), V(0, 0, z)),
                      fem_test::steel<double>(), "hexes");
}

} // namespace

// Default viscosities throughout. Strains of 2e-4: the bars are linear to that accuracy.

TEST_CASE("a wave in a laterally held bar of particles has the longitudinal sound speed", "[sim]") {
  Nodes<double> nodes;
  auto bar = particle_bar(nodes, 240, 0);
  give_pulse(bar, nodes, from, width, [&](Index i) { return nodes.position[i][2]; });
  hold_laterally(nodes);
  auto model = model_of(nodes, bar);
  const double c = sound_speed(bar.metal), start = pulse_between(model.nodes, 0, 1).centre;
  travel(model, 120 * spacing / c);
  const Pulse now = pulse_between(model.nodes, 0, 1);
  CHECK((now.centre - start) / model.time == Approx(c).epsilon(0.02));
}

TEST_CASE("a wave in a laterally held bar of hexes has the longitudinal sound speed", "[sim]") {
  Nodes<double> nodes;
  auto bar = hex_bar(nodes, 240, spacing, 0);
  give_pulse(bar, nodes, from, width, [&](Index i) { return (i + 0.5) * spacing; });
  hold_laterally(nodes);
  auto model = model_of(nodes, bar);
  const double c = sound_speed(bar.metal), start = pulse_between(model.nodes, 0, 1).centre;
  travel(model, 120 * spacing / c);
  const Pulse now = pulse_between(model.nodes, 0, 1);
  CHECK((now.centre - start) / model.time == Approx(c).epsilon(0.02));
}

TEST_CASE("a wave passes a tie of particles to hexes, either way", "[sim]") {
  // The hexes are 2.5 particle distances long, as at the edge of a plate's disc of particles.
  const bool particles_first = GENERATE(true, false);
  const double joint = 120 * spacing, edge = 2.5 * spacing;
  Nodes<double> nodes;
  auto particles = particle_bar(nodes, 120, particles_first ? 0 : joint);
  auto hexes = hex_bar(nodes, 48, edge, particles_first ? joint : 0);
  const auto particle_z = [&](Index i) { return nodes.position[particles.nodes.begin + i][2]; };
  if (particles_first)
    give_pulse(particles, nodes, from, width, particle_z);
  else
    give_pulse(hexes, nodes, from, width, [&](Index i) { return (i + 0.5) * edge; });
  hold_laterally(nodes);
  const auto mesh =
      brick_at(1, 1, 48, V(across * spacing, across * spacing, 120 * spacing), V(0, 0, particles_first ? joint : 0));
  const auto facets = shifted(
      facets_where(boundary_facets(mesh), mesh.positions, [&](const V &p) { return std::abs(p[2] - joint) < 1e-9; }),
      hexes.nodes.begin);
  REQUIRE(facets.size() == 1);
  const auto tie = make_tie(nodes, particles.nodes, facets, hexes.hexes, spacing);
  REQUIRE(tie.nodes.size() == across * across);
  auto model = model_of(nodes, particles, hexes);
  model.ties.push_back(tie);

  const double c = sound_speed(particles.metal), start = pulse_between(model.nodes, 0, 1).centre;
  const double before = total(energy(model));
  travel(model, 120 * spacing / c);
  const Pulse passed = pulse_between(model.nodes, joint, 1), back = pulse_between(model.nodes, 0, joint - 20 * spacing);
  CHECK((passed.centre - start) / model.time == Approx(c).epsilon(0.02));
  CHECK(back.highest < 0.05 * push);
  CHECK(passed.highest > 0.9 * push);
  CHECK(total(energy(model)) == Approx(before).epsilon(0.005));
}
