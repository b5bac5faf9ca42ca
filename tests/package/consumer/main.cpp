// SPDX-License-Identifier: BSD-3-Clause
#ifndef OGIVE_SOLVER
#include "no_solver.hpp"
#endif

#include "everything.hpp"

#include <cstdio>

double speed_of_sound();

int main() {
  const double here = ogive::sound_speed(ogive::library::weldox_460e_mjc<double>());
  std::printf("ogive %s, %.1f m/s\n", ogive::version, here);
  return here == speed_of_sound() ? 0 : 1;
}
