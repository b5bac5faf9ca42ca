// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ogive {

/// Wrong input found while a model is set up. `what()` is one line that names the thing, the value and what is allowed.
struct SetupError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A stream that writes numbers alike in every locale that the program may have chosen.
inline std::ostringstream text_stream() {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  return stream;
}

/// Throws a SetupError "<thing> = <value>: <allowed>" unless `ok`.
template <class Value> void require(bool ok, std::string_view thing, const Value &value, std::string_view allowed) {
  if (ok) return;
  auto line = text_stream();
  line << thing << " = " << value << ": " << allowed;
  throw SetupError(line.str());
}

} // namespace ogive
