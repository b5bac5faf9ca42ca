#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

namespace ogive {

/// A smoothing kernel in three dimensions with support 2h: W(r) = norm/h^3 w(r/h). It gives w(u) and (dw/du)/u; both
/// are zero for u >= 2.
template <class K>
concept SmoothingKernel = requires(double u) {
  { K::norm } -> std::convertible_to<double>;
  { K::shape(u) } -> std::same_as<double>;
  { K::slope_over_u(u) } -> std::same_as<double>;
};

/// Radius of support over the smoothing length, the same for all kernels.
inline constexpr double kernel_support = 2.0;

/// Cubic B-spline (Monaghan & Lattanzio 1985), written with truncated powers so that it has no branch.
struct CubicSpline {
  static constexpr double norm = 1.0 / std::numbers::pi;
  template <class T> static T shape(T u) {
    const T far = std::max(T(2) - u, T(0)), near = std::max(T(1) - u, T(0));
    return T(0.25) * far * far * far - near * near * near;
  }
  template <class T> static T slope_over_u(T u) {
    const T far = std::max(T(2) - u, T(0)), near = std::max(T(1) - u, T(0));
    return (T(3) * near * near - T(0.75) * far * far) / u;
  }
};

/// Wendland C2 (Wendland 1995), no pairing instability.
struct WendlandC2 {
  static constexpr double norm = 21.0 / (16.0 * std::numbers::pi);
  template <class T> static T shape(T u) {
    const T s = std::max(T(1) - T(0.5) * u, T(0));
    return s * s * s * s * (T(2) * u + T(1));
  }
  template <class T> static T slope_over_u(T u) {
    const T s = std::max(T(1) - T(0.5) * u, T(0));
    return T(-5) * s * s * s;
  }
};

/// W(r) in 1/m3.
template <class Kernel, class T> T kernel_value(T r, T h) {
  return T(Kernel::norm) / (h * h * h) * Kernel::shape(r / h);
}

/// (dW/dr)/r in 1/m5, from r^2 and 1/h: grad_i W_ij = gradient_over_r * (x_i - x_j). Finite at r = 0.
template <class Kernel, class T> T gradient_over_r(T r_squared, T inverse_h) {
  const T u = std::sqrt(std::max(r_squared * inverse_h * inverse_h, T(1e-12)));
  const T h2 = inverse_h * inverse_h;
  return T(Kernel::norm) * h2 * h2 * inverse_h * Kernel::slope_over_u(u);
}

} // namespace ogive
