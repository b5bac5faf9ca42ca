#include "shoot.hpp"

namespace perforate {

Shot shoot_mjc(const Options &o) {
  switch (o.material) {
  case PlateMaterial::weldox_460e:
    return shoot_metal(o, ogive::library::weldox_460e_mjc<double>());
  case PlateMaterial::aa5083_h116:
    return shoot_metal(o, ogive::library::aa5083_h116_mjc<double>());
  case PlateMaterial::aa5083_h116_25mm:
    return shoot_metal(o, ogive::library::aa5083_h116_mjc<double>(0.85));
  }
  throw ogive::SetupError("--material: unknown");
}

} // namespace perforate
