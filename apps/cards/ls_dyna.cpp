// SPDX-License-Identifier: BSD-3-Clause
#include "card_text.hpp"

namespace cards {

namespace {

/// A field of the card, and what it is where a material file has no place for it.
struct Field {
  const char *name;
  const char *dropped = nullptr;
};

/// The cards of *MAT_JOHNSON_COOK (LS-DYNA manual, volume II).
constexpr auto rows =
    std::to_array<std::array<Field, 8>>({{{{"MID", ""},
                                           {"RO"},
                                           {"G"},
                                           {"E"},
                                           {"PR"},
                                           {"DTF", "smallest time step of an element"},
                                           {"VP", "how the rate is taken; ogive takes that of the plastic strain"},
                                           {"RATEOP"}}},
                                         {{{"A"}, {"B"}, {"N"}, {"C"}, {"M"}, {"TM"}, {"TR"}, {"EPS0"}}},
                                         {{{"CP"},
                                           {"PC", "cut-off of the pressure"},
                                           {"SPALL", "kind of spall"},
                                           {"IT", "iterations"},
                                           {"D1"},
                                           {"D2"},
                                           {"D3"},
                                           {"D4"}}},
                                         {{{"D5"},
                                           {"C2/P/XNP", "of other rate factors"},
                                           {"EROD", "what a failed element does; ogive has --failure"},
                                           {"EFMIN", "smallest failure strain; ogive has 1e-6"},
                                           {"NUMINT", "failed points of an element"},
                                           {"K", "of other rate factors"},
                                           {"EPS1", "of other rate factors"},
                                           {"", ""}}}});

/// The material's keyword: its number, or its name.
bool is_johnson_cook(const std::string &keyword) {
  for (const char *name : {"*MAT_JOHNSON_COOK", "*MAT_015", "*MAT_15"})
    for (const char *ending : {"", "_TITLE"})
      if (keyword == std::string(name) + ending) return true;
  return false;
}

/// The fields of a line: with commas, or in columns.
std::vector<std::string> fields_of(const Line &line, std::size_t width, const std::string &file) {
  return line.text.find(',') != std::string::npos ? options::split(line.text, ',') : columns_of(line, {width}, file);
}

} // namespace

Card read_ls_dyna(std::string_view text, const std::string &file) {
  const auto lines = lines_of(text, "$");
  Card card{.format = "LS-DYNA *MAT_JOHNSON_COOK"};
  std::vector<std::optional<Number>> numbers(rows.size() * rows[0].size());
  const auto number = [&](std::string_view name) -> const std::optional<Number> & {
    std::size_t k = 0;
    while (rows[k / 8][k % 8].name != name) ++k;
    return numbers[k];
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].text.starts_with('*')) continue;
    std::string keyword = squeezed(lines[i].text);
    const bool is_long = keyword.ends_with('+');
    if (is_long || keyword.ends_with('-')) keyword.pop_back();
    if (!is_johnson_cook(keyword)) {
      if (keyword != "*KEYWORD" && keyword != "*END")
        card.dropped.push_back(options::printable(keyword) + " (line " + std::to_string(lines[i].number) + ")");
      continue;
    }
    if (card.line > 0)
      refuse_line(file, lines[i].number,
                  "is a second material of this kind, the first is in line " + std::to_string(card.line) +
                      "; keep one of them");
    card.line = lines[i].number;
    std::size_t next = i + 1;
    const auto has_data = [&] { return next < lines.size() && !lines[next].text.starts_with('*'); };
    if (keyword.ends_with("_TITLE") && has_data()) card.title = title_of(lines[next++].text);
    std::size_t row = 0;
    for (; row < rows.size() && has_data(); ++row, ++next) {
      const auto fields = fields_of(lines[next], is_long ? 20 : 10, file);
      for (std::size_t k = 0; k < std::min<std::size_t>(8, fields.size()); ++k) {
        const Field field = rows[row][k];
        if (field.dropped != nullptr && *field.dropped == 0) continue;
        numbers[8 * row + k] = number_in(fields[k], field.name, file, lines[next].number);
        if (field.dropped != nullptr && is_given(numbers[8 * row + k]))
          card.dropped.push_back(text_of(*numbers[8 * row + k], field.dropped));
      }
    }
    if (row < 2) refuse_line(file, card.line, "has " + std::to_string(row) + " of its cards, at least 2 are needed");
    if (row < 4) card.notes.push_back("cards " + std::to_string(row + 1) + " to 4 are missing and taken for zeros");
    if (has_data()) refuse_line(file, lines[next].number, "is a line too many: the material has 4 cards");
    i = next - 1;
  }
  if (is_given(number("RATEOP")))
    refuse_line(file, number("RATEOP")->line,
                "RATEOP = " + number("RATEOP")->text + ": must be 0, other rate factors cannot be imported");
  card.density = number("RO"), card.young = number("E"), card.shear = number("G"), card.poisson = number("PR");
  card.A = number("A"), card.B = number("B"), card.n = number("N"), card.C = number("C"), card.m = number("M");
  card.melting = number("TM"), card.room = is_given(number("TR")) ? number("TR") : std::nullopt,
  card.reference_rate = number("EPS0");
  card.specific_heat = number("CP"), card.damage_reference_rate = card.reference_rate;
  for (const char *name : {"D1", "D2", "D3", "D4", "D5"})
    card.damage.push_back(number(name).value_or(Number{name, "0", 0, card.line}));
  return card;
}

} // namespace cards
