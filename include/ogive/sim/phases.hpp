// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace ogive {

/// The parts that a run's wall time is booked to.
enum class Phase { neighbours, gradient, stress, force, hexes, contact, motion, checks, observer };

/// Number of phases.
inline constexpr std::size_t phase_count = 9;

/// Name of a phase in tables and files.
constexpr std::string_view name(Phase phase) {
  constexpr std::array<std::string_view, phase_count> names{"neighbours", "gradient", "stress", "force",   "hexes",
                                                            "contact",    "motion",   "checks", "observer"};
  return names[static_cast<std::size_t>(phase)];
}

/// Wall time of each phase, s. It is no part of the state of a model.
struct PhaseTimes {
  std::array<double, phase_count> seconds{}; ///< in the order of Phase
  /// Wall time of one phase, s.
  double operator[](Phase phase) const { return seconds[static_cast<std::size_t>(phase)]; }
};

/// Books the time since it was made, or since its last call, to a phase.
class Lap {
public:
  /// Starts now.
  explicit Lap(PhaseTimes &times) : times_(times) {}
  /// Books what has passed to `phase`.
  void operator()(Phase phase) {
    const auto now = std::chrono::steady_clock::now();
    times_.seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// Books the time since the last call to no phase, because another one has booked it.
  void restart() { last_ = std::chrono::steady_clock::now(); }

private:
  PhaseTimes &times_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace ogive
