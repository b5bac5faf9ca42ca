// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

/// \file
/// Signals that end a program, for all programs.

namespace input {

/// Signals that come within this time of the first are the same order, told to the whole group of processes and by a
/// parent, as `timeout` and batch systems do; one that comes later insists.
inline constexpr std::chrono::milliseconds one_order{1000};

} // namespace input
