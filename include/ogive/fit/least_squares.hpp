// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>
#include <unsupported/Eigen/LevenbergMarquardt>

#include <utility>

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

/// What Eigen's Levenberg-Marquardt asks for, in parameters of size one.
template <class Residual> struct Problem {
  using Scalar = double;
  using Index = Eigen::Index;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  using QRSolver = Eigen::ColPivHouseholderQR<JacobianType>;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  Residual &residual;
  Eigen::VectorXd scale;
  Index value_count;

  Index inputs() const { return scale.size(); }
  Index values() const { return value_count; }
  int operator()(const InputType &x, ValueType &r) const {
    r = residual(InputType(x.cwiseProduct(scale)));
    return 0;
  }
  int df(const InputType &x, JacobianType &slope) const {
    const auto scaled = [&](const InputType &y) { return Eigen::VectorXd(residual(InputType(y.cwiseProduct(scale)))); };
    slope = central_differences(scaled, x, InputType::Ones(x.size()));
    return 0;
  }
};

} // namespace least_squares_detail

/// The parameters near `start` that make the sum of squares of `residual(parameters)` smallest, by Levenberg-Marquardt
/// (Moré 1978, as Eigen has it from MINPACK). `scale` gives each parameter's size. Residuals must be at least as many
/// as parameters.
template <class Residual>
Eigen::VectorXd least_squares(Residual &&residual, const Eigen::VectorXd &start, const Eigen::VectorXd &scale) {
  const Eigen::Index values = Eigen::VectorXd(residual(start)).size();
  least_squares_detail::Problem<std::remove_reference_t<Residual>> problem{residual, scale, values};
  Eigen::LevenbergMarquardt solver(problem);
  solver.setFtol(1e-15);
  solver.setXtol(1e-13);
  solver.setMaxfev(400);
  Eigen::VectorXd x = start.cwiseQuotient(scale);
  solver.minimize(x);
  return x.cwiseProduct(scale);
}

} // namespace ogive
