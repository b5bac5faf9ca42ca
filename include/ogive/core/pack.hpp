// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <cstring>
#include <type_traits>
#include <utility>
#if defined(__AVX__)
#include <immintrin.h>
#endif

/// \file
/// Several numbers that are worked on at once. A formula written as a template of its number type serves one particle
/// with `T` and a cluster of particles with `Pack<T>`.
///
/// The width of a pack depends on the compiler's flags. All that depends on it is in an inline namespace that is named
/// for it, or is a template of SimdWidth, so that a program may link objects that were compiled with different flags.

namespace ogive {

#if defined(__AVX512F__)
inline namespace simd_512 {
/// Bytes of a SIMD register of the machine that is compiled for.
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline namespace simd_256 {
/// Bytes of a SIMD register of the machine that is compiled for.
inline constexpr int register_bytes = 32;
#else
inline namespace simd_128 {
/// Bytes of a SIMD register of the machine that is compiled for.
inline constexpr int register_bytes = 16;
#endif

/// Default argument of types whose layout or functions depend on `lanes`: each width has its own.
struct SimdWidth {};

/// Numbers in a pack.
template <class T> inline constexpr Index lanes = register_bytes / static_cast<int>(sizeof(T));

/// `lanes<T>` numbers in one register, with element by element arithmetic.
template <class T> struct Pack {
  /// The compiler's vector type.
  typedef T Register __attribute__((vector_size(register_bytes)));
  Register v; ///< the numbers

  /// Any numbers, as of a T; `Pack{}` is zeros.
  Pack() = default;
  /// One number in all lanes.
  Pack(T same) : v(same - Register{}) {}
  /// A constant of another type, taken as T(constant) takes it.
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::same_as<U, T>) explicit Pack(U same) : Pack(static_cast<T>(same)) {}

  ///@{
  /// Lane by lane.
  Pack &operator+=(Pack o) { return v += o.v, *this; }
  Pack &operator-=(Pack o) { return v -= o.v, *this; }
  Pack &operator*=(Pack o) { return v *= o.v, *this; }
  Pack &operator/=(Pack o) { return v /= o.v, *this; }
  friend Pack operator+(Pack a, Pack b) { return a += b; }
  friend Pack operator-(Pack a, Pack b) { return a -= b; }
  friend Pack operator*(Pack a, Pack b) { return a *= b; }
  friend Pack operator/(Pack a, Pack b) { return a /= b; }
  friend Pack operator-(Pack a) { return a.v = -a.v, a; }
  ///@}
  /// The number in a lane.
  T operator[](Index lane) const { return v[lane]; }
};

// The compiler takes two instructions for a maximum and takes the lanes of a square root apart: overloads for the
// registers of x86.
namespace detail {

template <class R> R register_max(R a, R b) { return a > b ? a : b; }
template <class R> R register_min(R a, R b) { return a < b ? a : b; }
template <class R> R register_sqrt(R a) {
  for (unsigned l = 0; l < sizeof a / sizeof a[0]; ++l) a[l] = std::sqrt(a[l]);
  return a;
}
template <class R> R register_rsqrt(R a) {
  for (unsigned l = 0; l < sizeof a / sizeof a[0]; ++l) a[l] = 1 / std::sqrt(a[l]);
  return a;
}
template <class R> R register_reciprocal(R a) { return 1 / a; }
template <class R> R register_rough_rsqrt(R a) { return register_rsqrt(a); }
template <class R> R register_rough_reciprocal(R a) { return register_reciprocal(a); }
#if defined(__AVX512F__)
// One of Newton's steps from an estimate of 14 bits.
inline __m512d register_rsqrt(__m512d a) {
  const __m512d y = _mm512_rsqrt14_pd(a), half = 0.5 * y;
  return y + half * (1 - a * y * y);
}
inline __m512 register_rsqrt(__m512 a) {
  const __m512 y = _mm512_rsqrt14_ps(a), half = 0.5f * y;
  return y + half * (1 - a * y * y);
}
inline __m512d register_reciprocal(__m512d a) {
  const __m512d y = _mm512_rcp14_pd(a);
  return y + y * (1 - a * y);
}
inline __m512 register_reciprocal(__m512 a) {
  const __m512 y = _mm512_rcp14_ps(a);
  return y + y * (1 - a * y);
}
inline __m512 register_rough_rsqrt(__m512 a) { return _mm512_rsqrt14_ps(a); }
inline __m512 register_rough_reciprocal(__m512 a) { return _mm512_rcp14_ps(a); }
template <class R> bool register_any(R bits) { return _mm512_test_epi64_mask((__m512i)bits, (__m512i)bits) != 0; }
inline __m512d register_max(__m512d a, __m512d b) { return _mm512_max_pd(a, b); }
inline __m512 register_max(__m512 a, __m512 b) { return _mm512_max_ps(a, b); }
inline __m512d register_min(__m512d a, __m512d b) { return _mm512_min_pd(a, b); }
inline __m512 register_min(__m512 a, __m512 b) { return _mm512_min_ps(a, b); }
inline __m512d register_sqrt(__m512d a) { return _mm512_sqrt_pd(a); }
inline __m512 register_sqrt(__m512 a) { return _mm512_sqrt_ps(a); }
#elif defined(__AVX__)
template <class R> bool register_any(R bits) { return !_mm256_testz_si256((__m256i)bits, (__m256i)bits); }
inline __m256d register_max(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
inline __m256 register_max(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
inline __m256d register_min(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
inline __m256 register_min(__m256 a, __m256 b) { return _mm256_min_ps(a, b); }
inline __m256d register_sqrt(__m256d a) { return _mm256_sqrt_pd(a); }
inline __m256 register_sqrt(__m256 a) { return _mm256_sqrt_ps(a); }
#else
template <class R> bool register_any(R bits) {
  bool found = false;
  for (unsigned l = 0; l < sizeof bits / sizeof bits[0]; ++l) found |= bits[l] != 0;
  return found;
}
#endif

} // namespace detail

/// Result of a comparison: all bits of a lane where it holds, else none. `&` and `!` combine masks as they do bools.
template <class T> struct Mask {
  decltype(typename Pack<T>::Register{} < typename Pack<T>::Register{}) v; ///< all bits of a lane, or none
  /// Whether it holds in a lane.
  bool operator[](Index lane) const { return v[lane] != 0; }
  ///@{
  /// Lane by lane.
  friend Mask operator&(Mask a, Mask b) { return a.v = a.v & b.v, a; }
  friend Mask operator!(Mask a) { return a.v = ~a.v, a; }
  ///@}
};

///@{
/// Lane by lane.
template <class T> Mask<T> operator<(Pack<T> a, Pack<T> b) { return {a.v < b.v}; }
template <class T> Mask<T> operator>(Pack<T> a, Pack<T> b) { return {a.v > b.v}; }
template <class T> Mask<T> operator<=(Pack<T> a, Pack<T> b) { return {a.v <= b.v}; }
template <class T> Mask<T> operator>=(Pack<T> a, Pack<T> b) { return {a.v >= b.v}; }
///@}

/// True if a lane holds.
template <class T> bool any(Mask<T> mask) { return detail::register_any(mask.v); }
/// The condition itself, for formulas that take single numbers too.
inline bool any(bool condition) { return condition; }

/// `a` where the mask holds, else `b`.
template <class T> Pack<T> select(Mask<T> mask, Pack<T> a, Pack<T> b) { return a.v = mask.v ? a.v : b.v, a; }
/// `a` if the condition holds, else `b`.
template <class T> T select(bool condition, T a, T b) { return condition ? a : b; }

/// The larger one; `b` where one is not a number.
template <class T> Pack<T> max(Pack<T> a, Pack<T> b) { return a.v = detail::register_max(a.v, b.v), a; }
/// The smaller one; `b` where one is not a number.
template <class T> Pack<T> min(Pack<T> a, Pack<T> b) { return a.v = detail::register_min(a.v, b.v), a; }
/// Square root, lane by lane.
template <class T> Pack<T> sqrt(Pack<T> a) { return a.v = detail::register_sqrt(a.v), a; }

/// 1/sqrt(a) to 27 bits or better, in a fraction of the time of root and division. `a` must be positive.
template <class T> Pack<T> inverse_sqrt(Pack<T> a) { return a.v = detail::register_rsqrt(a.v), a; }
/// 1/sqrt(a) of a single positive number.
template <std::floating_point T> T inverse_sqrt(T a) { return T(1) / std::sqrt(a); }

/// 1/a to 27 bits or better, in a fraction of the time of a division. `a` must not vanish.
template <class T> Pack<T> reciprocal(Pack<T> a) { return a.v = detail::register_reciprocal(a.v), a; }

/// 1/sqrt(a) in single precision to 14 bits or better, from the machine's estimate. `a` must be positive.
template <class Width = SimdWidth> Pack<float> rough_inverse_sqrt(Pack<float> a) {
  return a.v = detail::register_rough_rsqrt(a.v), a;
}
/// 1/a in single precision to 14 bits or better, from the machine's estimate. `a` must not vanish.
template <class Width = SimdWidth> Pack<float> rough_reciprocal(Pack<float> a) {
  return a.v = detail::register_rough_reciprocal(a.v), a;
}

/// Absolute value, lane by lane.
template <class T> Pack<T> abs(Pack<T> a) { return max(a, -a); }

/// Natural logarithm of positive numbers.
template <class T> Pack<T> log(Pack<T> a) {
  Eigen::Array<T, lanes<T>, 1> x;
  std::memcpy(x.data(), &a.v, sizeof a.v);
  x = x.log().eval();
  std::memcpy(&a.v, x.data(), sizeof a.v);
  return a;
}

/// Exponential function, lane by lane.
template <class T> Pack<T> exp(Pack<T> a) {
  Eigen::Array<T, lanes<T>, 1> x;
  std::memcpy(x.data(), &a.v, sizeof a.v);
  x = x.exp().eval();
  std::memcpy(&a.v, x.data(), sizeof a.v);
  return a;
}

/// Power of positive numbers; its relative error is that of exponent * log(a), a few units in the last place.
template <class T> Pack<T> pow(Pack<T> a, T exponent) { return exp(exponent * log(a)); }

/// The pack at `values` (no alignment needed).
template <class T> Pack<T> load_pack(const T *values) {
  Pack<T> p;
  std::memcpy(&p.v, values, sizeof p.v);
  return p;
}

namespace detail {

template <class T, class F, Index... lane> Pack<T> pack_of(F &f, std::integer_sequence<Index, lane...>) {
  Pack<T> p;
  p.v = typename Pack<T>::Register{f(lane)...};
  return p;
}

} // namespace detail

/// The pack of `f(0)`, `f(1)`, ... It is put together in the register: through memory it would wait for the writes.
template <class T, class F> Pack<T> pack_of(F &&f) {
  return detail::pack_of<T>(f, std::make_integer_sequence<Index, lanes<T>>());
}

/// Writes the pack to `values`.
template <class T> void store_pack(T *values, const Pack<T> &p) { std::memcpy(values, &p.v, sizeof p.v); }

/// One lane of a matrix of packs.
template <class T> Mat3<T> lane_of(const Mat3<Pack<T>> &m, Index lane) {
  Mat3<T> one;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) one(r, c) = m(r, c)[lane];
  return one;
}

} // namespace simd_...
} // namespace ogive

/// \cond
/// Matrices of packs.
template <class T> struct Eigen::NumTraits<ogive::Pack<T>> : Eigen::GenericNumTraits<ogive::Pack<T>> {
  using Real = ogive::Pack<T>;
  using NonInteger = ogive::Pack<T>;
  using Nested = ogive::Pack<T>;
  using Literal = T;
  static constexpr int IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0;
  static constexpr int ReadCost = 1, AddCost = 1, MulCost = 1;
};
/// \endcond
