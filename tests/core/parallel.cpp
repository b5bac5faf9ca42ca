// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"

#include "ogive/core/parallel.hpp"
#include "ogive/core/types.hpp"

#include <cmath>
#include <omp.h>
#include <vector>

using namespace ogive;

namespace {

/// Results of `f()` with 1, 2, 3 and 8 threads.
template <class F> auto with_threads(F &&f) {
  const int before = omp_get_max_threads();
  std::vector<decltype(f())> results;
  for (int threads : {1, 2, 3, 8}) {
    omp_set_num_threads(threads);
    results.push_back(f());
  }
  omp_set_num_threads(before);
  return results;
}

/// A number whose sum depends on the order of the terms: signs and ten decades of magnitude.
double awkward(Index i) { return std::sin(1.0 + i) * std::pow(10.0, i % 11 - 5); }

} // namespace

TEST_CASE("sums have the same bits for any number of threads", "[core]") {
  for (const Index n : {0, 1, 1023, 1024, 1025, 100003}) {
    const auto sums = with_threads([&] { return ordered_sum(n, 0.0, awkward); });
    for (const double s : sums) CHECK(s == sums[0]);
    double plain = 0, magnitude = 0;
    for (Index i = 0; i < n; ++i) plain += awkward(i), magnitude += std::abs(awkward(i));
    // Another order of n terms: round-off of each partial sum.
    CHECK(std::abs(sums[0] - plain) <= 1e-13 * magnitude);
  }
  const auto vectors = with_threads([] {
    return ordered_sum(Index(5000), Vec3<double>(Vec3<double>::Zero()), [](Index i) -> Vec3<double> {
      return {awkward(i), awkward(i + 1), awkward(i + 2)};
    });
  });
  for (const auto &v : vectors) CHECK(v == vectors[0]);
}

TEST_CASE("a fold keeps its order even if the operation does not commute", "[core]") {
  struct Span {
    Index first = -1, last = -1;
    bool ordered = true;
  };
  const auto join = [](const Span &a, const Span &b) {
    if (a.first < 0) return b;
    if (b.first < 0) return a;
    return Span{a.first, b.last, a.ordered && b.ordered && a.last + 1 == b.first};
  };
  for (const Span &s : with_threads([&] {
         return ordered_fold(
             Index(9999), Span{},
             [](Index i) {
               return Span{i, i, true};
             },
             join);
       })) {
    CHECK(s.ordered);
    CHECK(s.first == 0);
    CHECK(s.last == 9998);
  }
}

TEST_CASE("the extremes respect the start", "[core]") {
  const std::vector<double> values = {3, -2, 0, 7, 5};
  const auto value = [&](Index i) { return values[i]; };
  CHECK(parallel_min(Index(5), 100.0, value) == -2);
  CHECK(parallel_min(Index(5), -9.0, value) == -9);
  CHECK(parallel_max(Index(5), -100.0, value) == 7);
  CHECK(parallel_max(Index(0), 4.0, value) == 4);
}

TEST_CASE("the extremes keep what is not a number, wherever it is", "[core]") {
  constexpr Index count = 5000; // several blocks
  for (const Index at : {0, 1, 1023, 1024, 3000, 4999}) {
    const auto value = [&](Index i) { return i == at ? std::nan("") : double(i); };
    for (const double low : with_threads([&] { return parallel_min(count, 1e9, value); })) CHECK(std::isnan(low));
    for (const double high : with_threads([&] { return parallel_max(count, -1e9, value); })) CHECK(std::isnan(high));
  }
  for (const double low : with_threads([] { return parallel_min(count, std::nan(""), awkward); }))
    CHECK(std::isnan(low));
  CHECK(parallel_min(count, 7, [](Index i) { return 9 - i; }) == 9 - (count - 1));
}

TEST_CASE("an exception leaves a loop, that of the lowest index", "[core]") {
  struct Thrown {
    Index at = -1;
  };
  const auto thrown_by = [](auto &&loop) {
    return with_threads([&] {
      try {
        loop();
      } catch (const Thrown &thrown) {
        return thrown.at;
      }
      return Index(-1);
    });
  };
  // Several loops, and several exceptions in many of the parts that a thread takes.
  const auto check = [](Index i) {
    if (i >= 777 && i % 5 == 2) throw Thrown{i};
  };
  for (const Index at : thrown_by([&] { parallel_for(20000, check); })) CHECK(at == 777);
  for (const Index at : thrown_by([&] {
         parallel_for_chunks(20000, 16, [&](Index begin, Index end) {
           for (Index i = begin; i < end; ++i) check(i);
         });
       }))
    CHECK(at == 777);
  for (const Index at : thrown_by([&] { ordered_sum(20000, 0.0, [&](Index i) { return check(i), 1.0; }); }))
    CHECK(at == 777);
  for (const Index at : thrown_by([&] { parallel_for(777, check); })) CHECK(at == -1);
  // The next loop is sound.
  for (const double sum : with_threads([] { return ordered_sum(20000, 0.0, [](Index) { return 1.0; }); }))
    CHECK(sum == 20000);
}

TEST_CASE("loops visit each index once", "[core]") {
  for (const auto &visits : with_threads([] {
         std::vector<int> count(3001, 0);
         parallel_for(3001, [&](Index i) { ++count[i]; });
         parallel_for_chunks(3001, 64, [&](Index begin, Index end) {
           for (Index i = begin; i < end; ++i) ++count[i];
         });
         return count;
       }))
    CHECK(visits == std::vector<int>(3001, 2));
}
