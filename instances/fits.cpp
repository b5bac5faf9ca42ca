// SPDX-License-Identifier: BSD-3-Clause
#include "fits.hpp"

namespace ogive {

OGIVE_FITS()

} // namespace ogive
