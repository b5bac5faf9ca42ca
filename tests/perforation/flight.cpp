// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/perforation/flight.hpp"

using namespace ogive;

namespace {

Flight<double> flight_of(Nose nose) {
  PerforationCase<double> c;
  c.projectile = paper_projectile<double>(nose);
  c.thickness = 12e-3;
  c.initial_velocity = 300;
  return start_flight(c);
}

const auto loose = [] { return Way<double>{true, false, 0}; };
const auto hanging = [] { return Way<double>{false, true, 0}; };

/// Samples each microsecond from `time` (us) of a projectile of 80 mm with a nose of 30 mm whose tail is at `tail` (m).
template <class Velocity, class Loose>
void fly(Flight<double> &flight, int from, int to, Velocity &&velocity, Loose &&is_loose, double tail = -60e-3) {
  for (int t = from; t < to && flight.state == FlightState::in_progress; ++t)
    record(flight, {t * 1e-6, velocity(t), tail + 80e-3, tail + 50e-3, tail, velocity(t)}, is_loose);
}

} // namespace

TEST_CASE("a blunt shot is perforated once its velocity is steady and the plug loose", "[perforation]") {
  // 1 mm at 200 m/s takes 5 us: 10 us is the least interval.
  CHECK(steady_interval(200.0, 20e-3) == Approx(10e-6));
  CHECK(steady_interval(50.0, 20e-3) == Approx(20e-6));
  CHECK(steady_interval(1.0, 20e-3) == Approx(60e-6));
  CHECK(steady_interval(-5.0, 20e-3) == Approx(60e-6));
  CHECK(steady_interval(50.0, 2e-3) == Approx(2e-6)); // a copy ten times smaller

  const auto slowing = [](int t) { return t < 50 ? 300.0 - 2 * t : 200.0; };
  auto flight = flight_of(Nose::blunt);
  fly(flight, 0, 50, slowing, loose);
  CHECK(flight.state == FlightState::in_progress);
  CHECK(residual_velocity(flight) == 0);
  fly(flight, 50, 200, slowing, loose);
  CHECK(flight.state == FlightState::perforated);
  CHECK(residual_velocity(flight) == 200);
  CHECK(flight.samples.back().time == Approx(52e-6)); // 2 us after nothing touches the projectile any more
  CHECK_FALSE(flight.velocity_at_tail);
  // Who goes on to watch the plate changes no conclusion, and does not look for the plug again.
  record(flight, {61e-6, -100, 0, 0, 0, -100}, [] {
    FAIL("concluded already");
    return Way<double>{};
  });
  CHECK(flight.state == FlightState::perforated);

  // A slower plug before it will be hit again: 1 m/s is more than 0.1 % of 300 m/s.
  auto early = flight_of(Nose::blunt);
  fly(early, 0, 200, slowing, [] { return Way<double>{true, false, 0, 1}; });
  CHECK(early.state == FlightState::in_progress);
  fly(early, 200, 202, slowing, [] { return Way<double>{true, false, 0, 0.1}; });
  CHECK(early.state == FlightState::perforated);

  auto stuck = flight_of(Nose::blunt);
  fly(stuck, 0, 200, slowing, hanging);
  CHECK(stuck.state == FlightState::in_progress);
  fly(stuck, 200, 202, slowing, loose);
  CHECK(stuck.state == FlightState::perforated);
}

TEST_CASE("a drift above a thousandth of the initial velocity is not steady", "[perforation]") {
  auto flight = flight_of(Nose::blunt); // 0.1 m/s in a us: 1 m/s in the interval of 10 us, against 0.3 m/s
  fly(
      flight, 0, 300, [](int t) { return 200 - 0.1 * t; }, loose);
  CHECK(flight.state == FlightState::in_progress);
  auto slower = flight_of(Nose::blunt); // 0.02 m/s in a us: 0.2 m/s
  fly(
      slower, 0, 300, [](int t) { return 200 - 0.02 * t; }, loose);
  CHECK(slower.state == FlightState::perforated);
}

TEST_CASE("a projectile that flies back has been stopped", "[perforation]") {
  for (const Nose nose : {Nose::blunt, Nose::conical}) {
    auto flight = flight_of(nose);
    fly(
        flight, 0, 101, [](int t) { return 100.0 - t; }, loose); // down to rest
    CHECK(flight.state == FlightState::in_progress);
    fly(
        flight, 101, 200, [](int t) { return -0.1 * (t - 101); }, loose);
    CHECK(flight.state == FlightState::stopped);
    CHECK(flight.samples.back().velocity < -0.6); // 0.2 % of 300 m/s
    CHECK(flight.samples.back().velocity > -0.75);
    CHECK(residual_velocity(flight) == 0);
  }
}

