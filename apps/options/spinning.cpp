// SPDX-License-Identifier: BSD-3-Clause
#include "spinning.hpp"

#include <cstdlib>
#include <unistd.h>

namespace options {

void limit_spinning(char **argv) {
  if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  ::setenv("GOMP_SPINCOUNT", "3000", 1);
  ::execv("/proc/self/exe", argv); // returns only where that fails; the program is then merely slower
}

} // namespace options
