// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/extremes.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>
#include <array>
#include <vector>

/// \file
/// Parallel loops and sums whose result does not depend on the number of threads: a loop body writes only what belongs
/// to its own index, and a sum adds fixed blocks in a fixed order.

namespace ogive {

/// Indices that one thread takes at a time.
inline constexpr Index loop_chunk = 128;

/// Calls `f(i)` for i in [0, n), in parallel. `f` must write only what belongs to i.
template <class F> void parallel_for(Index n, F &&f) {
#pragma omp parallel for schedule(dynamic, loop_chunk) if (n > loop_chunk)
  for (Index i = 0; i < n; ++i) f(i);
}

/// Calls `f(chunk_begin, chunk_end)` for consecutive chunks of [0, n), in parallel.
template <class F> void parallel_for_chunks(Index n, Index chunk, F &&f) {
  const Index chunks = (n + chunk - 1) / chunk;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index c = 0; c < chunks; ++c) f(c * chunk, std::min(n, (c + 1) * chunk));
}

/// Folds `f(i)`, i in [0, n), with `combine` in a fixed order: the same bits for any number of threads.
template <class R, class F, class Combine> R ordered_fold(Index n, R start, F &&f, Combine &&combine) {
  constexpr Index block = 1024;
  const Index blocks = (n + block - 1) / block;
  std::vector<R> partial(static_cast<std::size_t>(blocks), start);
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (Index b = 0; b < blocks; ++b) {
    R folded = start;
    for (Index i = b * block, end = std::min(n, (b + 1) * block); i < end; ++i) folded = combine(folded, f(i));
    partial[static_cast<std::size_t>(b)] = folded;
  }
  R folded = start;
  for (const R &p : partial) folded = combine(folded, p);
  return folded;
}

/// Sum of `f(i)` over i in [0, n), the same bits for any number of threads. `zero` gives the type.
template <class R, class F> R ordered_sum(Index n, R zero, F &&f) {
  return ordered_fold(n, zero, f, [](const R &a, const R &b) -> R { return a + b; });
}

/// Smallest `f(i)` over i in [0, n), not above `start`; not a number if one of them is not.
template <class R, class F> R parallel_min(Index n, R start, F &&f) {
  return ordered_fold(n, start, f, [](const R &a, const R &b) { return least(a, b); });
}

/// Largest `f(i)` over i in [0, n), not below `start`; not a number if one of them is not.
template <class R, class F> R parallel_max(Index n, R start, F &&f) {
  return ordered_fold(n, start, f, [](const R &a, const R &b) { return most(a, b); });
}

} // namespace ogive
