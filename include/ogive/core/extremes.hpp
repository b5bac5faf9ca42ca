// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <cmath>
#include <type_traits>

/// \file
/// The smaller and the larger of two values. One that is not a number is never lost: std::min() would drop it, and with
/// it the trace of a fault.

namespace ogive {

/// Whether a value is not a number; an integer always is one.
template <class R> bool is_nan(const R &value) {
  if constexpr (std::is_floating_point_v<R>)
    return std::isnan(value);
  else
    return false;
}

/// The smaller one, or one that is not a number.
template <class R> R least(const R &a, const R &b) { return b < a || is_nan(b) ? b : a; }

/// The larger one, or one that is not a number.
template <class R> R most(const R &a, const R &b) { return b > a || is_nan(b) ? b : a; }

} // namespace ogive
