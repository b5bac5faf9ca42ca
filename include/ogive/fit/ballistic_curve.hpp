// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

/// \file
/// Residual against initial velocity, and how a curve came by its parameters.

namespace ogive {

/// Residual velocity a (v^p - limit^p)^(1/p) of a projectile that strikes at v (Lambert & Jonas 1976, BRL Report 1852).
template <class T> struct BallisticCurve {
  T a{};     ///< slope far above the limit
  T p{};     ///< 2 where energy is kept
  T limit{}; ///< ballistic limit, m/s: the fastest that is stopped
};

/// Largest `a` of a fit. Momentum gives mass/(mass + plug), at most 1, but the best `a` of shots that scatter may lie
/// above it; were it cut off at 1 the limit would make up for it.
inline constexpr double most_ballistic_a = 1.2;
/// Least `p` of a fit, a straight line: below it the curve would leave the limit with slope zero and bend upwards,
/// where those of shots rise steeply and bend down.
inline constexpr double least_ballistic_p = 1;
/// Largest `p` of a fit: there the curve has 73 % of its asymptote 1 % above the limit, a jump for all shots that can
/// be distinguished from the limit; still larger ones give the same curve.
inline constexpr double most_ballistic_p = 8;

/// Residual velocity of the curve at the initial velocity v, m/s; 0 up to the limit.
template <class T> T residual_velocity(const BallisticCurve<T> &curve, std::type_identity_t<T> v) {
  if (!(v > curve.limit)) return T(0);
  return curve.a * v * std::pow(1 - std::pow(curve.limit / v, curve.p), 1 / curve.p);
}

/// The curve of a rigid projectile that shares its momentum with the plug: p = 2 (Recht & Ipson 1963, J. Appl. Mech.
/// 30:384). Masses in kg; the plug's is 0 for noses that push the plate aside. Throws SetupError for a mass or limit
/// that is not finite or not positive.
template <class T>
BallisticCurve<T> recht_ipson(T projectile_mass, std::type_identity_t<T> plug_mass, std::type_identity_t<T> limit) {
  require(std::isfinite(projectile_mass) && projectile_mass > 0, "projectile's mass (kg)", projectile_mass,
          "must be positive and finite");
  require(std::isfinite(plug_mass) && plug_mass >= 0, "plug's mass (kg)", plug_mass, "must be finite and 0 or more");
  require(std::isfinite(limit) && limit > 0, "ballistic limit (m/s)", limit, "must be positive and finite");
  return {projectile_mass / (projectile_mass + plug_mass), T(2), limit};
}

/// A shot and what was left of its velocity, m/s; a residual of 0 means stopped.
template <class T> struct ResidualShot {
  T initial{};  ///< m/s
  T residual{}; ///< m/s
};

/// Origin of a parameter of a fit.
enum class ParameterOrigin {
  held,    ///< not asked of the shots
  fitted,  ///< least squares
  at_bound ///< least squares would go beyond the bound that it has
};

/// The origin and the uncertainty of a parameter.
template <class T> struct ParameterReport {
  ParameterOrigin origin = ParameterOrigin::held; ///< held, fitted or at its bound
  std::optional<T> standard_error;                ///< of fitted ones with more points than parameters
};

/// A curve through shots.
template <class T> struct BallisticFit {
  BallisticCurve<T> curve;        ///< the best one
  ParameterReport<T> a, p, limit; ///< of the curve's parameter of this name
  std::size_t points = 0;         ///< shots that perforated
  T rms{};                        ///< root mean square of curve minus residual velocity, m/s
};

/// The limit of a fit as a place to shoot at next, m/s: nothing without a fit, nor where the best curve is the straight
/// line of the least p, which shots far above the limit give. That of the true curve lies above where the line ends.
template <class T> std::optional<T> expected_limit(const std::optional<BallisticFit<T>> &fit) {
  if (!fit || !(fit->curve.p > T(least_ballistic_p))) return std::nullopt;
  return fit->curve.limit;
}

} // namespace ogive
