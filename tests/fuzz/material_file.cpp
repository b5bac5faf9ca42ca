// SPDX-License-Identifier: BSD-3-Clause
#include "materials/material_file.hpp"

#include "fuzz/must.hpp"
#include "fuzz/targets.hpp"

#include "ogive/core/error.hpp"

#include <string>

/// A material file; one that is read is written and read again.
void fuzz::try_material_file(std::string_view bytes) {
  std::string text;
  try {
    text = materials::to_toml(materials::parse(bytes, "material.toml"), "");
  } catch (const ogive::SetupError &) {
    return;
  }
  must(materials::to_toml(materials::parse(text, "material.toml"), "") == text,
       "a metal that was written reads back as the same");
}
