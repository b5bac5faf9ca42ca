// SPDX-License-Identifier: BSD-3-Clause
#include "shoot.hpp"

namespace perforate {

Shot shoot(const Options &options, const std::vector<ogive::Metal<double, ogive::JohnsonCook<double>>> &plates) {
  return shoot_metals(options, plates);
}

} // namespace perforate
