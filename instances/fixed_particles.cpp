// SPDX-License-Identifier: BSD-3-Clause
#include "fixed.hpp"

namespace ogive {

OGIVE_PARTICLES(, instances::SteelParticles)
OGIVE_PARTICLES(, instances::PlateParticles)

} // namespace ogive
