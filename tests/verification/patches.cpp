// SPDX-License-Identifier: BSD-3-Clause
#include "contact/joint.hpp"
#include "fem/brick.hpp"
#include "record.hpp"
#include "sph/block.hpp"

#include "ogive/sim/step.hpp"

namespace verification {

namespace {

using namespace ogive;
using V = Vec3<double>;
using M = Mat3<double>;
using fem_test::distorted_brick, fem_test::solid, fem_test::steel;

const Sym3<double> some_stress{300e6, -200e6, 100e6, 150e6, -50e6, 80e6}; ///< Pa

template <class Body> void set_stress(Body &body, const Sym3<double> &sigma) {
  for (Index i = 0; i < body.points.size(); ++i) {
    body.points.deviator[i] = deviator(sigma);
    body.points.pressure[i] = -trace(sigma) / 3;
  }
}

/// Largest force of a uniform stress on the inner nodes of distorted hexes, over the largest on its outer ones.
template <class Rule> double unbalanced() {
  auto s = solid<Rule>(distorted_brick(4, 0.01, 0.2));
  velocity_gradient(s.body, s.nodes);
  set_stress(s.body, some_stress);
  add_internal_force(s.body, s.nodes, 0.0);
  double inner = 0, outer = 0;
  for (Index n = 0; n < s.nodes.size(); ++n) {
    const Index i = n % 5, j = n / 5 % 5, k = n / 25;
    const bool inside = i % 4 != 0 && j % 4 != 0 && k % 4 != 0;
    (inside ? inner : outer) = std::max(inside ? inner : outer, s.nodes.force[n].norm());
  }
  return inner / outer;
}

/// Largest error of the gradient of a linear field on either side of a tie, over the gradient.
struct TieError {
  double particles = 0, hexes = 0;
};

TieError across_tie() {
  contact_test::Joint j;
  const auto tie = j.tie();
  const M L = sph_test::some_gradient();
  for (Index n = 0; n < j.nodes.size(); ++n)
    if (j.nodes.mass[n] > 0) j.nodes.velocity[n] = L * j.nodes.position[n] + V(1, -2, 3);
  move_slaves(tie, j.nodes);
  prepare(j.particles, j.nodes);
  velocity_gradient(j.particles);
  velocity_gradient(j.hexes, j.nodes);
  TieError error;
  for (const M &found : j.particles.points.velocity_gradient)
    error.particles = std::max(error.particles, (found - L).norm() / L.norm());
  for (const M &found : j.hexes.points.velocity_gradient)
    error.hexes = std::max(error.hexes, (found - L).norm() / L.norm());
  return error;
}

/// Relative change of force, moment and mass when a tie hands them over.
struct HandedOver {
  double mass, force, moment;
};

HandedOver handed_over() {
  contact_test::Joint j;
  const auto sums = [&] {
    std::pair<V, V> s(V::Zero(), V::Zero());
    for (Index n = 0; n < j.nodes.size(); ++n) {
      s.first += j.nodes.force[n];
      s.second += cross<double>(j.nodes.position[n], j.nodes.force[n]);
    }
    return s;
  };
  const auto mass = [&] {
    double m = 0;
    for (const double one : j.nodes.mass) m += one;
    return m;
  };
  const double before = mass();
  const auto tie = j.tie();
  const double after = mass();
  fem_test::Noise noise;
  double scale = 0;
  for (V &f : j.nodes.force) f = noise.vector(), scale += f.norm();
  const auto old = sums();
  hand_over_forces(tie, j.nodes);
  const auto now = sums();
  return {after / before - 1, (now.first - old.first).norm() / scale,
          (now.second - old.second).norm() / (scale * 6e-3)};
}

/// Largest stress over Young's modulus in a body whose nodes are carried through a full turn in steps of 0.01 rad.
template <class Body> double stress_after_turn(Body &body, Nodes<double> &nodes) {
  const std::vector<V> start = nodes.position;
  const double dt = 5e-8;
  PhaseTimes times;
  Lap lap(times);
  for (int i = 1; i <= 629; ++i) {
    const M R = fem_test::rotation(V(1, 2, -1), 0.01 * i);
    for (Index n = 0; n < nodes.size(); ++n) {
      const V x = R * start[n];
      nodes.velocity[n] = (x - nodes.position[n]) / dt;
      nodes.position[n] = x;
    }
    update_body(body, nodes, dt, lap);
  }
  double largest = 0;
  for (Index i = 0; i < body.points.size(); ++i)
    largest = std::max({largest, von_mises(body.points.deviator[i]), std::abs(body.points.pressure[i])});
  return largest / body.metal.elasticity.young;
}

template <class Rule> double hexes_after_turn() {
  auto s = solid<Rule>(distorted_brick(3, 0.01, 0.2));
  return stress_after_turn(s.body, s.nodes);
}

/// Change of the von Mises stress and turn of the stress of one point that turns rigidly by 100 rad in steps of 0.1.
double stressed_point_after_turns() {
  const auto metal = steel<double>();
  auto p = initial_point(metal);
  M L = M::Zero();
  L.diagonal() << 1e3, -300, -300;
  const double dt = 1e-7;
  p = updated(metal, p, L, 10 * dt);
  const auto start = p;
  const M back = fem_test::rotation(V(0, 0, 1), -0.1);
  for (int i = 0; i < 1000; ++i) p = updated(metal, p, M((M::Identity() - back) / dt), dt);
  const auto turned = rotated(start.deviator, fem_test::rotation(V(0, 0, 1), 100));
  return von_mises(p.deviator - turned) / von_mises(start.deviator);
}

/// Largest force of a uniform stress on particles farther than two supports from any surface, each displaced by up to
/// `jitter` distances, over stress times squared distance.
double particle_force(double jitter) {
  const int n = 14;
  const double spacing = 1e-3;
  Nodes<double> nodes;
  auto body = add_sph_body(nodes, sph_test::block(n, n, n, jitter, spacing), steel<double>(), "block");
  prepare(body, nodes);
  velocity_gradient(body);
  set_stress(body, some_stress);
  add_internal_force(body, nodes, 0.0);
  const double scale = full(some_stress).norm() * spacing * spacing, far = 2 * kernel_support * 1.2 * spacing;
  double largest = 0;
  for (Index i = 0; i < nodes.size(); ++i)
    if (const V &x = nodes.position[i]; std::min(x.minCoeff(), n * spacing - x.maxCoeff()) > far)
      largest = std::max(largest, nodes.force[i].norm() / scale);
  return largest;
}

} // namespace

Rung patches() {
  Rung rung;
  rung.name = "patches";
  vanishes(rung, "uniform stress, distorted hexes, one point: force inside", unbalanced<OnePoint>(), 1e-13);
  vanishes(rung, "uniform stress, distorted hexes, 2×2×2 points: force inside", unbalanced<SelectiveReduced>(), 1e-13);
  vanishes(rung, "uniform stress, particles in a cubic lattice: force inside", particle_force(0), round_off_of_pairs);
  vanishes(rung, "uniform stress, particles at random: force inside, stress × distance²", particle_force(0.1), 0.5);
  const TieError tie = across_tie();
  vanishes(rung, "linear field across a tie: gradient of particles", tie.particles, round_off_of_pairs);
  vanishes(rung, "linear field across a tie: gradient of hexes", tie.hexes, 1e-11);
  const HandedOver given = handed_over();
  vanishes(rung, "tie: mass gained", given.mass, 1e-13);
  vanishes(rung, "tie: force gained", given.force, 1e-13);
  vanishes(rung, "tie: moment gained", given.moment, 1e-13);
  Nodes<double> nodes;
  // Displaced by so little that corners, too, are corrected in full.
  auto block = add_sph_body(nodes, sph_test::block(5, 4, 4, 0.05), steel<double>(), "block");
  vanishes(rung, "a turn in 629 steps, particles: stress/E", stress_after_turn(block, nodes), 1e-6);
  vanishes(rung, "a turn in 629 steps, hexes, one point: stress/E", hexes_after_turn<OnePoint>(), 1e-9);
  vanishes(rung, "a turn in 629 steps, hexes, 2×2×2 points: stress/E", hexes_after_turn<SelectiveReduced>(), 1e-9);
  vanishes(rung, "100 rad in 1000 steps, a stressed point: change of stress", stressed_point_after_turns(), 1e-9);
  return rung;
}

} // namespace verification
