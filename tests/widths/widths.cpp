// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "widths/shot.hpp"

TEST_CASE("objects of different SIMD widths are linked into one program") {
  const Outcome narrow = shot_with_128_bits();
  CHECK(narrow.lanes == 2);
  CHECK(narrow.clustered == 126); // 125 particles in clusters of two
  CHECK(narrow.plastic > 0.1 * narrow.total);
  const auto check = [&](const Outcome &wide, int lanes, int clustered) {
    CHECK(wide.lanes == lanes);
    CHECK(wide.clustered == clustered);
    // Sums in another order.
    CHECK(wide.kinetic == Approx(narrow.kinetic).epsilon(1e-6));
    CHECK(wide.plastic == Approx(narrow.plastic).epsilon(1e-6));
    CHECK(wide.total == Approx(narrow.total).epsilon(1e-9));
  };
  if (__builtin_cpu_supports("avx2")) check(shot_with_256_bits(), 4, 128);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) check(shot_with_512_bits(), 8, 128);
}
