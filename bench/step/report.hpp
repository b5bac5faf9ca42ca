// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"
#include "shot.hpp"

#include <string>
#include <vector>

namespace bench {

/// All that was measured.
struct Report {
  std::size_t triad_bytes = 0; ///< of the three arrays together
  std::vector<Limits> limits;  ///< for each number of threads
  PackTimes pack_times;
  int repeats = 1;
  std::vector<ShotResult> shots;
};

/// Which of the machine's limits a loop over pairs comes nearest to, and how near; all shares 0 to 1.
struct Nearness {
  double flops = 0;        ///< flop/s, of the lane-pairs
  double of_peak = 0;      ///< flops over the peak of fused multiply-adds
  double instructions = 0; ///< arithmetic instructions over what the units for fused multiply-adds take
  double bytes = 0;        ///< byte/s
  double of_triad = 0;     ///< bytes over the triad's
};

/// Of a loop that computes `entries` of the lists with all lanes, touches `bytes` and takes `seconds`.
Nearness nearness(const PairArithmetic &arithmetic, std::int64_t entries, double bytes, double seconds,
                  const Limits &limits);

/// "arithmetic" or "memory", if more than half of the time would be needed for it alone; else "neither".
std::string bound(const Nearness &n);

/// The tables in Markdown, readable on a terminal too.
std::string tables(const Report &report);

/// Everything as JSON, SI units.
std::string json(const Report &report);

} // namespace bench
