// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/core/tile.hpp"
#include "catch.hpp"

#include <array>
#include <cmath>

using namespace ogive;

TEST_CASE("a tile holds all pairs of four particles with a group of neighbours", "[core]") {
  const std::array<float, 4> particles{1, 2, 3, 4};
  const std::array<float, 4> neighbours{0.5F, 0.25F, 0.125F, 0.0625F}; // the first group_size<> are used
  const Pack<float> own = spread(particles.data()), other = repeat(neighbours.data());
  float of_group = 0;
  for (Index c = 0; c < group_size<>; ++c) of_group += neighbours[c];
  for (Index r = 0; r < cluster_size; ++r)
    for (Index c = 0; c < group_size<>; ++c) {
      CHECK(own[r * group_size<> + c] == particles[r]);
      CHECK(other[r * group_size<> + c] == neighbours[c]);
    }
  std::array<float, 4> sums{};
  store_row_sums(sums.data(), own * other);
  for (Index r = 0; r < cluster_size; ++r) CHECK(sums[r] == particles[r] * of_group); // powers of two: exact
}

TEST_CASE("differences of fixed coordinates are exact, equal and opposite", "[core]") {
  // Single precision has 24 bits: these numbers have 31, their differences few.
  const std::array<std::int32_t, 4> a{1073741823, -1073741823, 536870911, 7}, b{1073741820, -1073741810, 536870900, -7};
  const Pack<float> ab = spread(a.data()) - repeat(b.data()), ba = repeat(b.data()) - spread(a.data());
  for (Index lane = 0; lane < lanes<float>; ++lane) CHECK(ab[lane] == -ba[lane]);
  CHECK(ab[0] == 3.0F);
}

TEST_CASE("a lane below another is found", "[core]") {
  const std::array<float, 4> particles{1, 2, 3, 4};
  CHECK(any_below(spread(particles.data()), Pack<float>(1.5F)));
  CHECK_FALSE(any_below(spread(particles.data()), Pack<float>(1.0F)));
}

TEST_CASE("rough roots and reciprocals are good to 14 bits", "[core]") {
  for (float x = 1e-6F; x < 1e15F; x *= 1.37F) {
    CHECK(rough_inverse_sqrt(Pack<float>(x))[0] == Approx(1 / std::sqrt(x)).epsilon(1.0 / (1 << 14)));
    CHECK(rough_reciprocal(Pack<float>(x))[0] == Approx(1 / x).epsilon(1.0 / (1 << 14)));
  }
}
