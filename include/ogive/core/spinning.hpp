// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <cstdlib>
#include <unistd.h>

namespace ogive {

/// Makes OpenMP's threads wait briefly in a busy loop and then sleep. Threads that spin longer slow each other down
/// four- to eightfold as soon as the machine has other work. GCC's OpenMP reads that from the environment when a
/// program is loaded, so this sets GOMP_SPINCOUNT and starts the program once more (Linux), unless the user has chosen
/// already. To be called first in main(), with the arguments of main().
inline void limit_spinning(char **argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  ::setenv("GOMP_SPINCOUNT", "3000", 1);
  ::execv("/proc/self/exe", argv); // returns only where that fails; the program is then merely slower
}

} // namespace ogive