TEST_CASE("a projectile at rest in the plate has been stopped, one behind it is undecided", "[perforation]") {
  const auto creeping = [](int) { return 1.0; }; // below 0.5 % of 300 m/s
  for (const Nose nose : {Nose::blunt, Nose::conical}) {
    auto stuck = flight_of(nose);
    fly(stuck, 0, 400, creeping, hanging);
    CHECK(stuck.state == FlightState::stopped);
    CHECK(stuck.samples.back().time == Approx(60e-6).margin(1.1e-6)); // after the longest interval
  }
  // Jammed with its nose through the plate, nothing before it.
  for (const Nose nose : {Nose::blunt, Nose::ogival}) {
    auto jammed = flight_of(nose);
    fly(jammed, 0, 400, creeping, [] { return Way<double>{true, true, 0}; });
    CHECK(jammed.state == FlightState::stopped);
  }
  auto free = flight_of(Nose::blunt);
  fly(free, 0, 400, creeping, loose);
  CHECK(free.state == FlightState::in_progress);
  // Out, however slowly.
  for (const Nose nose : {Nose::blunt, Nose::conical}) {
    auto out = flight_of(nose);
    fly(out, 0, 400, creeping, loose, 13e-3);
    CHECK(out.state == FlightState::perforated);
    auto carried = flight_of(nose);
    fly(carried, 0, 400, creeping, hanging, 13e-3);
    CHECK(carried.state == FlightState::in_progress);
    auto back = flight_of(nose);
    fly(
        back, 0, 400, [](int) { return -0.1; }, loose, 13e-3);
    CHECK(back.state == FlightState::in_progress);
  }
}

TEST_CASE("a blunt projectile that flies with the plate has not perforated it", "[perforation]") {
  const auto carried = [](int) { return 20.0; };
  auto flight = flight_of(Nose::blunt);
  fly(flight, 0, 400, carried, [] { return Way<double>{true, true, 19}; });
  CHECK(flight.state == FlightState::in_progress);
  fly(flight, 400, 401, carried, [] { return Way<double>{true, true, 18}; }); // 2 m/s faster: above 0.5 % of 300 m/s
  CHECK(flight.state == FlightState::perforated);
}

TEST_CASE("a chain of debris does not count once the tail has left at a steady velocity", "[perforation]") {
  const auto steady = [](int) { return 200.0; };
  for (const Nose nose : {Nose::blunt, Nose::conical}) {
    auto inside = flight_of(nose), behind = flight_of(nose);
    fly(inside, 0, 100, steady, hanging, 11.9e-3);
    CHECK(inside.state == FlightState::in_progress);
    fly(behind, 0, 100, steady, hanging, 12.1e-3);
    CHECK(behind.state == FlightState::perforated);
    CHECK(residual_velocity(behind) == 200);
  }
}

TEST_CASE("a blunt projectile has not perforated before its nose is behind the plate", "[perforation]") {
  const auto steady = [](int) { return 200.0; };
  auto inside = flight_of(Nose::blunt), behind = flight_of(Nose::blunt);
  fly(inside, 0, 100, steady, loose, -68.1e-3); // nose at 11.9 mm
  CHECK(inside.state == FlightState::in_progress);
  fly(behind, 0, 100, steady, loose, -67.9e-3);
  CHECK(behind.state == FlightState::perforated);
}

TEST_CASE("an oblique projectile that slides off the front face has been stopped", "[perforation]") {
  auto flight = flight_of(Nose::conical);
  record(flight, {0, 250, 5e-3, -30e-3, -60e-3, 10}, hanging);
  CHECK(flight.state == FlightState::in_progress);
  record(flight, {1e-6, 250, 5e-3, -30e-3, -60e-3, -1}, hanging); // along the line of flight it is still fast
  CHECK(flight.state == FlightState::stopped);
}

TEST_CASE("a sharp shot notes shoulder and tail and ends when the tail has left", "[perforation]") {
  auto flight = flight_of(Nose::conical);
  CHECK(flight.sharp);
  // The tail starts 100 mm above the front face; 0.25 mm each us; the shank drags on the plate all the time.
  for (int t = 0; t < 1000 && flight.state == FlightState::in_progress; ++t) {
    const double tail = -100e-3 + 0.25e-3 * t;
    record(flight, {t * 1e-6, 250 - 0.05 * t, tail + 100e-3, tail + 68e-3, tail, 250}, loose);
  }
  CHECK(flight.state == FlightState::perforated);
  // Shoulder 12 mm deep at t = (12 + 32)/0.25 = 176, tail at 448; a sample either way is round-off.
  REQUIRE(flight.velocity_at_shoulder);
  REQUIRE(flight.velocity_at_tail);
  CHECK(*flight.velocity_at_shoulder == Approx(250 - 0.05 * 176).margin(0.051));
  CHECK(*flight.velocity_at_tail == Approx(250 - 0.05 * 448).margin(0.051));
  CHECK(residual_velocity(flight) == *flight.velocity_at_tail);
}

TEST_CASE("a flight is read off the model", "[perforation]") {
  PerforationCase<double> c;
  c.thickness = 8e-3;
  c.clamp_radius = 60e-3;
  c.sph_radius = 16e-3;
  c.spacing = 1.6e-3;
  c.projectile = paper_projectile<double>(Nose::conical);
  auto model = make_perforation(c, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());
  for (Index n = projectile(model).nodes.begin; n < projectile(model).nodes.end; ++n)
    model.nodes.position[n][2] -= 50e-3;
  const auto s = observe_flight(model, c.projectile, start_flight(c));
  CHECK(s.velocity == Approx(303.5));
  CHECK(s.advance == Approx(303.5));
  CHECK(s.nose == Approx(50e-3));
  CHECK(s.shoulder == Approx(20e-3)); // the nose is 30 mm long
  CHECK(s.tail == Approx(-48e-3));    // 98 mm in all
}
