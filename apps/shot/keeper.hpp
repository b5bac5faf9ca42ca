// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <cmath>

namespace shot {

/// Schedule of the checkpoints.
struct Keeper {
  double every_us = 0;   ///< 0: by wall time
  double next_us = 0;    ///< simulated time
  double written_at = 0; ///< s of wall time
};

/// Checkpoints from now on, at `time_us` and after `wall_s` of work.
inline Keeper start_keeper(const Options &o, double time_us, double wall_s) {
  const double every = o.checkpoint_every_us;
  return {every, every > 0 ? every * (std::floor(time_us / every) + 1) : 0, wall_s};
}

/// True if a checkpoint is due, and if it is, notes when the next one will be.
inline bool is_due(Keeper &keeper, double time_us, double wall_s) {
  const bool due =
      keeper.every_us > 0 ? time_us >= keeper.next_us : wall_s - keeper.written_at >= 60 * checkpoint_minutes;
  if (!due) return false;
  while (keeper.every_us > 0 && keeper.next_us <= time_us) keeper.next_us += keeper.every_us;
  keeper.written_at = wall_s;
  return true;
}

} // namespace shot
