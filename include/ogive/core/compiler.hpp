// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// Demands of the library on a compiler. Every header includes this one before all others, so that one sentence comes
/// instead of the many errors that would follow.

#if (defined(_MSVC_LANG) && _MSVC_LANG < 202002L) || (!defined(_MSVC_LANG) && __cplusplus < 202002L)
#error "ogive needs C++20: compile with -std=c++20 (MSVC: /std:c++20)."
// Compilers read on after an error of this kind; none does after a file that is missing.
#include "ogive_needs_cpp20"
#endif

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ == 1
#error "ogive tests for numbers that are not finite: compile without -ffast-math and -Ofast."
#endif
