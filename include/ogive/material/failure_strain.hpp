// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/types.hpp"

#include <algorithm>
#include <cmath>

namespace ogive {

/// Constants of the failure strain (Liu et al. 2012, Eq. 4). The paper has no reference rate: 1/s.
template <class T> struct FailureStrain {
  T D1{}, D2{}, D3{}, D4{}, D5{}; ///< of Eq. 4, 1
  T reference_rate = T(1);        ///< 1/s, what published values of D4 are relative to
};

/// eps_f = [D1 + D2 exp(D3 triaxiality)] (rate/reference)^D4 [1 + D5 T*] (Liu et al. 2012, Eq. 4), never below 1e-6.
/// `N` is T or a pack of T.
template <class T, class N>
N failure_strain(const FailureStrain<T> &f, N triaxiality, N rate, N homologous_temperature) {
  using std::exp, std::max, std::pow;
  const N strain = (f.D1 + f.D2 * exp(f.D3 * triaxiality)) * pow(rate / f.reference_rate, f.D4) *
                   (T(1) + f.D5 * homologous_temperature);
  return max(strain, N(1e-6));
}

} // namespace ogive
