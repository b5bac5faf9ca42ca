// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

/// \file
/// What the machine can do at most, measured with the packs that the library works with.

namespace bench {

namespace detail {

using ogive::Pack;

/// Takes what a loop has computed, so that the loop is not left out.
inline volatile double sink = 0;

/// Operations that do not wait for each other: more than latency times throughput of any of those measured, and as few
/// as fit into the registers.
inline constexpr int independent = 12;

/// Seconds of `f(pack)` on packs of `T`, called `rounds` times for each.
template <class T, class F> double seconds_of(std::int64_t rounds, F &&f) {
  std::array<Pack<T>, independent> a;
  for (int k = 0; k < independent; ++k) a[k] = Pack<T>(T(1 + 0.01 * k));
  const double begin = omp_get_wtime();
  for (std::int64_t r = 0; r < rounds; ++r)
    for (auto &p : a) p = f(p);
  const double seconds = omp_get_wtime() - begin;
  Pack<T> sum{};
  for (const auto &p : a) sum += p;
  sink = static_cast<double>(sum[0]);
  return seconds;
}

} // namespace detail

/// flop/s in single precision, fused multiply-adds alone, each of them two flops; the best of several runs.
inline double measure_arithmetic(int threads, bool quick) {
  using ogive::Pack;
  const std::int64_t rounds = quick ? 3'000'000 : 30'000'000;
  const double flops = 2.0 * ogive::lanes<float> * detail::independent * static_cast<double>(rounds) * threads;
  double best = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    double slowest = 0;
#pragma omp parallel num_threads(threads) reduction(max : slowest)
    {
#pragma omp barrier
      // Goes towards 1, so that no number becomes so small or large that the machine slows down.
      const Pack<float> factor(0.75F), addend(0.25F);
      slowest = detail::seconds_of<float>(rounds, [&](Pack<float> p) {
        p.v = p.v * factor.v + addend.v;
        return p;
      });
    }
    best = std::max(best, flops / slowest);
  }
  return best;
}

/// byte/s of STREAM's a = b + s c on arrays of so many bytes together, three words each; the best of several runs.
inline double measure_triad(int threads, std::size_t bytes, bool quick) {
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
    const ogive::Pack<double> factor(0.5 * repeat);
    const double begin = omp_get_wtime();
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t k = 0; k < packs * width; k += width)
      ogive::store_pack(a + k, ogive::load_pack(b + k) + factor * ogive::load_pack(c + k));
    best = std::min(best, omp_get_wtime() - begin);
  }
  detail::sink = a[packs];
  return 3.0 * sizeof(double) * static_cast<double>(packs * width) / best;
}

/// Bytes of the three arrays together: four times the last cache, at most a quarter of the memory; `quick`: 256 MiB.
inline std::size_t triad_bytes(bool quick) {
  constexpr std::size_t least = std::size_t(256) << 20;
  if (quick) return least;
  const auto of_system = [](int name) { return static_cast<std::size_t>(std::max(0L, sysconf(name))); };
  const std::size_t memory = of_system(_SC_PHYS_PAGES) * of_system(_SC_PAGESIZE);
  return std::min(std::max(least, 4 * of_system(_SC_LEVEL3_CACHE_SIZE)), memory / 4);
}

} // namespace bench
