// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/perforation/limit_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace ogive {

/// A ballistic limit by several searches that differ in something that should not matter, such as the arrangement of
/// the particles.
template <class T> struct RepeatedLimit {
  std::size_t repeats = 0;          ///< number of searches
  T mean{};                         ///< m/s
  std::optional<T> deviation{};     ///< standard deviation of the limits, m/s; unset: there is one limit alone
  std::optional<T> half_interval{}; ///< m/s; the limit lies within mean +- half_interval with a probability of 90 %
};

/// 95 % quantile of Student's distribution with `freedom` degrees of freedom, 1 or more: beyond 9 by the expansion of
/// Fisher & Cornish 1960, Technometrics 2:209, to 1e-3.
inline double student_quantile_95(std::size_t freedom) {
  constexpr std::array exact{6.3138, 2.9200, 2.3534, 2.1318, 2.0150, 1.9432, 1.8946, 1.8595, 1.8331};
  require(freedom > 0, "degrees of freedom", freedom, "must be 1 or more");
  if (freedom <= exact.size()) return exact[freedom - 1];
  const double n = static_cast<double>(freedom), z = 1.644854, z3 = z * z * z, z5 = z3 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n);
}

/// Mean, scatter and 90 % interval of the limits of repeated searches (Student's distribution). A limit is known to its
/// bracket alone, in which it may lie anywhere: brackets that happen to agree do not make the interval narrower than
/// that, a standard deviation of half_width/sqrt(3). Throws SetupError if there is none.
template <class T> RepeatedLimit<T> repeated_limit(const std::vector<LimitEstimate<T>> &limits) {
  require(!limits.empty(), "number of limits", limits.size(), "must be 1 or more");
  const T n = static_cast<T>(limits.size());
  RepeatedLimit<T> all{limits.size()};
  T of_brackets{}, squares{};
  for (const auto &one : limits) {
    all.mean += one.limit / n;
    of_brackets += one.half_width * one.half_width / (T(3) * n);
  }
  if (limits.size() == 1) return all;
  for (const auto &one : limits) squares += (one.limit - all.mean) * (one.limit - all.mean);
  const T variance = squares / (n - T(1));
  all.deviation = std::sqrt(variance);
  all.half_interval = T(student_quantile_95(limits.size() - 1)) * std::sqrt(std::max(variance, of_brackets) / n);
  return all;
}

} // namespace ogive
