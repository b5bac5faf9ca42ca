// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace options {

/// The known name that a mistyped one is nearest to: fewest letters changed, added, dropped or swapped with a
/// neighbour. Empty if more than a third of the letters differ.
std::string nearest(std::string_view name, const std::vector<std::string> &known);

/// ", the nearest is <name>", or empty.
std::string nearest_text(std::string_view name, const std::vector<std::string> &known);

} // namespace options
