// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "units.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// A material card of another program, in the units of the card.

namespace cards {

/// A number of a card.
struct Number {
  std::string name;     ///< as the manual of the program calls it: "TM"
  std::string text;     ///< as number_from() reads it
  double value = 0;     ///< of the text
  std::size_t line = 0; ///< from 1
};

/// Whether the card has a number other than zero, which is how cards leave out a constant.
inline bool is_given(const std::optional<Number> &number) { return number && number->value != 0; }

/// A metal by Johnson and Cook. What is empty was not on the card.
struct Card {
  std::string format;           ///< "LS-DYNA *MAT_JOHNSON_COOK"
  std::string title{};          ///< the name on the card
  std::size_t line = 0;         ///< of the keyword
  std::optional<Units> units{}; ///< stated on the card
  std::optional<Number> density{}, young{}, shear{}, poisson{};
  std::optional<Number> A{}, B{}, n{}, C{}, m{}, melting{}, room{}, reference_rate{};
  std::optional<Number> specific_heat{};   ///< per mass
  std::optional<Number> heat_per_volume{}; ///< instead of it
  std::optional<Number> heat_fraction{};   ///< Taylor & Quinney
  std::vector<Number> damage{};            ///< D1 to D5; empty: no damage
  std::optional<Number> damage_reference_rate{};
  bool negates_D3 = false;            ///< the exponent of the failure strain is -d3 times the triaxiality
  std::vector<std::string> notes{};   ///< assumptions about the card
  std::vector<std::string> dropped{}; ///< data without a place in a material file
};

/// The material in the lines of a file. All throw SetupError with the line and what is wrong there. `file` is its name
/// in errors.
Card read_ls_dyna(std::string_view text, const std::string &file);
Card read_abaqus(std::string_view text, const std::string &file);
Card read_radioss(std::string_view text, const std::string &file);

} // namespace cards
