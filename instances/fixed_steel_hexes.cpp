// SPDX-License-Identifier: BSD-3-Clause
#include "fixed.hpp"

namespace ogive {

OGIVE_HEXES(, instances::SteelHexes)
OGIVE_HEXES(, instances::SteelHexesOfPoints)

} // namespace ogive
