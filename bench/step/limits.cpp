// SPDX-License-Identifier: BSD-3-Clause
#include "limits.hpp"

#include "ogive/core/pack.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace bench {

namespace {

using ogive::Pack;

/// What a loop has computed goes here, so that the loop is not left out.
volatile double sink = 0;

/// Operations that do not wait for each other: more than latency times throughput of any of those measured, and as few
/// as fit into the registers.
constexpr int independent = 12;

/// Seconds of `f(accumulators)`, called `rounds` times.
template <class F> double seconds_of(std::int64_t rounds, double start, F &&f) {
  std::array<Pack<double>, independent> a;
  for (int k = 0; k < independent; ++k) a[k] = Pack<double>(start + 0.01 * k);
  const double begin = omp_get_wtime();
  for (std::int64_t r = 0; r < rounds; ++r) f(a);
  const double seconds = omp_get_wtime() - begin;
  Pack<double> sum{};
  for (const auto &p : a) sum += p;
  sink = sum[0];
  return seconds;
}

/// Best time of one operation, s.
template <class F> double best_of(bool quick, double start, F &&f) {
  const std::int64_t rounds = quick ? 100'000 : 1'000'000;
  double best = 1;
  for (int repeat = 0; repeat < 5; ++repeat) best = std::min(best, seconds_of(rounds, start, f));
  return best / (static_cast<double>(rounds) * independent);
}

double measure_arithmetic(int threads, bool quick) {
  const std::int64_t rounds = quick ? 3'000'000 : 30'000'000;
  const double flops = 2.0 * ogive::lanes<double> * independent * static_cast<double>(rounds) * threads;
  double best = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    double slowest = 0;
#pragma omp parallel num_threads(threads) reduction(max : slowest)
    {
#pragma omp barrier
      // Goes towards 1, so that no number becomes so small or large that the machine slows down.
      const Pack<double> factor(0.75), addend(0.25);
      slowest = seconds_of(rounds, 1, [&](auto &a) {
        for (auto &p : a) p.v = p.v * factor.v + addend.v;
      });
    }
    best = std::max(best, flops / slowest);
  }
  return best;
}

double measure_triad(int threads, std::size_t bytes, bool quick) {
  constexpr std::int64_t width = ogive::lanes<double>;
  const std::int64_t packs = static_cast<std::int64_t>(bytes / (3 * sizeof(double) * width));
  std::array<std::unique_ptr<double[]>, 3> arrays;
  for (auto &a : arrays) a = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(packs * width));
  double *const a = arrays[0].get(), *const b = arrays[1].get(), *const c = arrays[2].get();
  // The thread that writes first decides where the memory lies.
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::int64_t k = 0; k < packs * width; ++k) a[k] = 0, b[k] = 1, c[k] = 2;
  double best = 1e30;
  for (int repeat = 0; repeat < (quick ? 3 : 6); ++repeat) {
    const Pack<double> factor(0.5 * repeat);
    const double begin = omp_get_wtime();
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t k = 0; k < packs * width; k += width)
      ogive::store_pack(a + k, ogive::load_pack(b + k) + factor * ogive::load_pack(c + k));
    best = std::min(best, omp_get_wtime() - begin);
  }
  sink = a[packs];
  return 3.0 * sizeof(double) * static_cast<double>(packs * width) / best;
}

} // namespace

std::size_t triad_bytes(bool quick) {
  constexpr std::size_t least = std::size_t(256) << 20;
  if (quick) return least;
  const auto ask = [](int name) { return static_cast<std::size_t>(std::max(0L, sysconf(name))); };
  const std::size_t memory = ask(_SC_PHYS_PAGES) * ask(_SC_PAGESIZE), cache = ask(_SC_LEVEL3_CACHE_SIZE);
  return std::min(std::max(least, 4 * cache), memory / 4);
}

Limits measure_limits(int threads, std::size_t bytes, bool quick) {
  return {threads, measure_triad(threads, bytes, quick), measure_arithmetic(threads, quick)};
}

PackTimes measure_pack_times(bool quick) {
  // Each operation leads to a number near 1 again.
  const auto each = [](auto operation) {
    return [=](auto &a) {
      for (auto &p : a) p = operation(p);
    };
  };
  const Pack<double> one(1.0);
  return {best_of(quick, 1, each([=](Pack<double> p) { return one / p; })),
          best_of(quick, 1, each([](Pack<double> p) { return ogive::sqrt(p); })),
          best_of(quick, 1, each([](Pack<double> p) { return ogive::reciprocal(p); })),
          best_of(quick, 1, each([](Pack<double> p) { return ogive::inverse_sqrt(p); }))};
}

} // namespace bench
