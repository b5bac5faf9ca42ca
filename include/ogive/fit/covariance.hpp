// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/least_squares.hpp"

#include <cmath>

/// \file
/// Uncertainty of parameters that solve estimating equations, sum over points of g(parameters, point) = 0.

namespace ogive {

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

/// Covariance H^-1 (sum g g') H^-T, H the derivative of sum g (M-estimation: Huber 1967, White 1980), times n/(n - p)
/// for the few points of each step. `scores(x)` gives one row g' for each point.
template <class Scores>
Eigen::MatrixXd sandwich_covariance(Scores &&scores, const Eigen::VectorXd &x, const Eigen::VectorXd &scale) {
  const Eigen::MatrixXd g = scores(x);
  const auto sum = [&](const Eigen::VectorXd &y) { return Eigen::VectorXd(scores(y).colwise().sum().transpose()); };
  Eigen::MatrixXd H = central_differences(sum, x, scale) * scale.asDiagonal();
  // Equations of different units may differ by many powers of ten; the covariance does not depend on their size.
  const Eigen::VectorXd size = H.rowwise().norm().cwiseMax(1e-300).cwiseInverse();
  H = size.asDiagonal() * H;
  const Eigen::MatrixXd h = g * size.cwiseProduct(small_sample_factors(g)).asDiagonal();
  const Eigen::MatrixXd half = scale.asDiagonal() * H.fullPivLu().solve(h.transpose());
  return half * half.transpose();
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
