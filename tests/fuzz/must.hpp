// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// Ends the program, as a crash does, unless `ok`.
inline void must(bool ok, const char *what) {
  if (ok) return;
  std::fprintf(stderr, "must hold: %s\n", what);
  std::abort();
}

} // namespace fuzz
