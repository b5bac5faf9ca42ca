// SPDX-License-Identifier: BSD-3-Clause
#include "units.hpp"

#include <cmath>

namespace cards {

namespace {

/// A name and a power of ten.
struct Unit {
  std::string_view name;
  int power = 0;
};

constexpr auto masses = std::to_array<Unit>({{"kg", 0}, {"g", -3}, {"Mg", 3}, {"t", 3}, {"ton", 3}, {"tonne", 3}});
constexpr auto lengths = std::to_array<Unit>({{"m", 0}, {"mm", -3}, {"cm", -2}});
constexpr auto times = std::to_array<Unit>({{"s", 0}, {"ms", -3}, {"mus", -6}, {"us", -6}});

template <class List> std::optional<int> power_of(const List &list, std::string_view name) {
  for (const Unit &unit : list)
    if (unit.name == name) return unit.power;
  return {};
}

} // namespace

std::string name_of(Units units) {
  const std::string name = options::name_in(all_units, units);
  return name.empty() ? "units of 10^" + std::to_string(units.mass) + " kg, 10^" + std::to_string(units.length) +
                            " m, 10^" + std::to_string(units.time) + " s"
                      : name;
}

std::optional<Units> units_of_density(double density) {
  for (const auto &units : all_units) {
    const double metal = density * std::pow(10, power_of_density(units.value));
    if (metal >= 1000 && metal <= 25000) return units.value;
  }
  return {};
}

std::optional<Units> units_named(std::string_view mass, std::string_view length, std::string_view time) {
  const auto m = power_of(masses, mass), l = power_of(lengths, length), t = power_of(times, time);
  if (!m || !l || !t) return {};
  return Units{*m, *l, *t};
}

} // namespace cards
