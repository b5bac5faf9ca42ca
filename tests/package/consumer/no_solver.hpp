// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ogive/fit/least_squares.hpp>

/// \file
/// Leaves out the solver of the fits, two thirds of the compile: nothing here fits.

namespace ogive {

extern template Eigen::VectorXd least_squares_detail::minimised(const least_squares_detail::Function<Eigen::VectorXd> &,
                                                                const Eigen::VectorXd &, const Eigen::VectorXd &);
extern template Eigen::MatrixXd least_squares_detail::sandwich(Eigen::MatrixXd, const Eigen::MatrixXd &,
                                                               const Eigen::VectorXd &);

} // namespace ogive
