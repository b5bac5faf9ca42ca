// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/perforation/limit_search.hpp"

#include <limits>

using namespace ogive;

namespace {

using Shots = std::vector<TriedShot<double>>;

/// Shoots as the search asks at a plate that stops everything up to `limit`. Ends with a failure after 100 shots.
Shots search(double limit, double guess, double width = 5, double round_to = 1, Shots tried = {},
             std::optional<double> expected = std::nullopt) {
  while (tried.size() < 100) {
    const auto next = next_velocity(tried, guess, width, round_to, expected);
    if (!next) return tried;
    REQUIRE(std::none_of(tried.begin(), tried.end(), [&](const auto &shot) { return shot.velocity == *next; }));
    tried.push_back({*next, *next > limit});
  }
  FAIL("no end for a limit of " << limit << " from " << guess);
  return tried;
}

/// The velocities of a search.
std::vector<double> velocities(const Shots &tried) {
  std::vector<double> all;
  for (const auto &shot : tried) all.push_back(shot.velocity);
  return all;
}

} // namespace

TEST_CASE("a bracket is the lowest shot through the plate and the highest below it that was stopped", "[perforation]") {
  CHECK_FALSE(bracket(Shots{}).highest_stopped);
  CHECK_FALSE(bracket(Shots{}).lowest_perforated);
  CHECK(bracket(Shots{}).consistent);
  CHECK_FALSE(limit_estimate(bracket(Shots{})));

  // The blunt shots at 12 mm of the table, without the one that was stopped at 184.8 m/s.
  Shots tried{{224.7, true}, {181.5, false}, {189.6, true}, {170, false}, {184.3, true}};
  const auto b = bracket(tried);
  CHECK(b.highest_stopped == 181.5);
  CHECK(b.lowest_perforated == 184.3);
  CHECK(b.consistent);
  const auto limit = limit_estimate(b);
  REQUIRE(limit);
  CHECK(limit->limit == Approx(182.9).epsilon(1e-12));
  CHECK(limit->half_width == Approx(1.4).epsilon(1e-12));

  CHECK_FALSE(limit_estimate(bracket(Shots{{200, true}})));
  CHECK_FALSE(limit_estimate(bracket(Shots{{200, false}})));
}

TEST_CASE("shots that contradict each other are told and leave the bracket below them", "[perforation]") {
  // The table's own: perforated at 184.3 and stopped at 184.8 m/s.
  Shots tried{{181.5, false}, {184.3, true}, {184.8, false}, {189.6, true}};
  auto b = bracket(tried);
  CHECK_FALSE(b.consistent);
  CHECK(b.highest_stopped == 181.5);
  CHECK(b.lowest_perforated == 184.3);
  CHECK_FALSE(next_velocity(tried, 184));
  CHECK(next_velocity(tried, 184, 2, 0.1).value() == Approx(182.9).epsilon(1e-12));

  // Both at one velocity is a contradiction, too.
  CHECK_FALSE(bracket(Shots{{200, true}, {200, false}}).consistent);
  // With nothing stopped below, the search steps down; the one stopped above is no step.
  tried = {{200, true}, {230, false}};
  CHECK_FALSE(bracket(tried).highest_stopped);
  CHECK(next_velocity(tried, 300).value() == 188);
}

TEST_CASE("the search begins with the guess, steps outward with doubled steps and halves the bracket",
          "[perforation]") {
  CHECK(next_velocity(Shots{}, 184.3).value() == 184.3);
  // Upwards 200 (1 + 0.06) = 212, 212 (1 + 0.12) = 237.44, 237 (1 + 0.24) = 293.88; then the middles 265.5, 280, 287,
  // 290.5 and 289, halves rounded away from zero, until 289 to 291 m/s are left.
  CHECK(velocities(search(289, 200, 3)) == std::vector<double>{200, 212, 237, 294, 266, 280, 287, 291, 289});
  // Downwards 200 (1 - 0.06) = 188, 188 (1 - 0.12) = 165.44; then 176.5 and 171.
  CHECK(velocities(search(168, 200, 6)) == std::vector<double>{200, 188, 165, 177, 171});
  // A step is at most a half or the double: 0.06 * 2^9 = 30 times would be neither.
  const Shots stopped(10, {300, false}), perforated(10, {300, true});
  CHECK(next_velocity(stopped, 200).value() == 600);
  CHECK(next_velocity(perforated, 200).value() == 150);
  // Many shots must not overflow the doubling.
  CHECK(next_velocity(Shots(5000, {300, false}), 200).value() == 600);
}

TEST_CASE("any limit from 20 to 900 m/s is found from any guess in a few shots", "[perforation]") {
  // From 20 to 900 m/s it takes steps of 6, 12, 24, 48 and 96 % and then doubles: 1.06 1.12 1.24 1.48 1.96 2^4 is 68,
  // so nine steps after the guess; downwards 0.94 0.88 0.76 0.52 2^-4 is 1/49, eight steps. The last step is at most as
  // wide as the limit, 900 m/s, and 900/2^8 is below 5: eight more, and one for rounding. 19 in all.
  std::size_t most = 0, from_near = 0;
  for (double limit = 20; limit <= 900; limit += 7.3)
    for (double guess = 20; guess <= 900; guess += 17.1) {
      const auto tried = search(limit, guess);
      const auto b = bracket(tried);
      const auto estimate = limit_estimate(b);
      REQUIRE(estimate);
      CHECK(b.consistent);
      CHECK(estimate->half_width <= 2.5 * (1 + 1e-12));
      CHECK(std::abs(estimate->limit - limit) <= estimate->half_width * (1 + 1e-12));
      most = std::max(most, tried.size());
      if (std::abs(guess / limit - 1) < 0.05 && limit < 250) from_near = std::max(from_near, tried.size());
    }
  CAPTURE(most, from_near);
  CHECK(most <= 19);
  // A guess good to 5 % of at most 250 m/s: the guess, one step of 6 % on, 15.8 m/s, and two halvings; with 0.5 m/s of
  // rounding for each 16.3, 8.7 and 4.9 m/s.
  CHECK(from_near <= 4);
}

