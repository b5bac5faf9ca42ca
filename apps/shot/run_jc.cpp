// SPDX-License-Identifier: BSD-3-Clause
#include "run_model.hpp"

namespace shot {

Result run_model(const Options &options, const std::vector<ogive::Metal<double, ogive::JohnsonCook<double>>> &plates) {
  return run_metals(options, plates);
}

} // namespace shot
