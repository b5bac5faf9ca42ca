// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "sim/blocks.hpp"

#include "ogive/material/library.hpp"
#include "ogive/perforation/setup.hpp"

using namespace sim_test;

namespace {

/// Largest difference of two fields over the largest value.
double difference(const std::vector<V> &a, const std::vector<V> &b) {
  double apart = 0, size = 0;
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    apart = std::max(apart, (a[k] - b[k]).norm());
    size = std::max(size, a[k].norm());
  }
  REQUIRE(size > 0);
  return apart / size;
}

/// Stretches and turns the nodes: a motion that neither kernel sees exactly.
void set_in_motion(Nodes<double> &nodes) {
  for (Index n = 0; n < nodes.size(); ++n) {
    const V &x = nodes.position[n];
    nodes.velocity[n] = 1e6 * V(x[1] * x[2], x[0] * x[0] - x[2] * x[1], x[0] * x[1]);
  }
}

/// Forces after a step in which the metal yields, N.
template <class Body> std::vector<V> forces_of(Body body, Nodes<double> nodes) {
  set_in_motion(nodes);
  PhaseTimes times;
  Lap lap(times);
  for (int step = 0; step < 2; ++step) {
    for (V &f : nodes.force) f.setZero();
    update_body(body, nodes, 1e-6, lap);
  }
  CHECK(*std::max_element(body.points.plastic_strain.begin(), body.points.plastic_strain.end()) > 0);
  return nodes.force;
}

template <class Kernel, class Form, class Law>
std::vector<V> forces_of_particles(const Metal<double, Law> &metal, Kernel kernel, Form form) {
  Nodes<double> nodes;
  auto body = add_sph_body(nodes, lattice(5, 4, 6, 1e-3), metal, "block", {}, SphOptions<double>{}, kernel, form);
  return forces_of(std::move(body), std::move(nodes));
}

template <class Rule, class Law> std::vector<V> forces_of_hexes(const Metal<double, Law> &metal, Rule rule) {
  Nodes<double> nodes;
  const auto mesh = brick_at(4, 3, 5, V(4e-3, 3e-3, 5e-3), V::Zero());
  auto body = add_hex_body(nodes, mesh, metal, "brick", HexOptions<double>{}, rule);
  return forces_of(std::move(body), std::move(nodes));
}

} // namespace

TEST_CASE("kernel, form and law chosen at run time give the forces of those chosen by the compiler", "[sim]") {
  const auto metal = library::weldox_460e_jc<double>();
  const auto any = with_law<AnyFlowLaw<double>>(metal);
  const auto chosen = forces_of_particles(any, AnyKernel(WendlandC2{}), AnyForm(StandardForm{}));
  // Single precision: the compiler may fuse other products and sums.
  CHECK(difference(forces_of_particles(metal, WendlandC2{}, StandardForm{}), chosen) < 3e-6);
  // Every choice counts.
  CHECK(difference(forces_of_particles(any, AnyKernel(CubicSpline{}), AnyForm(StandardForm{})), chosen) > 1e-3);
  CHECK(difference(forces_of_particles(any, AnyKernel(WendlandC2{}), AnyForm(RenormalisedForm{})), chosen) > 1e-3);
  const auto modified = with_law<AnyFlowLaw<double>>(library::weldox_460e_mjc<double>());
  CHECK(difference(forces_of_particles(modified, AnyKernel(WendlandC2{}), AnyForm(StandardForm{})), chosen) > 1e-3);
}

TEST_CASE("a rule of hexes chosen at run time gives the forces of the one chosen by the compiler", "[sim]") {
  const auto metal = fem_test::steel<double>(100e6);
  const auto one = forces_of_hexes(metal, AnyRule(OnePoint{})),
             several = forces_of_hexes(metal, AnyRule(SelectiveReduced{}));
  CHECK(difference(forces_of_hexes(metal, OnePoint{}), one) < 1e-12);
  CHECK(difference(forces_of_hexes(metal, SelectiveReduced{}), several) < 1e-12);
  CHECK(difference(one, several) > 1e-3);
}
