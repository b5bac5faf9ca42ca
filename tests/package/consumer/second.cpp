// SPDX-License-Identifier: BSD-3-Clause
#ifdef OGIVE_TWICE
#include "everything.hpp"
#else
#include <ogive/material/library.hpp>
#endif

double speed_of_sound() { return ogive::sound_speed(ogive::library::weldox_460e_mjc<double>()); }
