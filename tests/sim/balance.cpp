#include "catch.hpp"
#include "sim/small_shot.hpp"

#include "ogive/sim/step.hpp"

using namespace sim_test;

TEST_CASE("a shot keeps energy and gives its momentum to the supports", "[sim]") {
  const bool rigid = GENERATE(false, true);
  const Nose nose = GENERATE(Nose::blunt, Nose::conical);
  auto c = small_case(nose, Extent::quarter);
  c.rigid_projectile = rigid;
  auto model = small_shot(c);
  const double e = total(energy(model));
  const double expected = 0.5 * whole_mass(projectile(model).point_mass, model.symmetry) * 300 * 300;
  CHECK(e == Approx(expected).epsilon(0.011)); // mass scaling adds at most 1 %
  const Vec3<double> p = momentum(model);
  double worst = 0;
  while (model.time < 25e-6) {
    if (model.steps % 10 == 0) worst = std::max(worst, std::abs(total(energy(model)) / e - 1));
    step(model, stable_time_step(model));
  }
  const Energy<double> now = energy(model);
  const Vec3<double> given = model.symmetry.copies() * model.support_impulse;
  CHECK(now.plastic > 0.02 * e); // the plate has yielded, near the tip at least
  CHECK(now.friction > 0);
  // Leapfrog and trapezoidal work sums: what is left is of second order in the step. 0.02 % was measured.
  CHECK(worst < 0.005);
  // Forces add up to zero: round-off of about a thousand steps.
  CHECK(std::abs(given[2]) > 1e-6 * std::abs(p[2]));
  CHECK(std::abs(momentum(model)[2] - p[2] - given[2]) < 1e-10 * std::abs(p[2]));
}
