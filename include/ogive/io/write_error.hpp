// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/compiler.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace ogive {

/// A file could not be written. `what()` is one line that names the file and the reason.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The error "cannot write <path>: <reason>".
inline WriteError write_error(const std::filesystem::path &path, const std::string &reason) {
  return WriteError("cannot write " + path.string() + ": " + reason);
}

} // namespace ogive
