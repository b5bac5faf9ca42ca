#include "shoot.hpp"

namespace perforate {

Shot shoot(const Options &options, const ogive::Metal<double, ogive::JohnsonCook<double>> &plate) {
  return shoot_metal(options, plate);
}

} // namespace perforate