TEST_CASE("a limit that is expected rightly takes two shots, one that is expected wrongly is found all the same",
          "[perforation]") {
  const Shots known{{250, true}};
  CHECK(velocities(search(200, 0.1, 5, 1, known, 201.0)) == std::vector<double>{250, 199, 204});
  // Just above a shot that was stopped, and just below one that perforated: the other end of a bracket of 5 m/s.
  CHECK(next_velocity(Shots{{198, false}, {250, true}}, 200, 5, 1, 200.0).value() == 203);
  CHECK(next_velocity(Shots{{150, false}, {204, true}}, 200, 5, 1, 200.0).value() == 199);
  // Both sides of a limit that coarser particles promise, without a shot that perforated.
  CHECK(next_velocity(Shots{{198, false}}, 198, 5, 1, 200.4).value() == 203);
  CHECK(next_velocity(Shots{{198, false}}, 198, 5, 1, 190.0).value() == 210); // contradicted: a step of 6 %
  // What shots contradict, and what lies outside of all sense, does not count.
  CHECK(next_velocity(Shots{{198, false}, {250, true}}, 200, 5, 1, 190.0).value() == 224);
  CHECK(next_velocity(Shots{{150, false}, {250, true}}, 200, 5, 1, 260.0).value() == 200);
  CHECK(next_velocity(known, 200, 5, 1, 0.0).value() == 235);
  // Two widths or less are halved.
  CHECK(next_velocity(Shots{{195, false}, {200.4, true}}, 200, 5, 1, 199.0).value() == 198);

  for (double limit = 20; limit <= 240; limit += 7.3)
    for (double expected = 5; expected <= 260; expected += 3.7) {
      const auto tried = search(limit, 200, 5, 1, known, expected);
      const auto b = bracket(tried);
      REQUIRE(limit_estimate(b));
      CHECK(*b.lowest_perforated - *b.highest_stopped <= 5 * (1 + 1e-12));
      CHECK(*b.highest_stopped <= limit);
      CHECK(*b.lowest_perforated > limit);
      // A wrong expectation costs the two shots at it, and up to three more for a bracket that they divide badly.
      CHECK(tried.size() <= search(limit, 200, 5, 1, known).size() + 5);
      if (std::abs(expected - limit) < 1.4) CHECK(tried.size() <= known.size() + 3);
    }
}

TEST_CASE("rounding, widths and number types do not keep the search from its end", "[perforation]") {
  for (const double round_to : {0.01, 1.0, 2.5, 25.0, 1000.0})
    for (const double width : {0.05, 1.0, 5.0, 50.0})
      for (const double guess : {20.0, 184.3, 900.0}) {
        const auto b = bracket(search(303.456, guess, width, round_to));
        // Each halving leaves at most three quarters: far fewer than the 100 shots that `search` allows.
        CHECK(*b.lowest_perforated - *b.highest_stopped <= width * (1 + 1e-12));
        CHECK(*b.highest_stopped <= 303.456);
        CHECK(*b.lowest_perforated > 303.456);
      }
  // Decimals: the difference of these is 0.10000000000002274 and must count as 0.1.
  CHECK_FALSE(next_velocity(Shots{{180.2, false}, {180.3, true}}, 180, 0.1));
  CHECK(next_velocity(Shots{{179.2, false}, {184.3, true}}, 180).value() == 182);
  // No number lies between neighbours.
  const double after = std::nextafter(200.0, 300.0);
  CHECK_FALSE(next_velocity(Shots{{200, false}, {after, true}}, 180, 1e-30));
  CHECK(next_velocity(std::vector<TriedShot<float>>{{200.F, false}}, 180).value() == 212.F);
}

TEST_CASE("a plate that stops nothing ends the search at 1 m/s", "[perforation]") {
  const auto tried = search(0, 500);
  CHECK(tried.back().velocity == 1);
  CHECK_FALSE(limit_estimate(bracket(tried)));
}

TEST_CASE("velocities that are none are refused", "[perforation]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -200.0, nan, inf}) {
    CHECK_THROWS_AS(bracket(Shots{{200, true}, {bad, false}}), SetupError);
    CHECK_THROWS_AS(next_velocity(Shots{{bad, true}}, 200), SetupError);
    CHECK_THROWS_AS(next_velocity(Shots{}, bad), SetupError);
    CHECK_THROWS_AS(next_velocity(Shots{}, 200, bad), SetupError);
    CHECK_THROWS_AS(next_velocity(Shots{}, 200, 5, bad), SetupError);
  }
  CHECK_THROWS_WITH(next_velocity(Shots{}, 0), "guess of the ballistic limit (m/s) = 0: must be positive and finite");
  CHECK_THROWS_WITH(bracket(Shots{{-1, true}}), "velocity of a shot (m/s) = -1: must be positive and finite");
}
