// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <utility>

/// \file
/// Uncertainty of parameters that solve estimating equations, sum over points of g(parameters, point) = 0.

namespace ogive {

/// Derivative of the vector function `f` at `x` by central differences, with steps of 1e-6 of `scale`.
template <class F> Eigen::MatrixXd central_differences(F &&f, const Eigen::VectorXd &x, const Eigen::VectorXd &scale) {
  Eigen::MatrixXd slope;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double step = 1e-6 * scale[j];
    Eigen::VectorXd up = x, down = x;
    up[j] += step;
    down[j] -= step;
    const Eigen::VectorXd column = (f(up) - f(down)) / (up[j] - down[j]);
    if (j == 0) slope.resize(column.size(), x.size());
    slope.col(j) = column;
  }
  return slope;
}

namespace least_squares_detail {

/// A vector function of parameters, of whatever type: what is made of Eigen is compiled once for all of them.
template <class Vector> using Function = std::function<Vector(const Vector &)>;

/// The functor that Eigen's Levenberg-Marquardt needs, in parameters of size one.
template <class Vector> struct Problem {
  using Scalar = typename Vector::Scalar;
  using Index = Eigen::Index;
  using InputType = Vector;
  using ValueType = Vector;
  using JacobianType = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using QRSolver = Eigen::ColPivHouseholderQR<JacobianType>;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const Function<Vector> &residual;
  Vector scale;
  Index value_count;

  Index inputs() const { return scale.size(); }
  Index values() const { return value_count; }
  int operator()(const InputType &x, ValueType &r) const {
    r = residual(InputType(x.cwiseProduct(scale)));
    return 0;
  }
  int df(const InputType &x, JacobianType &slope) const {
    const auto scaled = [&](const InputType &y) { return residual(InputType(y.cwiseProduct(scale))); };
    slope = central_differences(scaled, x, InputType::Ones(x.size()));
    return 0;
  }
};

/// least_squares() of a function.
template <class Vector> Vector minimised(const Function<Vector> &residual, const Vector &start, const Vector &scale) {
  Problem<Vector> problem{residual, scale, residual(start).size()};
  Eigen::LevenbergMarquardt solver(problem);
  solver.setFtol(1e-15);
  solver.setXtol(1e-13);
  solver.setMaxfev(400);
  Vector x = start.cwiseQuotient(scale);
  solver.minimize(x);
  return x.cwiseProduct(scale);
}

} // namespace least_squares_detail

/// The parameters near `start` that make the sum of squares of `residual(parameters)` smallest, by Levenberg-Marquardt
/// (Moré 1978, as Eigen has it from MINPACK). `scale` gives each parameter's size. Residuals must be at least as many
/// as parameters.
template <class Residual>
Eigen::VectorXd least_squares(Residual &&residual, const Eigen::VectorXd &start, const Eigen::VectorXd &scale) {
  return least_squares_detail::minimised<Eigen::VectorXd>(
      [&](const Eigen::VectorXd &x) { return Eigen::VectorXd(residual(x)); }, start, scale);
}

/// Factors sqrt(n/(n - p)) for each equation: n the points that it uses, p the equations that use the same
/// ones.
inline Eigen::VectorXd small_sample_factors(const Eigen::MatrixXd &scores) {
  const auto seen = (scores.array() != 0).eval();
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(scores.cols());
  for (Eigen::Index j = 0; j < scores.cols(); ++j) {
    double p = 0;
    for (Eigen::Index k = 0; k < scores.cols(); ++k) p += (seen.col(k) == seen.col(j)).all();
    const auto n = static_cast<double>(seen.col(j).count());
    if (n > p) factor[j] = std::sqrt(n / (n - p));
  }
  return factor;
}

namespace least_squares_detail {

/// H^-1 (sum g g') H^-T with the rows g' and the factors for few points; parameters of the size `scale`, by which H is
/// multiplied already.
template <class Matrix> Matrix sandwich(Matrix H, const Matrix &g, const Eigen::VectorXd &scale) {
  // Equations of different units may differ by many powers of ten; the covariance does not depend on their size.
  const Eigen::VectorXd size = H.rowwise().norm().cwiseMax(1e-300).cwiseInverse();
  H = size.asDiagonal() * H;
  const Matrix h = g * size.cwiseProduct(small_sample_factors(g)).asDiagonal();
  const Matrix half = scale.asDiagonal() * H.fullPivLu().solve(h.transpose());
  return half * half.transpose();
}

} // namespace least_squares_detail

/// Covariance H^-1 (sum g g') H^-T, H the derivative of sum g (M-estimation: Huber 1967, White 1980), times n/(n - p)
/// for the few points of each step. `scores(x)` gives one row g' for each point.
template <class Scores>
Eigen::MatrixXd sandwich_covariance(Scores &&scores, const Eigen::VectorXd &x, const Eigen::VectorXd &scale) {
  const Eigen::MatrixXd g = scores(x);
  const auto sum = [&](const Eigen::VectorXd &y) { return Eigen::VectorXd(scores(y).colwise().sum().transpose()); };
  const Eigen::MatrixXd H = central_differences(sum, x, scale) * scale.asDiagonal();
  return least_squares_detail::sandwich<Eigen::MatrixXd>(H, g, scale);
}

/// Covariance of the function `f` of parameters with this covariance, to first order (delta method).
template <class F>
Eigen::MatrixXd propagated(F &&f, const Eigen::VectorXd &x, const Eigen::VectorXd &scale,
                           const Eigen::MatrixXd &covariance) {
  const Eigen::MatrixXd J = central_differences(f, x, scale);
  return J * covariance * J.transpose();
}

/// Square roots of the diagonal.
inline Eigen::VectorXd standard_errors(const Eigen::MatrixXd &covariance) {
  return covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

/// Correlations; a value without error (one that was given) is correlated with itself only.
inline Eigen::MatrixXd correlation(const Eigen::MatrixXd &covariance) {
  const Eigen::VectorXd error = standard_errors(covariance);
  Eigen::MatrixXd r = Eigen::MatrixXd::Identity(error.size(), error.size());
  for (Eigen::Index i = 0; i < r.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (error[i] > 0 && error[j] > 0)
        r(i, j) = r(j, i) = 0.5 * (covariance(i, j) + covariance(j, i)) / (error[i] * error[j]);
  return r;
}

} // namespace ogive
