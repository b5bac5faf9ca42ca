// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

namespace ogive {

/// The version of the library. CMakeLists.txt reads it from here.
inline constexpr char version[] = "1.0.0";

} // namespace ogive
