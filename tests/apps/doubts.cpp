// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "shot/run.hpp"

using Catch::Matchers::Contains;

namespace {

/// A sound result, with particles 0.6 mm apart and a projectile of 197 g.
shot::Result sound_result() {
  shot::Result result;
  result.sizes.spacing_mm = 0.6;
  result.sizes.projectile_mass_g = 197;
  return result;
}

} // namespace

TEST_CASE("a sound result is not doubtful") {
  auto result = sound_result();
  CHECK(shot::doubts_of(result).empty());
  result.intrusion_mm = 0.29;
  result.removed_mass_g = 5.9; // just below 3 %
  CHECK(shot::doubts_of(result).empty());
}

TEST_CASE("particles in the projectile are a doubt from half of a particle distance on") {
  auto result = sound_result();
  result.intrusion_mm = 0.31;
  const auto doubts = shot::doubts_of(result);
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("a particle was 0.31 mm inside the projectile"));
  result.sizes.spacing_mm = 1.2;
  CHECK(shot::doubts_of(result).empty());
}

TEST_CASE("much of the projectile in removed hexes is a doubt of its own") {
  auto result = sound_result();
  result.removed_mass_g = 19.7;
  auto doubts = shot::doubts_of(result);
  REQUIRE(doubts.size() == 1);
  CHECK_THAT(doubts[0], Contains("10 % of the projectile's mass"));
  result.intrusion_mm = 0.5;
  doubts = shot::doubts_of(result);
  REQUIRE(doubts.size() == 2);
  CHECK_THAT(doubts[1], Contains("0.5 mm inside the projectile"));
}
