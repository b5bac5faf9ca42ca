// SPDX-License-Identifier: BSD-3-Clause
#include "instances.hpp"

namespace ogive {

OGIVE_HEXES(, instances::AnyHexes)

} // namespace ogive
