// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/material/any_flow_law.hpp"
#include "ogive/material/metal.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// \file
/// A metal in a flat TOML file, every constant with its unit in the key (the table is in material_keys.hpp).

namespace materials {

/// The flow laws that a file can have: modified and classical Johnson-Cook; with the factors of the classical law Voce
/// hardening and the power law of the total strain; and bilinear hardening, which is that of the projectiles' steels.
enum class Model { mjc, jc, voce, power_law, bilinear };

/// A metal with any of these laws, in the order of Model.
using AnyMetal =
    std::variant<ogive::Metal<double, ogive::ModifiedJohnsonCook<double>>,
                 ogive::Metal<double, ogive::JohnsonCook<double>>, ogive::Metal<double, ogive::Voce<double>>,
                 ogive::Metal<double, ogive::PowerLaw<double>>, ogive::Metal<double, ogive::Bilinear<double>>>;

/// The metal in a file. Damage is disabled whatever its constants: the run chooses. Throws SetupError, one line:
/// all keys that are missing or superfluous, or file, line, key, value and what is allowed; "<what> = <file>: ..." if
/// the file cannot be read or is larger than 1 MiB.
AnyMetal read(const std::filesystem::path &file, const std::string &what = "material");

/// The metal in the text of a file, as read(); `file` is its name in errors. Throws SetupError.
AnyMetal parse(std::string_view text, const std::string &file);

/// A file that reads back as the same metal, to the last bit, with a comment (of any number of lines) on top. Damage
/// and equation of state are written as constants, not what is chosen of them.
std::string to_toml(const AnyMetal &metal, const std::string &comment);

/// Warnings about the flow stress of a metal, and about its constants of damage if it has them, see
/// ogive::doubts_of_flow() and ogive::doubts_of(): a line for each, with the metal's name.
std::vector<std::string> doubts_of_flow(const AnyMetal &metal);
std::vector<std::string> doubts_of_damage(const AnyMetal &metal);

/// The flow law of a metal.
Model model_of(const AnyMetal &metal);

/// The name of a flow law in a file and on the command line.
std::string name_of(Model model);

/// The name of a flow law in titles, by its name in a file: of "mjc" it is "modified Johnson-Cook". An unknown name is
/// its own title.
std::string title_of_model(std::string_view name);

/// The name of the metal.
const std::string &name_of(const AnyMetal &metal);

} // namespace materials
