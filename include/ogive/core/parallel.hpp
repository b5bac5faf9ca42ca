// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/extremes.hpp"
#include "ogive/core/types.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

/// \file
/// Parallel loops and sums whose result does not depend on the number of threads: a loop body writes only what belongs
/// to its own index, and a sum adds fixed blocks in a fixed order.
///
/// A function that throws ends no process. The loop tries all its parts, then throws one of the exceptions to the
/// thread that called it: that of the lowest index, the same one for any number of threads. The values that the loop
/// was to write are then unspecified.

namespace ogive {

/// Indices that one thread takes at a time.
inline constexpr Index loop_chunk = 128;

namespace parallel_detail {

/// The exception that is to leave a parallel loop: none may leave it by itself.
class FirstException {
public:
  /// To be called where an exception has been caught that part `k` of the loop has thrown.
  [[gnu::cold, gnu::noinline]] void keep(Index k) noexcept {
#pragma omp critical(ogive_first_exception)
    if (!thrown_ || k < part_) {
      thrown_ = std::current_exception();
      part_ = k;
    }
  }
  /// Throws what was kept, if anything was.
  void rethrow() const {
    if (thrown_) raise();
  }

private:
  [[noreturn, gnu::cold, gnu::noinline]] void raise() const { std::rethrow_exception(thrown_); }

  std::exception_ptr thrown_;
  Index part_ = 0;
};

/// Calls `f(i)` for i in [begin, end). This and the next two are compiled apart from the loops that catch what they
/// throw: a handler around them would cut them into pieces, in which a compiler fuses fewer products and sums.
template <class F> [[gnu::noinline]] void call_each(F &f, Index begin, Index end) {
  for (Index i = begin; i < end; ++i) f(i);
}

/// Calls `f(begin, end)`.
template <class F> [[gnu::noinline]] void call_once(F &f, Index begin, Index end) { f(begin, end); }

/// Folds `f(i)`, i in [begin, end), with `combine`.
template <class R, class F, class Combine>
[[gnu::noinline]] R fold(const R &start, F &f, Combine &combine, Index begin, Index end) {
  R folded = start;
  for (Index i = begin; i < end; ++i) folded = combine(folded, f(i));
  return folded;
}

} // namespace parallel_detail

/// Calls `f(i)` for i in [0, n), in parallel. `f` must write only what belongs to i. Throws what `f` throws for the
/// lowest i.
template <class F> void parallel_for(Index n, F &&f) {
  const Index chunks = (n + loop_chunk - 1) / loop_chunk;
  parallel_detail::FirstException first;
#pragma omp parallel for schedule(dynamic, 1) if (chunks > 1)
  for (Index c = 0; c < chunks; ++c) {
    try {
      parallel_detail::call_each(f, c * loop_chunk, std::min(n, (c + 1) * loop_chunk));
    } catch (...) {
      first.keep(c);
    }
  }
  first.rethrow();
}

/// Calls `f(chunk_begin, chunk_end)` for consecutive chunks of [0, n), in parallel. Throws what `f` throws for the
/// first chunk.
template <class F> void parallel_for_chunks(Index n, Index chunk, F &&f) {
  const Index chunks = (n + chunk - 1) / chunk;
  parallel_detail::FirstException first;
#pragma omp parallel for schedule(dynamic, 1)
  for (Index c = 0; c < chunks; ++c) {
    try {
      parallel_detail::call_once(f, c * chunk, std::min(n, (c + 1) * chunk));
    } catch (...) {
      first.keep(c);
    }
  }
  first.rethrow();
}

/// Indices that a fold takes one after the other; what their blocks give is folded then.
inline constexpr Index fold_block = 1024;

/// Folds `f(i)`, i in [0, n), with `combine` in a fixed order: the same bits for any number of threads.
/// Throws what `f` or `combine` throws for the lowest i.
template <class R, class F, class Combine> R ordered_fold(Index n, R start, F &&f, Combine &&combine) {
  constexpr Index block = fold_block;
  const Index blocks = (n + block - 1) / block;
  std::vector<R> partial(static_cast<std::size_t>(blocks), start);
  parallel_detail::FirstException first;
#pragma omp parallel for schedule(static) if (blocks > 1)
  for (Index b = 0; b < blocks; ++b) {
    try {
      partial[static_cast<std::size_t>(b)] =
          parallel_detail::fold(start, f, combine, b * block, std::min(n, (b + 1) * block));
    } catch (...) {
      first.keep(b);
    }
  }
  first.rethrow();
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
