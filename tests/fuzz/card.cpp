// SPDX-License-Identifier: BSD-3-Clause
#include "cards/import.hpp"

#include "fuzz/must.hpp"
#include "fuzz/targets.hpp"

#include "ogive/core/error.hpp"

#include <string>

/// A material card; a metal that is imported is a material file that reads back as the same.
void fuzz::try_card(std::string_view bytes) {
  std::string text;
  try {
    text = materials::to_toml(cards::import_card(bytes, "card", std::nullopt).metal, "");
  } catch (const ogive::SetupError &) {
    return;
  }
  must(materials::to_toml(materials::parse(text, "material.toml"), "") == text,
       "an imported metal reads back as the same");
}
