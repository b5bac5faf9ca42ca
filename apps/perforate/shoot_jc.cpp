#include "shoot.hpp"

namespace perforate {

Shot shoot_jc(const Options &o) {
  return o.material == PlateMaterial::weldox_460e ? shoot_metal(o, ogive::library::weldox_460e_jc<double>())
                                                  : shoot_metal(o, ogive::library::aa5083_h116_jc<double>());
}

} // namespace perforate
