// SPDX-License-Identifier: BSD-3-Clause
#include "everything.hpp"

double speed_of_sound() { return ogive::sound_speed(ogive::library::weldox_460e_mjc<double>()); }
