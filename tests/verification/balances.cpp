// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"
#include "sim/balance.hpp"
#include "sim/pulse.hpp"
#include "sim/small_shot.hpp"
#include "sim/strike.hpp"

namespace verification {

namespace {

using namespace sim_test;

constexpr double length = 60e-3, speed = 1; ///< m, m/s

/// What became of a bar that struck an equal one at rest.
struct Exchange {
  double struck, striker; ///< mean velocities over the striker's at first
  double momentum_error, energy_error;
  double contact; ///< s, from the first to the last touch
};

/// Two bars of hexes with edges of `edge` (m), held laterally; `make(nodes)` adds the upper one, of the same metal and
/// section, which flies down. Its nodes are spheres with the radius `offset` (m).
template <class Make> Exchange strike_in_line(double edge, double offset, Make &&make) {
  Nodes<double> nodes;
  const Index count = static_cast<Index>(std::lround(length / edge));
  const double width = particles_across * edge;
  auto lower = hex_bar(nodes, count, edge, width, -length);
  const auto mesh = brick_at(1, 1, count, V(width, width, length), V(0, 0, -length));
  const auto top = shifted(
      facets_where(boundary_facets(mesh), mesh.positions, [&](const V &p) { return p[2] > -1e-9; }), lower.nodes.begin);
  auto upper = make(nodes, count, width);
  set_velocity(nodes, upper.nodes, V(0, 0, -speed));
  hold_laterally(nodes);
  std::vector<Index> slaves;
  for (Index n = upper.nodes.begin; n < upper.nodes.end; ++n)
    if (nodes.position[n][2] < edge) slaves.push_back(n);
  auto contact = make_contact(nodes, slaves, std::vector<double>(slaves.size(), offset), top, "contact");
  const NodeRange flying = upper.nodes, struck = lower.nodes;
  auto model = model_of(std::move(nodes), std::move(lower), std::move(upper));
  model.contacts.push_back(std::move(contact));

  const double e = total(energy(model)), p = momentum(model)[2], dt = stable_time_step(model);
  const double crossing = length / sound_speed(fem_test::steel<double>());
  double first = -1, last = 0;
  Exchange x{};
  while (model.time < 3 * crossing) {
    step(model, dt);
    x.energy_error = std::max(x.energy_error, std::abs(total(energy(model)) / e - 1));
    for (const auto &f : model.contacts.front().state.near.forces)
      if (f.facet >= 0) first = first < 0 ? model.time : first, last = model.time;
  }
  x.struck = -mean_velocity(model.nodes, struck)[2] / speed;
  x.striker = -mean_velocity(model.nodes, flying)[2] / speed;
  x.momentum_error = momentum(model)[2] / p - 1;
  x.contact = last - first;
  return x;
}

Exchange hexes_on_hexes(double edge) {
  return strike_in_line(
      edge, 0, [&](Nodes<double> &nodes, Index count, double width) { return hex_bar(nodes, count, edge, width, 0); });
}

Exchange particles_on_hexes(double edge) {
  return strike_in_line(edge, 0.5 * edge,
                        [&](Nodes<double> &nodes, Index count, double) { return particle_bar(nodes, count, edge, 0); });
}

template <class Run> void add_exchange(Rung &rung, const std::string &what, double round_off, Run &&run) {
  std::vector<double> errors;
  const double crossing = length / sound_speed(fem_test::steel<double>());
  for (const double edge : {2e-3, 1e-3, 0.5e-3}) {
    const Exchange x = run(edge);
    const std::string name = what + ", " + number(edge * 1e3) + " mm: ";
    compare(rung, name + "velocity of the struck bar", 1, x.struck, 0.03 * std::sqrt(edge / 1e-3));
    compare(rung, name + "time of contact, µs", 2e6 * crossing, 1e6 * x.contact, 0.1 * edge / 1e-3);
    errors.push_back(x.struck - 1);
    if (edge > 0.5e-3) continue;
    vanishes(rung, name + "momentum gained", x.momentum_error, round_off);
    vanishes(rung, name + "energy gained", x.energy_error, 5e-3);
  }
}

void add_strike(Rung &rung, const std::string &what, double round_off, const Strike &strike) {
  vanishes(rung, what + ": momentum gained", strike.momentum_error, round_off);
  vanishes(rung, what + ": energy error", strike.energy_error, 0.01);
  lies_between(rung, what + ": restitution", strike.restitution, 0.3, 1);
}

void add_shot(Rung &rung, const std::string &what, const PerforationCase<double> &c) {
  auto model = small_shot(c);
  const Balance balance = follow(model, 25e-6);
  vanishes(rung, what + ": energy error", balance.energy_error, 1e-3);
  vanishes(rung, what + ": momentum gained beyond the supports'", balance.momentum_error, round_off_of_momentum);
}

} // namespace

Rung balances() {
  Rung rung;
  rung.name = "balances";
  add_exchange(rung, "bars of hexes", 1e-11, hexes_on_hexes);
  add_exchange(rung, "particles on hexes", round_off_of_momentum, particles_on_hexes);
  add_strike(rung, "block of hexes on a block", 1e-13, strike_with_hexes());
  add_strike(rung, "block of particles on a block", round_off_of_momentum, strike_with_particles());
  for (const Nose nose : paper_noses) {
    auto c = small_case(nose, Extent::quarter);
    add_shot(rung, "shot, " + std::string(name(nose)), c);
  }
  auto rigid = small_case(Nose::blunt, Extent::quarter);
  rigid.rigid_projectile = true;
  add_shot(rung, "shot, blunt, rigid", rigid);
  return rung;
}

} // namespace verification
