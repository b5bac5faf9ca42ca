// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/fit/ballistic_curve.hpp"
#include "ogive/fit/least_squares.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// The ballistic limit that follows from the residual velocities of shots.

namespace ogive {

namespace ballistic_limit_detail {

/// Shots that perforated. `a` is held if given, else it follows from the rest: the curve is linear in it (variable
/// projection, Golub & Pereyra 1973).
struct Points {
  Eigen::ArrayXd initial, residual;
  double lowest = std::numeric_limits<double>::infinity(); ///< initial velocity
  std::optional<double> a;
};

/// A curve by p and w, w the share of the asymptote that the slowest point has. The curve bends infinitely at the
/// limit, but is smooth in w, which expresses by 0 to 1 that the limit lies between the slowest point and 0.
struct Trial {
  double p{}, w{}, a{};
  Eigen::VectorXd error;
  double squares = std::numeric_limits<double>::infinity();
};

inline Trial tried(const Points &points, double p, double w) {
  Trial t{p, w, 0, {}, 0};
  // (limit/lowest)^p is 1 - w^p, so that 1 - (limit/v)^p is 1 - (lowest/v)^p + (lowest/v)^p w^p.
  const Eigen::ArrayXd power = (points.lowest / points.initial).pow(p);
  const Eigen::ArrayXd unit = points.initial * (1 - power + power * std::pow(w, p)).pow(1 / p);
  t.a = points.a ? *points.a : std::min((unit * points.residual).sum() / unit.square().sum(), most_ballistic_a);
  t.error = t.a * unit - points.residual;
  t.squares = t.error.squaredNorm();
  return t;
}

/// Which of p and w stay at a value; the others are free.
struct Face {
  std::optional<double> p, w;
};

/// The best curve of a face: Levenberg-Marquardt from the best of a grid, in angles whose sine keeps within bounds.
inline Trial best_of(const Points &points, const Face &face) {
  const auto at = [&](const Eigen::VectorXd &angle) {
    Eigen::Index next = 0;
    const auto share = [&] { return 0.5 * (1 + std::sin(angle[next++])); };
    const double p = face.p ? *face.p : least_ballistic_p * std::pow(most_ballistic_p / least_ballistic_p, share());
    return tried(points, p, face.w ? *face.w : share());
  };
  const Eigen::Index free = !face.p + !face.w;
  constexpr int steps = 16;
  Trial best;
  Eigen::VectorXd angle(free), start(free);
  for (int i = 0; i < (free > 0 ? steps : 1); ++i)
    for (int j = 0; j < (free > 1 ? steps : 1); ++j) {
      // Not the bounds themselves, where the sine is level and Levenberg-Marquardt would stay.
      if (free > 0) angle[0] = std::numbers::pi * ((i + 0.5) / steps - 0.5);
      if (free > 1) angle[1] = std::numbers::pi * ((j + 0.5) / steps - 0.5);
      if (Trial t = at(angle); t.squares < best.squares) best = std::move(t), start = angle;
    }
  if (free == 0) return best;
  const auto residual = [&](const Eigen::VectorXd &x) { return at(x).error; };
  return at(least_squares(residual, start, Eigen::VectorXd::Ones(free)));
}

/// The best curve within bounds, and on which of them it lies. On a bound the slope by the angle vanishes and
/// Levenberg-Marquardt slows down; what lies there is therefore searched for separately.
inline std::pair<Trial, Face> best_within_bounds(const Points &points, std::optional<double> held_p) {
  std::vector<Face> faces;
  using Choices = std::vector<std::optional<double>>;
  for (const auto &p : held_p ? Choices{held_p} : Choices{{}, least_ballistic_p, most_ballistic_p}) {
    faces.push_back({p, {}});
    // All other curves leave the limit with infinite slope: their best w is above 0.
    if (p == least_ballistic_p) faces.push_back({p, 0.0});
  }
  faces.push_back({held_p.value_or(2), 1.0}); // without a limit all p are the same
  const double round_off = points.initial.square().sum() * 1e-24;
  std::pair<Trial, Face> best;
  for (const Face &face : faces)
    if (Trial t = best_of(points, face); t.squares <= best.first.squares * (1 + 1e-9) + round_off)
      best = {std::move(t), face};
  return best;
}

/// Derivatives of the residual velocity at v by a, p and limit.
inline std::array<double, 3> slopes(const BallisticCurve<double> &c, double v) {
  const double x = c.limit / v, power = std::pow(x, c.p), kept = 1 - power;
  if (!(kept > 0)) return {};
  const double unit = v * std::pow(kept, 1 / c.p);
  const double by_p = x > 0 ? c.a * unit / c.p * (-power * std::log(x) / kept - std::log(kept) / c.p) : 0;
  return {unit, by_p, -c.a * std::pow(c.limit / unit, c.p - 1)};
}

/// Standard errors of those that were fitted: squares/(n - fitted) (J'J)^-1, J the slopes. `fitted` counts those that
/// ended on a bound, too.
template <class T>
void add_standard_errors(BallisticFit<T> &fit, const BallisticCurve<double> &c, const Points &points, double squares) {
  const std::array<ParameterReport<T> *, 3> all{&fit.a, &fit.p, &fit.limit};
  std::vector<std::size_t> inside;
  Eigen::Index asked = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    asked += all[k]->origin != ParameterOrigin::held;
    if (all[k]->origin == ParameterOrigin::fitted) inside.push_back(k);
  }
  const Eigen::Index n = points.initial.size(), columns = static_cast<Eigen::Index>(inside.size());
  if (n <= asked || columns == 0) return;
  Eigen::MatrixXd J(n, columns);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto slope = slopes(c, points.initial[i]);
    for (Eigen::Index j = 0; j < columns; ++j) J(i, j) = slope[inside[static_cast<std::size_t>(j)]];
  }
  // The parameters differ in unit and size; the rank is that of columns of length one.
  const Eigen::VectorXd length = J.colwise().norm();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J * length.cwiseInverse().asDiagonal());
  if (!J.allFinite() || !(length.minCoeff() > 0) || qr.rank() < columns) return;
  const Eigen::MatrixXd inverse = qr.solve(Eigen::MatrixXd::Identity(n, n));
  const double scatter = std::sqrt(squares / static_cast<double>(n - asked));
  for (Eigen::Index j = 0; j < columns; ++j)
    all[inside[static_cast<std::size_t>(j)]]->standard_error =
        static_cast<T>(scatter * inverse.row(j).norm() / length[j]);
}

