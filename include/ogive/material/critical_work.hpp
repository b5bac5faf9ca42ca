// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/metal.hpp"

namespace ogive {

/// W_cr (Pa) with which Cockcroft & Latham's criterion fails a smooth bar in slow tension (triaxiality 1/3, at room
/// temperature and the metal's smallest rate) at the plastic strain at which the metal's Johnson-Cook failure strain
/// does: the integral of the flow stress up to there. For metals of which only D1 to D5 are published.
template <class T, class Law> T critical_work_of_tension(const Metal<T, Law> &metal) {
  const T end = failure_strain(metal.damage.failure_strain, T(1) / T(3), metal.rate_floor, T(0));
  // In s = sqrt(eps/end) the integrand is smooth where hardening starts steeply; the midpoint rule is good to 1e-6.
  constexpr int intervals = 1000;
  T work{};
  for (int k = 0; k < intervals; ++k) {
    const T s = (T(k) + T(0.5)) / T(intervals);
    work +=
        T(2) * s * end / T(intervals) * flow_stress(metal, s * s * end, metal.rate_floor, metal.room_temperature).value;
  }
  return work;
}

} // namespace ogive
