// SPDX-License-Identifier: BSD-3-Clause
#include "fixed.hpp"

namespace ogive {

OGIVE_PERFORATION(, instances::FixedShot, ModifiedJohnsonCook<double>, Discretisation<>)

} // namespace ogive
