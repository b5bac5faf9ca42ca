// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/bilinear.hpp"
#include "ogive/material/johnson_cook.hpp"
#include "ogive/material/power_law.hpp"
#include "ogive/material/voce.hpp"

#include <variant>

namespace ogive {

/// The flow laws of the programs, of plates and projectiles, chosen when the program runs.
template <class T>
using AnyFlowLaw = std::variant<ModifiedJohnsonCook<T>, JohnsonCook<T>, Voce<T>, PowerLaw<T>, Bilinear<T>>;

} // namespace ogive
