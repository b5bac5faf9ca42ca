// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material_file.hpp"

#include "ogive/fit/tensile_numbers.hpp"

#include <optional>

/// \file
/// A metal from the numbers of a mill certificate and another metal of its kind.

namespace materials {

/// The numbers of a mill certificate.
struct Certificate {
  ogive::TensileNumbers numbers;
  std::optional<double> elongation{};         ///< at fracture, engineering strain
  std::optional<double> uniform_elongation{}; ///< at the largest force, engineering strain
  std::optional<double> reduction_of_area{};  ///< at fracture, 0 to 1
};

/// A metal with notes and warnings, a line for each.
struct CertifiedMetal {
  AnyMetal metal;
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// The metal of the library that an unnamed one with this Young's modulus (Pa) is taken to be like: a steel, or an
/// alloy of aluminium. Empty if it is neither.
std::string kind_of(double young);

/// The metal of a certificate with the power law, or with Voce's law (then with `uniform_elongation`). What a
/// certificate lacks is that of the metal of the library `like`: density, Poisson's ratio, heat, temperatures,
/// effects of rate and temperature. It has no constants of damage but W_cr, and that with a reduction of area alone.
/// Throws SetupError.
CertifiedMetal metal_of(const Certificate &certificate, Model law, const std::string &like, const std::string &name);

} // namespace materials
