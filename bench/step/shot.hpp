// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "memory.hpp"
#include "work.hpp"

#include "ogive/sim/phases.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// \file
/// Times the steps of a shot.

namespace bench {

/// What to measure.
struct Plan {
  std::vector<int> threads;
  int steps = 0;           ///< that are timed; 0: whole cycles between two rebuilds of the neighbour lists
  int repeats = 3;         ///< measurements, of which the median counts
  double seconds = 3;      ///< at least, of one measurement: the steps are repeated from the same state
  double load_time = 2e-6; ///< s of simulated time before the steps that are timed
  int load_steps = 30;     ///< at least
};

/// Times of a number of threads; medians of the repeats.
struct Timing {
  int threads = 1;
  int rounds = 1;                                  ///< from the same state, in one measurement
  int rebuilds = 0;                                ///< of the neighbour lists in a round
  std::array<double, ogive::phase_count> phases{}; ///< s per step
  double step = 0;                                 ///< s per step, all phases
  double rebuild = 0;                              ///< s, what a step with new neighbour lists takes longer
  double spread = 0;                               ///< largest less smallest step over the median
  std::uint64_t hash = 0;                          ///< of the state after the steps
  double operator[](ogive::Phase phase) const { return phases[static_cast<std::size_t>(phase)]; }
};

/// Everything measured with a number of particles.
struct ShotResult {
  double spacing = 0;    ///< m
  double start_time = 0; ///< s, simulated, at the first step that is timed
  std::int64_t start_step = 0;
  int steps = 0; ///< that are timed
  std::int64_t hexes = 0, slaves = 0;
  Work work; ///< at the first step that is timed
  Memory memory;
  std::vector<Timing> timings;
};

/// True if all numbers of threads led to the same state.
bool equal_hashes(const ShotResult &result);

/// Shoots a quarter of about `particles` particles: 12 mm Weldox 460 E, blunt projectile, 303.5 m/s. `progress(text)`
/// is called now and then.
ShotResult measure_shot(double particles, const Plan &plan, const std::function<void(const std::string &)> &progress);

} // namespace bench