/// The shots that perforated, as far as they make sense.
template <class T> Points perforating(std::span<const ResidualShot<T>> shots) {
  std::vector<double> initial, residual;
  for (const auto &shot : shots) {
    require(std::isfinite(shot.initial) && shot.initial > 0, "initial velocity (m/s)", shot.initial,
            "must be positive and finite");
    require(shot.residual >= 0 && shot.residual <= shot.initial, "residual velocity (m/s)", shot.residual,
            "must lie between 0 and the initial velocity");
    if (!(shot.residual > 0)) continue;
    initial.push_back(static_cast<double>(shot.initial));
    residual.push_back(static_cast<double>(shot.residual));
  }
  Points points;
  const auto n = static_cast<Eigen::Index>(initial.size());
  points.initial = Eigen::Map<const Eigen::ArrayXd>(initial.data(), n);
  points.residual = Eigen::Map<const Eigen::ArrayXd>(residual.data(), n);
  if (n > 0) points.lowest = points.initial.minCoeff();
  return points;
}

/// Number of different initial velocities.
inline std::size_t different(const Eigen::ArrayXd &values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

} // namespace ballistic_limit_detail

/// Least squares of the residual velocities of all shots that perforated; shots that were stopped are left out, and
/// without any that perforated there is nothing. The shots determine:
///
///     5 or more                a, p and limit
///     3 or 4                   a and limit, p = 2
///     2                        limit, a and p as in `start`
///     1                        limit, so that the curve goes through the shot, a and p as in `start`
///
/// where shots of the same initial velocity count as one. The limit of `start` is not used: the search begins with the
/// best of a grid.
///
/// Bounds: 0 < a <= 1.2, 1 <= p <= 8 (see there), and 0 <= limit <= the lowest velocity that perforated, as a curve
/// that stopped the projectile contradicts it. The upper one can be active only for p = 1, as all other curves leave
/// the limit with infinite slope and reach any small residual velocity just above it. The lower one is where shots keep
/// more than `a` of their velocity; p then is held, as it no longer matters. Shots that were stopped may lie above the
/// limit: compare with `bracket` of ogive/perforation/limit_search.hpp.
///
/// The standard errors take the scatter to be in residual velocities only, the same for all shots, and the curve to be
/// linear within it. The limit's is tiny if a shot perforated right above it, and leaves out that the limit itself may
/// differ from plate to plate. Few points: multiply by Student's t of points minus parameters. Throws SetupError for
/// velocities that are not finite, an initial one that is not positive, a residual one that is negative or above the
/// initial one, and for an a or p of `start` outside the bounds.
template <class T>
std::optional<BallisticFit<T>> fit_ballistic_curve(std::span<const std::type_identity_t<ResidualShot<T>>> shots,
                                                   const BallisticCurve<T> &start) {
  using namespace ballistic_limit_detail;
  require(start.a > 0 && start.a <= T(most_ballistic_a), "a to start with", start.a, "must lie between 0 and 1.2");
  require(start.p >= T(least_ballistic_p) && start.p <= T(most_ballistic_p), "p to start with", start.p,
          "must lie between 1 and 8");
  Points points = perforating<T>(shots);
  if (points.initial.size() == 0) return std::nullopt;

  const std::size_t count = different(points.initial);
  if (count < 3) points.a = static_cast<double>(start.a);
  std::optional<double> held_p;
  if (count < 5) held_p = count < 3 ? static_cast<double>(start.p) : 2.0;
  Trial best;
  Face face;
  if (points.initial.size() > 1) {
    std::tie(best, face) = best_within_bounds(points, held_p);
  } else {
    const double w = points.residual[0] / (*points.a * points.lowest);
    if (!(w < 1)) face.w = 1;
    best = tried(points, *held_p, std::min(w, 1.0));
  }

  using enum ParameterOrigin;
  const double limit = points.lowest * std::pow(1 - std::pow(best.w, best.p), 1 / best.p);
  const BallisticCurve<double> curve{best.a, best.p, limit};
  BallisticFit<T> fit;
  fit.curve = {static_cast<T>(best.a), static_cast<T>(best.p), static_cast<T>(limit)};
  if (!points.a) fit.a.origin = best.a < most_ballistic_a ? fitted : at_bound;
  if (!held_p && face.w != 1.0) fit.p.origin = face.p ? at_bound : fitted;
  // A shot with next to nothing left may have a limit that is the same number.
  fit.limit.origin = face.w || !(fit.curve.limit < static_cast<T>(points.lowest)) ? at_bound : fitted;
  fit.points = static_cast<std::size_t>(points.initial.size());
  fit.rms = static_cast<T>(std::sqrt(best.squares / static_cast<double>(fit.points)));
  add_standard_errors(fit, curve, points, best.squares);
  return fit;
}

} // namespace ogive
