// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "contact/stack.hpp"

#include <numbers>

using namespace contact_test;
using fem_test::Noise;

namespace {

constexpr double spacing = Stack::spacing;

double total_force(const Stack &stack) {
  double sum = 0;
  for (const V &f : stack.nodes.force) sum += f.norm();
  return sum;
}

} // namespace

TEST_CASE("plates that just touch feel nothing, to the last bit", "[contact]") {
  for (const V &shift : {V(0, 0, 0), V(0.5e-3, 0.5e-3, 0), V(0.3e-3, 0, 0)}) {
    Stack stack(8, 4, shift);
    stack.press();
    CHECK(total_force(stack) == 0);
    stack.move_upper(V(0, 0, 1e-6));
    stack.press();
    CHECK(total_force(stack) == 0);
  }
}

TEST_CASE("plates with a gap feel nothing until they meet", "[contact]") {
  Stack stack(8, 4, V(0.2e-3, 0, 0), 10e-3);
  stack.press();
  CHECK(total_force(stack) == 0);
  stack.move_upper(V(0, 0, -9.999e-3));
  stack.press();
  CHECK(total_force(stack) == 0);
  stack.move_upper(V(0, 0, -0.05e-3));
  stack.press();
  CHECK(stack.force_on(stack.upper)[2] > 0);
}

TEST_CASE("pressed plates push each other with equal and opposite forces and turn nothing", "[contact]") {
  Stack stack(8, 4, V(0.37e-3, 0.1e-3, 0));
  stack.move_upper(V(0, 0, -0.2 * spacing));
  Noise noise;
  for (V &p : stack.nodes.position) p += 0.1 * spacing * noise.vector();
  stack.press();
  V sum = V::Zero(), moment = V::Zero();
  for (Index n = 0; n < stack.nodes.size(); ++n) {
    sum += stack.nodes.force[n];
    moment += cross<double>(stack.nodes.position[n], stack.nodes.force[n]);
  }
  const double scale = total_force(stack);
  CHECK(scale > 0);
  CHECK(sum.norm() < 1e-14 * scale);
  CHECK(moment.norm() < 1e-14 * scale * 8 * spacing);
  // Every pair on its own: both sides compute it from the same numbers.
  Stack pair(1, 1);
  pair.contact.threshold = {0, 0};
  pair.move_upper(V(0.31e-3, -0.17e-3, -0.4e-3));
  pair.press();
  CHECK(pair.nodes.force[0].norm() > 0);
  CHECK(pair.nodes.force[0] == -pair.nodes.force[1]);
}

TEST_CASE("the force is the slope of the energy", "[contact]") {
  Stack stack(6, 3, V(0.2e-3, 0.4e-3, 0));
  stack.move_upper(V(0, 0, -0.25 * spacing));
  Noise noise;
  for (V &p : stack.nodes.position) p += 0.1 * spacing * noise.vector();
  stack.press();
  const auto forces = stack.nodes.force;
  int pressed = 0;
  for (Index n = 0; n < stack.nodes.size(); n += 7)
    for (int d = 0; d < 3; ++d) {
      const double h = 1e-7 * spacing, x = stack.nodes.position[n][d];
      const auto energy_at = [&](double at) {
        stack.nodes.position[n][d] = at;
        stack.press();
        return stack.potential();
      };
      const double slope = (energy_at(x + h) - energy_at(x - h)) / (2 * h);
      stack.nodes.position[n][d] = x;
      CHECK(forces[n][d] == Approx(-slope).margin(1e-3));
      pressed += std::abs(forces[n][d]) > 1;
    }
  CHECK(pressed > 20);
}

TEST_CASE("the pressure grows with the depth as asked for, and hardly shows the lattices", "[contact]") {
  // Of the middle of the plates, so that edges do not count.
  const auto pressure_at = [](const V &slide, double depth) {
    Stack stack(14, 4);
    stack.move_upper(slide - V(0, 0, depth));
    stack.press();
    double sum = 0;
    int columns = 0;
    for (Index n = stack.lower.begin; n < stack.lower.end; ++n) {
      const V &p = stack.nodes.position[n];
      if (std::abs(p[0] - 7e-3) > 3e-3 || std::abs(p[1] - 7e-3) > 3e-3) continue;
      sum -= stack.nodes.force[n][2];
      ++columns;
    }
    return sum / (0.25 * columns * spacing * spacing);
  };
  const double depth = 0.03 * spacing;
  CHECK(pressure_at(V::Zero(), 0.002 * spacing) == Approx(Stack::modulus * 0.002).epsilon(0.03));
  CHECK(pressure_at(V::Zero(), depth) == Approx(Stack::modulus * 0.03).epsilon(0.1));
  // Stiffer where it is deep: the second planes of particles come in.
  CHECK(pressure_at(V::Zero(), 0.2 * spacing) > Stack::modulus * 0.2);
  CHECK(pressure_at(V::Zero(), 0.2 * spacing) < 1.5 * Stack::modulus * 0.2);
  // A plate that slid by half a particle distance either way rises by less than 0.5 % of a particle distance.
  const double rise = 0.005 * spacing;
  for (const V &slide : {V(0.5e-3, 0, 0), V(0.5e-3, 0.5e-3, 0), V(0.25e-3, 0.1e-3, 0)}) {
    CHECK(pressure_at(slide, depth) < pressure_at(V::Zero(), depth + rise));
    CHECK(pressure_at(slide, depth) > pressure_at(V::Zero(), depth - rise));
  }
}

