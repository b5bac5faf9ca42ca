// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <string>

/// \file
/// The range of the tests that ogive was compared with: the tables of docs/beyond.md and the figures of the paper.

namespace shot {

/// What of a case lies outside of that range, with the range, in one line; empty: nothing.
std::string outside_tested_range(const Options &o);

} // namespace shot
