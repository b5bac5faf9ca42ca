// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/sph/layout.hpp"

#include <numbers>

using namespace ogive;

TEST_CASE("discs have the plate's volume, whole layers and respect the mirror planes", "[sph]") {
  const DiscShape<double> shape{24e-3, 12e-3, 0.6e-3};
  const double volume = std::numbers::pi * 24e-3 * 24e-3 * 12e-3;
  for (const auto &make : {&cubic_disc<double>, &ring_disc<double>}) {
    double full = 0, quarter = 0;
    for (double v : make(shape, Extent::full).volumes) full += v;
    const auto q = make(shape, Extent::quarter);
    for (double v : q.volumes) quarter += v;
    CHECK(4 * quarter == Approx(full).epsilon(1e-9));
    CHECK(full == Approx(volume).epsilon(5e-3)); // the lattice's staircase; rings are exact
    for (const auto &p : q.positions) REQUIRE((p[0] > 0 && p[1] > 0 && p[2] < 0 && p[2] > -12e-3));
  }
  const auto odd = cubic_disc(DiscShape<double>{24e-3, 10e-3, 0.6e-3}, Extent::quarter);
  CHECK(odd.spacing == Approx(10e-3 / 17)); // 16.67 layers: the nearest whole number is 17
  CHECK_THROWS_WITH(cubic_disc(DiscShape<double>{24e-3, 1e-3, 0.6e-3}, Extent::quarter),
                    Catch::Contains("at most half"));
  CHECK_THROWS_AS(cubic_disc(DiscShape<double>{24e-3, 12e-3, std::nan("")}, Extent::quarter), SetupError);
}

TEST_CASE("a disturbed disc keeps its particles near their places, within the disc and on their side", "[sph]") {
  const DiscShape<double> shape{24e-3, 6e-3, 1e-3};
  for (const auto &make : {&cubic_disc<double>, &ring_disc<double>})
    for (const Extent extent : {Extent::quarter, Extent::half}) {
      const auto lattice = make(shape, extent);
      auto one = lattice, other = lattice;
      disturb(one, shape, extent, 1), disturb(other, shape, extent, 2);
      CHECK(one.volumes == lattice.volumes);
      const double most = largest_disturbance * lattice.spacing;
      double mean = 0, squares = 0;
      std::size_t moved = 0;
      for (std::size_t i = 0; i < lattice.positions.size(); ++i) {
        const auto &p = one.positions[i], &p0 = lattice.positions[i];
        const Vec3<double> by = p - p0;
        REQUIRE(by.cwiseAbs().maxCoeff() <= most);
        REQUIRE(std::hypot(p[0], p[1]) < shape.radius);
        REQUIRE(p[1] > 0);
        REQUIRE((extent == Extent::half || p[0] > 0));
        if (p0[2] > -lattice.spacing || p0[2] < lattice.spacing - shape.thickness) REQUIRE(by[2] == 0);
        if (by[0] == 0) continue; // would have left the disc
        ++moved, mean += by[0] / most, squares += by[0] * by[0] / (most * most);
        CHECK(by[0] != other.positions[i][0] - p0[0]);
      }
      CHECK(double(moved) > 0.95 * double(lattice.positions.size()));
      // Even numbers between -1 and 1: mean 0, mean square 1/3; some 1800 of them or more.
      CHECK(std::abs(mean / double(moved)) < 4 / std::sqrt(3.0 * double(moved)));
      CHECK(squares / double(moved) == Approx(1.0 / 3).epsilon(0.1));
    }
}

TEST_CASE("a whole disc is turned as well, by another angle for each seed", "[sph]") {
  const DiscShape<double> shape{24e-3, 6e-3, 2e-3};
  const auto lattice = cubic_disc(shape, Extent::full);
  for (const std::uint64_t seed : {1, 2, 3}) {
    auto turned = lattice;
    disturb(turned, shape, Extent::full, seed);
    const double angle = 2 * std::numbers::pi * random_number(seed, 0), c = std::cos(angle), s = std::sin(angle);
    for (std::size_t i = 0; i < lattice.positions.size(); ++i) {
      const auto &p0 = lattice.positions[i];
      const Vec3<double> place(c * p0[0] - s * p0[1], s * p0[0] + c * p0[1], p0[2]);
      REQUIRE((turned.positions[i] - place).cwiseAbs().maxCoeff() <= largest_disturbance * lattice.spacing);
    }
  }
  CHECK(std::abs(random_number(1, 0) - random_number(2, 0)) > 1e-3);
}

TEST_CASE("random numbers are the same on all machines") {
  // Computed apart, with whole numbers of any length.
  CHECK(random_number(1, 0) == 0.9557038184179468);
  CHECK(random_number(1, 1) == 0.7486828894513605);
  CHECK(random_number(12345678901, 99) == 0.678033883900329);
  double least = 1, most = 0, sum = 0;
  for (std::uint64_t k = 0; k < 10000; ++k) {
    const double x = random_number(5, k);
    least = std::min(least, x), most = std::max(most, x), sum += x;
  }
  CHECK(least >= 0);
  CHECK(least < 0.001);
  CHECK(most < 1);
  CHECK(most > 0.999);
  CHECK(sum / 10000 == Approx(0.5).margin(0.012)); // four standard errors
}
