// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

/// \file
/// Titles of pictures of a shot.

namespace shot {

/// The case of a summary.json in the names of the field: "Weldox 460 E, modified Johnson-Cook, blunt nose, 12 mm, 303.5
/// m/s, method stabilised". Throws nlohmann::json::exception if a key is missing.
std::string title_of(const nlohmann::ordered_json &summary);

} // namespace shot
