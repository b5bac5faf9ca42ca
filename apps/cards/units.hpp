// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/given.hpp"

/// \file
/// The systems of units that cards come in. Every unit is a power of ten of that of the SI.

namespace cards {

/// Powers of ten of the units of mass, length and time, in kg, m and s.
struct Units {
  int mass = 0, length = 0, time = 0;

  bool operator==(const Units &) const = default;
};

constexpr int power_of_density(Units u) { return u.mass - 3 * u.length; }
constexpr int power_of_stress(Units u) { return u.mass - u.length - 2 * u.time; }
constexpr int power_of_rate(Units u) { return -u.time; }
constexpr int power_of_specific_heat(Units u) { return 2 * u.length - 2 * u.time; }

inline constexpr auto all_units = options::named<Units>({{{0, 0, 0}, "SI"},
                                                         {{3, -3, 0}, "mm-tonne-s"},
                                                         {{-3, -3, -3}, "mm-g-ms"},
                                                         {{0, -3, -3}, "mm-kg-ms"},
                                                         {{-3, -2, -6}, "cm-g-us"}});

/// "mm-tonne-s", or powers of ten of a system without a name.
std::string name_of(Units units);

/// The system of units in which a density is that of a metal: 1000 to 25000 kg/m3. None if there is no such system.
std::optional<Units> units_of_density(double density);

/// Units by their names, as in "Mg", "mm", "s"; nothing if one is not known.
std::optional<Units> units_named(std::string_view mass, std::string_view length, std::string_view time);

} // namespace cards
