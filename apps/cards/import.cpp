// SPDX-License-Identifier: BSD-3-Clause
#include "import.hpp"

#include "card_text.hpp"
#include "options/toml_file.hpp"

#include <cmath>

namespace cards {

namespace {

using Metal = ogive::Metal<double, ogive::JohnsonCook<double>>;
using options::shortest;

/// The number in SI units, without rounding in between.
double si(const Number &number, int power) { return *options::number_from(number.text, power); }

/// A constant that must be there.
const Number &needed(const std::optional<Number> &number, const char *what, const Card &card, const std::string &file) {
  if (!is_given(number)) refuse_line(file, card.line, card.format + " lacks " + what);
  return *number;
}

/// Reads the card in whichever format its keywords are.
Card read_card(std::string_view text, const std::string &file) {
  std::string first;
  for (const Line &line : lines_of(text, "$")) {
    const std::string keyword = squeezed(line.text);
    if (keyword.starts_with("*MAT_JOHNSON_COOK") || keyword.starts_with("*MAT_015") || keyword.starts_with("*MAT_15"))
      return read_ls_dyna(text, file);
    if (keyword.starts_with("*PLASTIC") && keyword.find("HARDENING=JOHNSONCOOK") != std::string::npos)
      return read_abaqus(text, file);
    if (keyword.starts_with("/MAT/LAW2/") || keyword.starts_with("/MAT/PLAS_JOHNS")) return read_radioss(text, file);
    const bool is_material =
        keyword.starts_with("*MAT") || keyword.starts_with("*PLASTIC") || keyword.starts_with("/MAT/");
    if (first.empty() && is_material)
      first = ":" + std::to_string(line.number) + ": " + options::printable(keyword) + " cannot be imported;";
  }
  throw ogive::SetupError(
      options::printable(file) + (first.empty() ? ":" : first) +
      " must have a material *MAT_JOHNSON_COOK (LS-DYNA), *PLASTIC, HARDENING=JOHNSON COOK (Abaqus) "
      "or /MAT/LAW2 (OpenRadioss)");
}

/// The units of a card.
Units units_of(const Card &card, const std::optional<Units> &asked, Imported &all, const std::string &file) {
  const Number &density = needed(card.density, "a density", card, file);
  const Number &stiffness = is_given(card.young) ? *card.young : needed(card.shear, "Young's modulus", card, file);
  const auto of_density = units_of_density(density.value);
  const std::string names = options::names_in(all_units);
  const std::string with = "density " + density.text + " and modulus " + stiffness.text;
  const auto check = [&](Units units, const std::string &how) {
    const double modulus_GPa = si(stiffness, power_of_stress(units) - 9);
    if (!(modulus_GPa >= 1 && modulus_GPa <= 1000) || of_density != units)
      refuse_line(file, density.line,
                  "units " + how + " " + name_of(units) + " do not fit: " + with + " are " +
                      shortest(si(density, power_of_density(units))) + " kg/m3 and " + shortest(modulus_GPa) +
                      " GPa with them; --units must be one of " + names);
    return units;
  };
  if (asked) return check(*asked, "given as");
  if (card.units) {
    all.notes.push_back("units: " + name_of(*card.units) + ", stated on the card");
    return check(*card.units, "stated as");
  }
  if (!of_density)
    refuse_line(file, density.line, "units cannot be guessed from " + with + "; --units must be one of " + names);
  const Units units = check(*of_density, "guessed as");
  all.notes.push_back("units: " + name_of(units) + ", guessed from " + with);
  return units;
}

/// Young's modulus and Poisson's ratio, of which a card may have one and the shear modulus.
ogive::Elasticity<double> elasticity_of(const Card &card, Units units, Imported &all, const std::string &file) {
  const int power = power_of_stress(units);
  if (is_given(card.young) && is_given(card.poisson)) return {si(*card.young, power), card.poisson->value};
  const Number &shear = needed(card.shear, "two of Young's modulus, Poisson's ratio and the shear modulus", card, file);
  const double G = si(shear, power);
  all.notes.push_back("elastic constants: from " + text_of(shear, "") + " and the other one");
  if (is_given(card.young)) return {si(*card.young, power), si(*card.young, power) / (2 * G) - 1};
  const double poisson = needed(card.poisson, "Poisson's ratio", card, file).value;
  return {2 * G * (1 + poisson), poisson};
}

/// Room and melting temperature, K.
void set_temperatures(Metal &m, const Card &card, Imported &all) {
  constexpr double zero_celsius = 273.15, warmest_celsius = 150, hottest = 1e4;
  const bool melts = is_given(card.melting) && card.melting->value < hottest;
  // Two zeros are how cards leave the temperatures out.
  const bool has_room = card.room && (melts || is_given(card.room));
  const bool in_celsius = has_room && card.room->value > -100 && card.room->value < warmest_celsius;
  const double shift = in_celsius ? zero_celsius : 0;
  if (has_room) m.room_temperature = card.room->value + shift;
  if (melts) m.melting_temperature = card.melting->value + shift;
  if (in_celsius)
    all.notes.push_back("temperatures: in degrees Celsius, because of " + text_of(*card.room, "") +
                        "; 273.15 was added");
  if (!has_room) all.notes.emplace_back("room temperature: 293 K, the card has none");
  if (melts) return;
  m.melting_temperature = hottest, m.flow.m = 1;
  all.notes.emplace_back("melting temperature: the card has none below 10000; the temperature has no effect");
}

void set_heat(Metal &m, const Card &card, Units units, Imported &all) {
  if (is_given(card.specific_heat)) m.specific_heat = si(*card.specific_heat, power_of_specific_heat(units));
  if (is_given(card.heat_per_volume)) m.specific_heat = si(*card.heat_per_volume, power_of_stress(units)) / m.density;
  if (card.heat_fraction) m.taylor_quinney = card.heat_fraction->value;
  if (m.specific_heat == 0) all.notes.emplace_back("specific heat: the card has none; plastic work does not heat");
}

void set_flow(Metal &m, const Card &card, Units units, Imported &all, const std::string &file) {
  const auto value = [](const std::optional<Number> &number, double otherwise) {
    return is_given(number) ? number->value : otherwise;
  };
  m.flow.A = si(needed(card.A, "the yield stress A", card, file), power_of_stress(units));
  m.flow.n = 1;
  if (is_given(card.B)) {
    m.flow.B = si(*card.B, power_of_stress(units));
    m.flow.n = needed(card.n, "the exponent n of the hardening B", card, file).value;
  }
  m.flow.C = value(card.C, 0), m.flow.m = value(card.m, 1);
  if (!is_given(card.m) && is_given(card.melting)) all.notes.emplace_back("m: 1, the card has none");
  if (m.flow.C == 0) {
    all.notes.emplace_back("rate: C is zero, the flow stress has no effect of it");
    return;
  }
  m.flow.reference_rate = si(needed(card.reference_rate, "the reference rate of C", card, file), power_of_rate(units));
}

void set_damage(Metal &m, const Card &card, Units units, Imported &all, const std::string &file) {
  const bool has_damage =
      std::any_of(card.damage.begin(), card.damage.end(), [](const Number &d) { return d.value != 0; });
  if (!has_damage) {
    all.notes.emplace_back("damage: the card has none");
    return;
  }
  auto &f = m.damage.failure_strain;
  f.D1 = card.damage[0].value, f.D2 = card.damage[1].value, f.D4 = card.damage[3].value, f.D5 = card.damage[4].value;
  f.D3 = card.negates_D3 ? -card.damage[2].value : card.damage[2].value;
  f.rate_term = ogive::FailureRateTerm::logarithmic;
  if (f.D4 != 0)
    f.reference_rate =
        si(needed(card.damage_reference_rate, "the reference rate of D4", card, file), power_of_rate(units));
  all.notes.push_back(
      card.negates_D3
          ? "D3: " + shortest(f.D3) + ", the card's d3 = " + card.damage[2].text + " is that of exp(-d3 triaxiality)"
          : "D3: " + shortest(f.D3) + " as on the card, of exp(D3 triaxiality), triaxiality positive in tension");
  all.notes.emplace_back("D4: that of 1 + D4 ln(rate/reference)");
}

/// The metal as a file would give it, with all checks of one.
materials::AnyMetal checked(const Metal &metal, const Card &card, const std::string &file) {
  try {
    return materials::parse(materials::to_toml(metal, ""), "the metal");
  } catch (const ogive::SetupError &error) {
    refuse_line(file, card.line, card.format + ": " + error.what());
  }
}

} // namespace

Imported import_card(std::string_view text, const std::string &file, const std::optional<Units> &asked,
                     const std::string &name) {
  const Card card = read_card(text, file);
  if (card.line == 0) throw ogive::SetupError(options::printable(file) + ": has no complete material " + card.format);
  Imported all;
  const Units units = units_of(card, asked, all, file);
  Metal m;
  m.name = title_of(!name.empty()         ? name
                    : !card.title.empty() ? card.title
                                          : std::filesystem::path(file).stem().string());
  if (m.name.empty()) m.name = "imported metal";
  m.density = si(*card.density, power_of_density(units));
  m.elasticity = elasticity_of(card, units, all, file);
  set_flow(m, card, units, all, file);
  set_temperatures(m, card, all);
  set_heat(m, card, units, all);
  set_damage(m, card, units, all, file);
  all.notes.insert(all.notes.end(), card.notes.begin(), card.notes.end());
  m.source = "imported from " + title_of(std::filesystem::path(file).filename().string()) + ", " + card.format +
             ", line " + std::to_string(card.line);
  m.confidence = "unknown: that of the card";
  all.metal = checked(m, card, file);
  constexpr std::size_t most = 12;
  const std::size_t count = card.dropped.size();
  all.dropped.assign(card.dropped.begin(), card.dropped.begin() + static_cast<std::ptrdiff_t>(std::min(count, most)));
  if (count > most) all.dropped.push_back("and " + std::to_string(count - most) + " more");
  return all;
}

Imported import_card(const std::filesystem::path &file, const std::optional<Units> &units, const std::string &name) {
  return import_card(options::text_of_file(file, "card", "text"), file.string(), units, name);
}

} // namespace cards
