// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// \file
/// What the machine can do at most, measured with the packs that the library works with.

namespace bench {

/// Limits of the machine with a number of threads.
struct Limits {
  int threads = 1;
  double triad = 0;      ///< byte/s, STREAM's a = b + s c on arrays much larger than the caches, three words each
  double arithmetic = 0; ///< flop/s in double precision, fused multiply-adds alone, each of them two flops
};

/// Time of an operation on a pack of doubles, one thread, many of them independent of each other, s.
struct PackTimes {
  double division = 0;
  double root = 0;
  double reciprocal = 0;   ///< ogive's, 27 bits
  double inverse_root = 0; ///< ogive's, 27 bits
};

/// Bytes of the three arrays together: four times the last cache, at most a quarter of the memory; `quick`: 256 MiB.
std::size_t triad_bytes(bool quick);

/// Measures the limits: the best of several runs.
Limits measure_limits(int threads, std::size_t bytes, bool quick);

PackTimes measure_pack_times(bool quick);

} // namespace bench
