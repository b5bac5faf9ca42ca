// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"

#include <cstdint>
#include <cstring>

/// \file
/// Tiles: all pairs of four particles with a group of neighbours in one register of single precision. Lane
/// `r * group_size<> + c` is the pair of particle r and neighbour c:
///
///     AVX-512, groups of 4:   0-0 0-1 0-2 0-3 | 1-0 1-1 1-2 1-3 | 2-0 ... | 3-0 ...
///     AVX, groups of 2:       0-0 0-1 1-0 1-1 | 2-0 2-1 3-0 3-1
///     SSE, one neighbour:     0-0 1-0 2-0 3-0

namespace ogive {

/// Particles of a tile, and of a cluster that shares a neighbour list.
inline constexpr Index cluster_size = 4;

// The namespace of the width, as in pack.hpp.
#if defined(__AVX512F__)
inline namespace simd_512 {
#elif defined(__AVX__)
inline namespace simd_256 {
#else
inline namespace simd_128 {
#endif

/// Neighbours of a tile.
template <class Width = SimdWidth> inline constexpr Index group_size = lanes<float> / cluster_size;

/// Coordinates of a tile in whole quanta: their differences are exact, and those of i and j are equal and opposite.
template <class Width = SimdWidth> struct FixedPack {
  /// The compiler's vector type.
  typedef std::int32_t Register __attribute__((vector_size(register_bytes)));
  Register v; ///< the numbers
  /// The difference in quanta. It must fit into 32 bits.
  friend Pack<float> operator-(FixedPack a, FixedPack b) {
    Pack<float> difference;
    difference.v = __builtin_convertvector(a.v - b.v, typename Pack<float>::Register);
    return difference;
  }
};

namespace detail {

#if defined(__AVX512F__)
inline __m512 repeated(const void *group) {
  return _mm512_broadcast_f32x4(_mm_loadu_ps(static_cast<const float *>(group)));
}
inline __m512 spread(const void *cluster) {
  const __m512i row = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
  return _mm512_permutexvar_ps(row, _mm512_castps128_ps512(_mm_loadu_ps(static_cast<const float *>(cluster))));
}
// The sum over each four lanes, in all of them.
inline __m512 row_sums(__m512 a) {
  a += _mm512_permute_ps(a, 0b10110001);
  return a + _mm512_permute_ps(a, 0b01001110);
}
inline void store_row_sums(float *to, __m512 a) {
  const __m512i first = _mm512_setr_epi32(0, 4, 8, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  _mm_storeu_ps(to, _mm512_castps512_ps128(_mm512_permutexvar_ps(first, row_sums(a))));
}
inline bool any_below(__m512 a, __m512 b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ) != 0; }
#elif defined(__AVX__)
inline __m256 repeated(const void *group) {
  double both;
  std::memcpy(&both, group, sizeof both);
  return _mm256_castpd_ps(_mm256_set1_pd(both));
}
inline __m256 spread(const void *cluster) {
  const __m128 four = _mm_loadu_ps(static_cast<const float *>(cluster));
  return _mm256_set_m128(_mm_unpackhi_ps(four, four), _mm_unpacklo_ps(four, four));
}
inline void store_row_sums(float *to, __m256 a) {
  for (int r = 0; r < 4; ++r) to[r] = a[2 * r] + a[2 * r + 1];
}
inline bool any_below(__m256 a, __m256 b) { return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ)) != 0; }
#else
inline Pack<float>::Register repeated(const void *group) {
  float one;
  std::memcpy(&one, group, sizeof one);
  return Pack<float>(one).v;
}
inline Pack<float>::Register spread(const void *cluster) {
  Pack<float>::Register four;
  std::memcpy(&four, cluster, sizeof four);
  return four;
}
inline void store_row_sums(float *to, Pack<float>::Register a) { std::memcpy(to, &a, sizeof a); }
inline bool any_below(Pack<float>::Register a, Pack<float>::Register b) {
  bool found = false;
  for (int l = 0; l < 4; ++l) found |= a[l] < b[l];
  return found;
}
#endif

} // namespace detail

/// The neighbours' numbers, from `group`, for each particle of the tile.
template <class Width = SimdWidth> Pack<float> repeat(const float *group) {
  Pack<float> p;
  p.v = detail::repeated(group);
  return p;
}
/// The neighbours' coordinates in quanta, from `group`, for each particle of the tile.
template <class Width = SimdWidth> FixedPack<Width> repeat(const std::int32_t *group) {
  return {(typename FixedPack<Width>::Register)detail::repeated(group)};
}

/// The particles' numbers, from `cluster`, for each neighbour of the tile.
template <class Width = SimdWidth> Pack<float> spread(const float *cluster) {
  Pack<float> p;
  p.v = detail::spread(cluster);
  return p;
}
/// The particles' coordinates in quanta, from `cluster`, for each neighbour of the tile.
template <class Width = SimdWidth> FixedPack<Width> spread(const std::int32_t *cluster) {
  return {(typename FixedPack<Width>::Register)detail::spread(cluster)};
}

/// Writes, for each of the four particles, the sum over its neighbours to `cluster`.
template <class Width = SimdWidth> void store_row_sums(float *cluster, Pack<float> p) {
  detail::store_row_sums(cluster, p.v);
}

/// True if a < b in some lane.
template <class Width = SimdWidth> bool any_below(Pack<float> a, Pack<float> b) { return detail::any_below(a.v, b.v); }

/// The pack of numbers of single precision at `values`.
template <class T> Pack<T> load_wide(const float *values) {
  typedef float Narrow __attribute__((vector_size(sizeof(float) * lanes<T>)));
  Narrow narrow;
  std::memcpy(&narrow, values, sizeof narrow);
  Pack<T> p;
  p.v = __builtin_convertvector(narrow, typename Pack<T>::Register);
  return p;
}

/// Writes the pack to `values` in single precision.
template <class T> void store_narrow(float *values, const Pack<T> &p) {
  typedef float Narrow __attribute__((vector_size(sizeof(float) * lanes<T>)));
  const Narrow narrow = __builtin_convertvector(p.v, Narrow);
  std::memcpy(values, &narrow, sizeof narrow);
}

} // namespace simd_...
} // namespace ogive
