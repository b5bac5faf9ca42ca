// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <string>

/// \file
/// The range of the tests that ogive was compared with: the tables of docs/beyond.md and the figures of the paper.

namespace shot {

/// Options of a case outside of that range, with the range, in one line; empty: all are inside.
std::string outside_tested_range(const Options &o);

} // namespace shot
