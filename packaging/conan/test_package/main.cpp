// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <ogive/ogive.hpp>

int main() {
  const auto metal = ogive::library::weldox_460e_mjc<double>();
  std::printf("ogive %s: %.1f m/s\n", ogive::version, ogive::sound_speed(metal));
}
