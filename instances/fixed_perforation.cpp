// SPDX-License-Identifier: BSD-3-Clause
#include "fixed.hpp"

namespace ogive {

OGIVE_PERFORATION(, instances::FixedShot, ModifiedJohnsonCook<double>, Bilinear<double>, Discretisation<>)

} // namespace ogive
