// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/fit/ballistic_limit.hpp"

/// \file
/// What fits are made of, compiled in the library ogive_instances. To be included where something is fitted; not part
/// of the precompiled header.

#define OGIVE_FITS(extern_)                                                                                            \
  extern_ template Eigen::VectorXd least_squares_detail::minimised(                                                    \
      const least_squares_detail::Function<Eigen::VectorXd> &, const Eigen::VectorXd &, const Eigen::VectorXd &);      \
  extern_ template Eigen::MatrixXd least_squares_detail::sandwich(Eigen::MatrixXd, const Eigen::MatrixXd &,            \
                                                                  const Eigen::VectorXd &);                            \
  extern_ template std::optional<BallisticFit<double>> fit_ballistic_curve(                                            \
      std::span<const std::type_identity_t<ResidualShot<double>>>, const BallisticCurve<double> &);

namespace ogive {

OGIVE_FITS(extern)

} // namespace ogive
