// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// \file
/// Catch2 3 or 2, whichever is installed.

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