TEST_CASE("a quarter of two plates feels what the whole ones feel", "[contact]") {
  const double half = 4 * spacing;
  Stack whole(8, 3, V::Zero(), 0, {}, -half), quarter(4, 3, V::Zero(), 0, {true, true});
  for (Stack *stack : {&whole, &quarter}) {
    for (V &p : stack->nodes.position) {
      p[2] += 0.05 * p[2] * std::cos(300 * p[0]) * std::cos(200 * p[1]) - (p[2] > 0 ? 0.1 * spacing : 0);
      // Some are pushed across the planes.
      if (std::abs(p[0]) < spacing) p[0] *= -0.1;
    }
    stack->press();
  }
  int compared = 0;
  for (Index i = 0; i < quarter.nodes.size(); ++i)
    for (Index n = 0; n < whole.nodes.size(); ++n)
      if ((whole.nodes.position[n] - quarter.nodes.position[i]).norm() < 1e-9) {
        CHECK((whole.nodes.force[n] - quarter.nodes.force[i]).norm() <= 1e-9 * whole.nodes.force[n].norm() + 1e-9);
        CHECK(whole.contact.fullness[n] == Approx(quarter.contact.fullness[i]).margin(1e-12));
        compared += whole.nodes.force[n].norm() > 1;
      }
  CHECK(compared > 15);
}

TEST_CASE("the search of particles finds all that touch after any move", "[contact]") {
  Stack kept(6, 3);
  const Stack start = kept;
  Noise noise;
  int touching = 0;
  for (int step = 0; step < 100; ++step) {
    for (V &p : kept.nodes.position) p += 0.1 * spacing * noise.vector();
    kept.move_upper(V(0, 0, -0.01 * spacing));
    if (step % 25 == 10) kept.move_upper(V(50 * spacing, 0, 0));
    if (step % 25 == 12) kept.nodes.position = start.nodes.position;
    kept.press();
    Stack fresh = kept;
    fresh.contact.searched_at.clear();
    fresh.press();
    for (Index n = 0; n < kept.nodes.size(); ++n) {
      REQUIRE((kept.nodes.force[n] - fresh.nodes.force[n]).norm() <= 1e-12 * fresh.nodes.force[n].norm());
      touching += fresh.nodes.force[n].norm() > 0;
    }
  }
  CHECK(touching > 500);
}

TEST_CASE("the ledger gets back what a press took", "[contact]") {
  Stack stack;
  const double dt = 1e-8;
  for (Index n = stack.upper.begin; n < stack.upper.end; ++n) stack.nodes.velocity[n] = V(0, 0, -100);
  stack.press(0);
  double most = 0;
  for (int step = 0; step < 400; ++step) {
    if (step == 200)
      for (Index n = stack.upper.begin; n < stack.upper.end; ++n) stack.nodes.velocity[n] = V(0, 0, 100);
    stack.move_upper(dt * stack.nodes.velocity[stack.upper.begin]);
    stack.press(dt);
    CHECK(normal_energy(stack.contact) == Approx(stack.potential()).margin(2e-3));
    most = std::max(most, normal_energy(stack.contact));
  }
  CHECK(most > 0.3);
  CHECK(std::abs(normal_energy(stack.contact)) < 1e-3 * most);
}

TEST_CASE("a particle deep within another plate counts as lost", "[contact]") {
  Stack stack;
  const Index bottom = stack.upper.begin + 8 * 3 + 3;
  stack.nodes.position[bottom][2] = 0.1 * spacing;
  stack.press();
  CHECK(stack.contact.lost == -1);
  stack.nodes.position[bottom][2] = -1.5 * spacing;
  stack.press();
  CHECK(stack.contact.lost >= 0);
}

TEST_CASE("wrong contacts of particles are refused", "[contact]") {
  const Stack stack;
  const std::vector<double> volumes(stack.upper.size(), 1e-9);
  const ContactBody<double> upper{stack.upper, volumes, spacing, 0}, lower{stack.lower, volumes, spacing, 0};
  const auto make = [&](const std::vector<ContactBody<double>> &bodies, double modulus = 1e11) {
    return make_particle_contact(stack.nodes, bodies, modulus, "p");
  };
  CHECK_NOTHROW(make({upper, lower}));
  CHECK_THROWS_WITH(make({upper}), "p bodies = 1: there must be 2 to 8");
  CHECK_THROWS_WITH(make({upper, lower}, 0), "p modulus (Pa) = 0: must be positive");
  CHECK_THROWS_WITH(make({lower, upper}), Catch::Contains("must follow the last one of the body before"));
  CHECK_THROWS_WITH(make({upper, {stack.lower, {1e-9}, spacing, 0}}), Catch::Contains("p volumes = 1"));
  CHECK_THROWS_WITH(make({upper, {stack.lower, volumes, spacing, -9e-3}}), Catch::Contains("must touch"));
}
