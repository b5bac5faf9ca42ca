// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cards/card.hpp"
#include "materials/material_file.hpp"

#include <filesystem>

/// \file
/// Material cards of other programs as metals: LS-DYNA *MAT_JOHNSON_COOK (015), Abaqus *PLASTIC, HARDENING=JOHNSON COOK
/// with rate and damage initiation, OpenRadioss /MAT/LAW2 with /FAIL/JOHNSON.

namespace cards {

/// A metal from a card.
struct Imported {
  materials::AnyMetal metal;
  std::vector<std::string> notes;   ///< units, signs and what was taken for granted, a line for each
  std::vector<std::string> dropped; ///< data of the card without a place in a material file
};

/// The metal on a card. Without `units` they are those that the card states, or those in which its density is that of a
/// metal. `name` is that of the metal, the card's own if it is empty, else that of the file. Throws SetupError, one
/// line with file, line and reason.
Imported import_card(std::string_view text, const std::string &file, const std::optional<Units> &units,
                     const std::string &name = "");

/// The card in a file of at most 1 MiB. Throws SetupError.
Imported import_card(const std::filesystem::path &file, const std::optional<Units> &units,
                     const std::string &name = "");

} // namespace cards
