// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// One small shot, compiled once for each SIMD width with flags of its own, see widths.cmake.

/// How the shot ended, and how wide its packs were.
struct Outcome {
  int lanes;                      ///< doubles in a pack
  int clustered;                  ///< places of the neighbour lists; a multiple of the lanes
  double kinetic, plastic, total; ///< J
};

Outcome shot_with_128_bits();
Outcome shot_with_256_bits();
Outcome shot_with_512_bits();
