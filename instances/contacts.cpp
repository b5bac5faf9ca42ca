// SPDX-License-Identifier: BSD-3-Clause
#include "instances.hpp"

namespace ogive {

OGIVE_CONTACTS()

} // namespace ogive
