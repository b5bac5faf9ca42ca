// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/pack.hpp"
#include "ogive/version.hpp"

#include <string>

namespace verification {

/// Version, compiler and width of packs, on which the last bits of a result depend.
inline std::string made_with() {
#if defined(__clang__)
  const std::string compiler = "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
  const std::string compiler = "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
  return "ogive " + std::string(ogive::version) + ", " + compiler + ", " + std::to_string(ogive::lanes<double>) +
         " doubles in a pack";
}

} // namespace verification
