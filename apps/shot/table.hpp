// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "options/table.hpp"

/// \file
/// The table of the options of a shot, and the names of their choices.

namespace ogive {

/// The choices of the library's enumerations, found by their namespace.
inline auto choices(Nose) {
  std::array<options::Choice<Nose>, all_noses.size()> noses;
  std::transform(all_noses.begin(), all_noses.end(), noses.begin(), [](Nose nose) {
    return options::Choice<Nose>{nose, name(nose)};
  });
  return noses;
}
constexpr auto choices(Extent) {
  return options::named<Extent>({{Extent::quarter, "quarter"}, {Extent::half, "half"}, {Extent::full, "full"}});
}
constexpr auto choices(Parts) { return options::named<Parts>({{Parts::tied, "tied"}, {Parts::touching, "touching"}}); }
constexpr auto choices(Lattice) {
  return options::named<Lattice>({{Lattice::cubic, "cubic"}, {Lattice::ring, "ring"}});
}
constexpr auto choices(PressureLaw) {
  return options::named<PressureLaw>({{PressureLaw::linear, "linear"}, {PressureLaw::mie_gruneisen, "mie_gruneisen"}});
}
constexpr auto choices(Method) {
  return options::named<Method>({{Method::paper, "paper"}, {Method::stabilised, "stabilised"}});
}
constexpr auto choices(DamageLaw) {
  return options::named<DamageLaw>(
      {{DamageLaw::none, "none"}, {DamageLaw::johnson_cook, "jc"}, {DamageLaw::cockcroft_latham, "cockcroft_latham"}});
}
constexpr auto choices(DamagePressure) {
  return options::named<DamagePressure>({{DamagePressure::own, "own"}, {DamagePressure::neighbours, "neighbours"}});
}
constexpr auto choices(FailureEffect) {
  return options::named<FailureEffect>(
      {{FailureEffect::none, "none"}, {FailureEffect::no_tension, "no_tension"}, {FailureEffect::removal, "removal"}});
}

} // namespace ogive

namespace shot {

constexpr auto choices(SphForm) {
  return options::named<SphForm>({{SphForm::renormalised, "renormalised"}, {SphForm::standard, "standard"}});
}
constexpr auto choices(SphKernel) {
  return options::named<SphKernel>(
      {{SphKernel::cubic_spline, "cubic_spline"}, {SphKernel::wendland_c2, "wendland_c2"}});
}
constexpr auto choices(MeshUnit) {
  return options::named<MeshUnit>(
      {{MeshUnit::mm, "mm"}, {MeshUnit::cm, "cm"}, {MeshUnit::m, "m"}, {MeshUnit::inch, "inch"}});
}
constexpr auto choices(Smoothing) {
  return options::named<Smoothing>({{Smoothing::constant, "constant"}, {Smoothing::variable, "variable"}});
}
constexpr auto choices(ElementRule) {
  return options::named<ElementRule>(
      {{ElementRule::one_point, "one_point"}, {ElementRule::selective_reduced, "selective_reduced"}});
}

/// Name of a choice, as the user writes it.
template <class E> std::string name_of(E value) { return options::name_in(choices(value), value); }

/// Refuses the value of a key, with where it was given. Throws SetupError.
template <class V>
[[noreturn]] void refuse_value(const options::Origins &origins, const char *key, const V &value,
                               const std::string &allowed) {
  std::string text;
  if constexpr (std::is_enum_v<V>)
    text = name_of(value);
  else if constexpr (std::is_arithmetic_v<V>)
    text = options::shortest(static_cast<double>(value));
  else
    text = options::joined(value, ",");
  options::refuse(options::origin_of(origins, key), text, allowed);
}

/// Group of the options that do not change the case.
inline constexpr char run_group[] = "Run and output";

/// The options of a shot, bound to `o`, in the order of the help.
options::Table table_of(Options &o);

/// A line of TOML that would be right, for errors.
inline constexpr char toml_example[] = "thickness_mm = 12.0";

} // namespace shot
