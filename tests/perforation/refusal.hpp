// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"

#include <string>

/// What `set_up()` is refused with; "accepted" if it is not.
template <class F> std::string refusal_of(F &&set_up) {
  try {
    set_up();
  } catch (const ogive::SetupError &error) {
    return error.what();
  }
  return "accepted";
}
