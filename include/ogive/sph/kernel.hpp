// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/choice.hpp"
#include "ogive/core/pack.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

namespace ogive {

/// A smoothing kernel in three dimensions with support 2h: W(r) = norm/h^3 w(r/h). It gives w(u), and (dw/du)/u from u
/// and 1/u; both are zero for u >= 2. They are templates of the number type: packs of numbers go through them too.
template <class K>
concept SmoothingKernel = requires(double u, Pack<double> p, Pack<float> q) {
  { K::norm } -> std::convertible_to<double>;
  { K::shape(u) } -> std::same_as<double>;
  { K::slope_over_u(u, u) } -> std::same_as<double>;
  { K::slope_over_u(p, p) } -> std::same_as<Pack<double>>;
  { K::slope_over_u(q, q) } -> std::same_as<Pack<float>>;
};

/// Radius of support over the smoothing length, the same for all kernels.
inline constexpr double kernel_support = 2.0;

/// Cubic B-spline (Monaghan & Lattanzio 1985), written without a branch.
struct CubicSpline {
  static constexpr double norm = 1.0 / std::numbers::pi; ///< makes W integrate to one
  /// w(u) with u = r/h.
  template <class T> static T shape(T u) {
    const T far = std::max(T(2) - u, T(0)), near = std::max(T(1) - u, T(0));
    return T(0.25) * far * far * far - near * near * near;
  }
  /// (dw/du)/u.
  template <class T> static T slope_over_u(T u, T inverse_u) {
    using std::max;
    constexpr double half_root3 = 0.5 * std::numbers::sqrt3;
    const T far = max(T(2 * half_root3) - T(half_root3) * u, T(0));
    return select(u < T(1), T(2.25) * u - T(3), -far * far * inverse_u);
  }
};

/// Wendland C2 (Wendland 1995), no pairing instability.
struct WendlandC2 {
  static constexpr double norm = 21.0 / (16.0 * std::numbers::pi); ///< makes W integrate to one
  /// w(u) with u = r/h.
  template <class T> static T shape(T u) {
    const T s = std::max(T(1) - T(0.5) * u, T(0));
    return s * s * s * s * (T(2) * u + T(1));
  }
  /// (dw/du)/u.
  template <class T> static T slope_over_u(T u, T) {
    using std::max;
    const T s = max(T(1) - T(0.5) * u, T(0));
    return T(-5) * s * s * s;
  }
};

/// A kernel that is chosen when the program runs.
using AnyKernel = std::variant<CubicSpline, WendlandC2>;

/// W(r) in 1/m3.
template <class Kernel, class T> T kernel_value(T r, T h) {
  return T(Kernel::norm) / (h * h * h) * Kernel::shape(r / h);
}

/// Norm of (dW/dr)/r, 1/m5, from 1/h.
template <class Kernel, class T> T gradient_norm(T inverse_h) {
  const T h2 = inverse_h * inverse_h;
  return T(Kernel::norm) * h2 * h2 * inverse_h;
}

/// The norm of a pair over that of the body, from the ratio of the body's smoothing length to the pair's.
template <class T> T relative_norm(T ratio) {
  const T squared = ratio * ratio;
  return squared * squared * ratio;
}

/// (dw/du)/u from u^2 = (r/h)^2; u is not taken below 1e-6, so that it is finite at r = 0.
template <class Kernel, class T> T slope_over_u(T u_squared) {
  using std::max;
  const T squared = max(u_squared, T(1e-12)), inverse_u = inverse_sqrt(squared);
  return Kernel::slope_over_u(T(squared * inverse_u), inverse_u);
}

/// Slope over u to 14 bits, for u > 0: pairs are antisymmetric and corrected gradients exact with any kernel.
template <class Kernel, class Width = SimdWidth> Pack<float> rough_slope_over_u(Pack<float> u_squared) {
  const Pack<float> inverse_u = rough_inverse_sqrt(u_squared);
  return Kernel::slope_over_u(Pack<float>(u_squared * inverse_u), inverse_u);
}

/// Square of the support over the smoothing length, with room for the error of rough_slope_over_u.
inline constexpr double support_squared = kernel_support * kernel_support * (1 + 3e-4);

/// (dW/dr)/r in 1/m5, from r^2 and 1/h: grad_i W_ij = gradient_over_r * (x_i - x_j). Finite at r = 0.
template <class Kernel, class T> T gradient_over_r(T r_squared, T inverse_h) {
  return gradient_norm<Kernel>(inverse_h) * slope_over_u<Kernel>(T(r_squared * (inverse_h * inverse_h)));
}

} // namespace ogive
