// SPDX-License-Identifier: BSD-3-Clause
#include "instances.hpp"

namespace ogive {

OGIVE_PERFORATION(, instances::AnyShot, instances::AnyLaw, instances::AnyLaw, AnyDiscretisation)

} // namespace ogive
