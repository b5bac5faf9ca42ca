// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "widths/shot.hpp"

TEST_CASE("objects of different SIMD widths are linked into one program") {
  const Outcome narrow = shot_with_128_bits();
  CHECK(narrow.lanes == 2);
  CHECK(narrow.clustered == 136); // 125 particles in columns of whole clusters of four
  CHECK(narrow.plastic > 0.1 * narrow.total);
  const auto check = [&](const Outcome &wide, int lanes, int clustered) {
    CHECK(wide.lanes == lanes);
    CHECK(wide.clustered == clustered);
    // Sums in another order; with 512 bits the kernel is good to 14 bits.
    CHECK(wide.kinetic == Approx(narrow.kinetic).epsilon(1e-3));
    CHECK(wide.plastic == Approx(narrow.plastic).epsilon(1e-3));
    CHECK(wide.total == Approx(narrow.total).epsilon(1e-5));
  };
  if (__builtin_cpu_supports("avx2")) check(shot_with_256_bits(), 4, 136); // a multiple of eight
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    check(shot_with_512_bits(), 8, 144); // of sixteen
}
