// SPDX-License-Identifier: BSD-3-Clause
#include "fixed.hpp"

namespace ogive {

OGIVE_HEXES(, instances::PlateHexes)
OGIVE_HEXES(, instances::PlateHexesOfPoints)

} // namespace ogive
