// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/text.hpp"
#include "ogive/material/metal.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

/// \file
/// Constants that are legal and yet give wrong results without an error: a line for each.

namespace ogive {

namespace doubts_detail {

inline std::string text(double value) { return with_digits(value, 3); }

/// Plastic strain at which the work of plastic flow at 10000 1/s has heated the metal to its melting point, if that is
/// below 1. The flow stress of room temperature is an upper bound of the work.
template <class T, class Law> std::optional<T> strain_to_melting(const Metal<T, Law> &m) {
  if (!(m.specific_heat > T(0))) return {};
  constexpr T step = T(0.01);
  T temperature = m.room_temperature;
  for (T strain = T(0); strain < T(1); strain += step) {
    if (temperature >= m.melting_temperature) return strain;
    temperature += m.taylor_quinney * step / (m.density * m.specific_heat) *
                   flow_stress(m, strain + step / T(2), T(1e4), m.room_temperature).value;
  }
  return {};
}

} // namespace doubts_detail

/// The doubts about constants of the failure strain that are legal, a line for each: no metal is known that gets
/// more ductile with tension, fails at its first plastic strain, or with its melting point near.
template <class T> std::vector<std::string> doubts_of(const FailureStrain<T> &f) {
  using doubts_detail::text;
  std::vector<std::string> doubts;
  const auto at = [&](T triaxiality) { return f.D1 + f.D2 * std::exp(f.D3 * triaxiality); };
  if (f.D2 * f.D3 > T(0))
    doubts.push_back("the failure strain rises with tension, from " + text(at(T(0))) + " at triaxiality 0 to " +
                     text(at(T(2))) + " at 2 (D3 = " + text(f.D3) +
                     "): constants for a pressure that is positive in compression have D3 with the other sign");
  // From bars in compression to the centre of deep necks. The failure strain is monotonic: one range at most is below.
  constexpr int last = 300;
  const auto triaxiality = [](int k) { return T(-1) + T(0.01) * T(k); };
  int below = 0, first = -1;
  for (int k = 0; k <= last; ++k)
    if (!(at(triaxiality(k)) > T(0))) first = below++ == 0 ? k : first;
  if (below > 0)
    doubts.push_back("the failure strain is below zero from triaxiality " + text(triaxiality(first)) +
                     (first + below <= last ? " to " + text(triaxiality(first + below - 1)) : " on") +
                     " (D1 = " + text(f.D1) + ", D2 = " + text(f.D2) + ", D3 = " + text(f.D3) +
                     "): points fail there at their first plastic strain");
  if (f.D5 <= T(-1))
    doubts.push_back("the failure strain falls to zero below the melting point (D5 = " + text(f.D5) + ")");
  const bool is_power = f.rate_term == FailureRateTerm::power;
  const T decades = T(1e4) / f.reference_rate;
  const T factor = decades <= T(1) ? T(1) : is_power ? std::pow(decades, f.D4) : T(1) + f.D4 * std::log(decades);
  if (!(factor > T(0.1) && factor < T(10)))
    doubts.push_back("the failure strain at 10000 1/s is " + text(factor) + " times that at the reference rate, " +
                     text(f.reference_rate) + " 1/s (D4 = " + text(f.D4) + "): " +
                     (is_power ? "D4 is taken as a power, some sets mean 1 + D4 ln(rate)"
                               : "D4 is taken as 1 + D4 ln(rate), some sets mean a power"));
  if (f.D4 != T(0) && f.reference_rate > T(100))
    doubts.push_back("the rate has no effect on the failure strain below its reference rate, " +
                     text(f.reference_rate) + " 1/s: a shot also has slower flow");
  return doubts;
}

/// The doubts about a metal's flow stress and temperatures, a line for each.
template <class T, class Law> std::vector<std::string> doubts_of_flow(const Metal<T, Law> &m) {
  using doubts_detail::text;
  std::vector<std::string> doubts;
  const auto stress = [&](T strain, T rate) { return flow_stress(m, strain, rate, m.room_temperature).value; };

  constexpr int steps = 200; // to a plastic strain of 2
  int peak = 0;
  for (int k = 1; k <= steps; ++k)
    if (stress(T(0.01) * T(k), m.rate_floor) >= stress(T(0.01) * T(peak), m.rate_floor)) peak = k;
  const T top = stress(T(0.01) * T(peak), m.rate_floor), end = stress(T(2), m.rate_floor);
  if (end < top * T(0.999))
    doubts.push_back("hardening falls beyond a plastic strain of " + text(T(0.01) * T(peak)) + ", from " +
                     text(top / T(1e6)) + " to " + text(end / T(1e6)) + " MPa at 2: flow gathers in single bands");

  const T strain = T(0.1), slow = stress(strain, m.rate_floor), fast = stress(strain, T(1e4));
  if (fast < slow * T(0.999))
    doubts.push_back("the flow stress falls with the rate, to " + text(fast / slow) +
                     " of its slow value at 10000 1/s: C is negative, as in few alloys of aluminium");
  const T fastest = stress(strain, T(1e6));
  if (m.rate_floor < T(100) && fastest != slow && stress(strain, T(100)) == slow)
    doubts.emplace_back(
        "the rate has no effect on the flow stress up to 100 1/s and has one beyond: its reference rate "
        "is above the rates of much of a shot");

  if (const auto molten = doubts_detail::strain_to_melting(m))
    doubts.push_back("its own heat melts it at a plastic strain of " + text(*molten) + " (melting_temperature " +
                     text(m.melting_temperature) + " K, specific heat " + text(m.specific_heat) +
                     " J/(kg K)): shots reach that strain; degrees Celsius are often taken for kelvin");
  return doubts;
}

} // namespace ogive
