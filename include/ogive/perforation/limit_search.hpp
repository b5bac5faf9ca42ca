// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

/// \file
/// Which velocities to shoot at so that the ballistic limit lies between two of them.

namespace ogive {

/// A shot that was made or computed.
template <class T> struct TriedShot {
  T velocity{};            ///< initial, m/s
  bool perforated = false; ///< else stopped
};

/// The bracket of the limit that the shots give, m/s.
template <class T> struct LimitBracket {
  std::optional<T> highest_stopped;   ///< of those below the lowest that perforated
  std::optional<T> lowest_perforated; ///< of all
  bool consistent = true;             ///< no shot stopped at the velocity of one that perforated or above
};

/// The limit as the middle of a bracket, m/s.
template <class T> struct LimitEstimate {
  T limit{};      ///< m/s
  T half_width{}; ///< of the bracket, m/s
};

namespace limit_search_detail {

/// Lowest velocity of the search, m/s: a plate that does not stop such a shot has no limit worth knowing.
template <class T> inline constexpr T least_velocity = T(1);

template <class T> void require_positive(const char *thing, T value) {
  require(std::isfinite(value) && value > 0, thing, value, "must be positive and finite");
}

/// The nearest multiple of `round_to` unless it is further than a quarter of `gap` away, the step or bracket that
/// `velocity` ends or halves: steps stay steps, brackets shrink, and no velocity comes twice.
template <class T> T rounded(T velocity, T gap, T round_to) {
  const T multiple = round_to * std::round(velocity / round_to);
  return std::abs(multiple - velocity) <= gap / 4 ? multiple : velocity;
}

/// Away from `velocity`, which is the `count`-th that went the same way.
template <class T> T outward(T velocity, bool up, std::ptrdiff_t count, T round_to) {
  const T share = T(0.06) * std::exp2(static_cast<T>(std::min<std::ptrdiff_t>(count, 32) - 1));
  // Doubling and halving at most: growth without end would leave the velocities of guns behind, or reach zero.
  const T target = up ? velocity * (1 + std::min(share, T(1))) : velocity * (1 - std::min(share, T(0.5)));
  return std::max(least_velocity<T>, rounded(target, std::abs(target - velocity), round_to));
}

/// Into the bracket from `low` to `high` so that, if the limit is where it is expected, this shot and the next one end
/// the search: one `width` from the end that is nearer than that, else half of it below the expected limit.
template <class T> T beside(T expected, T low, T high, T width) {
  if (expected - low <= width) return low + width;
  if (high - expected <= width) return high - width;
  return expected - width / 2;
}

} // namespace limit_search_detail

/// The lowest velocity that perforated and the highest below it that did not. Throws SetupError for a velocity that is
/// not positive and finite.
template <class T> LimitBracket<T> bracket(const std::vector<TriedShot<T>> &tried) {
  LimitBracket<T> b;
  for (const auto &shot : tried) {
    limit_search_detail::require_positive("velocity of a shot (m/s)", shot.velocity);
    if (shot.perforated) b.lowest_perforated = std::min(shot.velocity, b.lowest_perforated.value_or(shot.velocity));
  }
  for (const auto &shot : tried) {
    if (shot.perforated) continue;
    if (b.lowest_perforated && shot.velocity >= *b.lowest_perforated)
      b.consistent = false;
    else
      b.highest_stopped = std::max(shot.velocity, b.highest_stopped.value_or(shot.velocity));
  }
  return b;
}

/// The velocity to try next, m/s; nothing once the limit is known to `width`, half of it to either side.
///
/// The first is the `guess`. While all shots end alike the next one steps on from the last of them, by 6 % and twice as
/// much each further time, up to double or half the velocity. Then it is the middle of the bracket. Velocities are
/// multiples of `round_to` where that moves them by no more than a quarter of the step or bracket; none is tried twice.
/// Nothing, too, if even 1 m/s perforates or if no number lies between the bracket's ends. Where shots contradict each
/// other the search continues below the lowest that perforated; see `bracket`.
///
/// `expected`, m/s, is the limit that something else promises: a curve through the residual velocities of the shots
/// that perforated, or a search with coarser particles. While no shot contradicts it, and until two widths are left,
/// the search tries both sides of it instead of steps and middles.
///
/// Throws SetupError for a velocity, guess, width or round_to that is not positive and finite.
template <class T>
std::optional<T> next_velocity(const std::vector<TriedShot<T>> &tried, std::type_identity_t<T> guess,
                               std::type_identity_t<T> width = T(5), std::type_identity_t<T> round_to = T(1),
                               std::type_identity_t<std::optional<T>> expected = std::nullopt) {
  using namespace limit_search_detail;
  require_positive("guess of the ballistic limit (m/s)", guess);
  require_positive("width of the bracket (m/s)", width);
  require_positive("velocities are rounded to (m/s)", round_to);
  const LimitBracket<T> b = bracket(tried);
  if (tried.empty()) return guess;
  const auto perforated = std::count_if(tried.begin(), tried.end(), [](const auto &shot) { return shot.perforated; });
  if (!b.lowest_perforated) {
    if (expected && *b.highest_stopped < *expected) return rounded(*expected + width / 2, width, round_to);
    return outward(*b.highest_stopped, true, static_cast<std::ptrdiff_t>(tried.size()), round_to);
  }
  if (!b.highest_stopped) {
    if (*b.lowest_perforated <= least_velocity<T>) return std::nullopt;
    const T below = expected.value_or(*b.lowest_perforated) - width / 2;
    if (expected && *b.lowest_perforated > *expected && below > least_velocity<T>)
      return rounded(below, width, round_to);
    return outward(*b.lowest_perforated, false, perforated, round_to);
  }
  const T low = *b.highest_stopped, high = *b.lowest_perforated, gap = high - low;
  // Velocities in decimals: 184.3 - 179.3 must count as 5.
  const T round_off = 4 * std::numeric_limits<T>::epsilon() * high;
  const T middle = low + gap / 2;
  if (gap <= width + round_off || middle <= low || middle >= high) return std::nullopt;
  if (expected && *expected > low && *expected < high && gap > 2 * width)
    return rounded(beside(*expected, low, high, width), width, round_to);
  return rounded(middle, gap, round_to);
}

/// The middle and half the width of a bracket; nothing while one side is open.
template <class T> std::optional<LimitEstimate<T>> limit_estimate(const LimitBracket<T> &b) {
  if (!b.highest_stopped || !b.lowest_perforated) return std::nullopt;
  const T half_width = (*b.lowest_perforated - *b.highest_stopped) / 2;
  return LimitEstimate<T>{*b.highest_stopped + half_width, half_width};
}

} // namespace ogive
