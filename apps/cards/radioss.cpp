// SPDX-License-Identifier: BSD-3-Clause
#include "card_text.hpp"

namespace cards {

namespace {

/// A keyword with its lines of data.
struct Block {
  std::vector<std::string> keyword; ///< "MAT", "LAW2", "1"
  std::string text;                 ///< "/MAT/LAW2/1"
  std::size_t line = 0;
  std::vector<Line> data;
};

std::vector<Block> blocks_of(std::string_view text) {
  std::vector<Block> all;
  for (const Line &line : lines_of(text, "#"))
    if (line.text.starts_with('/')) {
      const std::string keyword = squeezed(line.text);
      all.push_back({options::split(keyword.substr(1), '/'), keyword, line.number, {}});
    } else if (!all.empty()) {
      all.back().data.push_back(line);
    }
  return all;
}

std::string part(const Block &block, std::size_t k) { return k < block.keyword.size() ? block.keyword[k] : ""; }

bool is_law_2(const Block &b) { return part(b, 0) == "MAT" && (part(b, 1) == "LAW2" || part(b, 1) == "PLAS_JOHNS"); }

/// The units of a line such as "Mg mm s", which a block /UNIT or /BEGIN has.
std::optional<Units> units_in(const Block &block) {
  for (const Line &line : block.data) {
    std::vector<std::string> words = options::split(line.text, ' ');
    std::erase(words, "");
    if (words.size() >= 3)
      if (const auto units = units_named(words[0], words[1], words[2])) return units;
  }
  return {};
}

/// Contents of a line of a block: real numbers in 20 columns, whole ones in 10.
struct Row {
  std::vector<std::string> names;
  std::vector<std::size_t> widths;
};

/// The numbers of line `k` of a block, as many as the row has.
std::vector<std::optional<Number>> numbers_in(const Block &block, std::size_t k, const Row &row,
                                              const std::string &file) {
  if (k >= block.data.size())
    refuse_line(file, block.line, block.text + ": ends before the line of " + options::joined(row.names));
  std::vector<std::optional<Number>> numbers(row.names.size());
  const auto fields = columns_of(block.data[k], row.widths, file);
  for (std::size_t i = 0; i < std::min(fields.size(), row.names.size()); ++i)
    numbers[i] = number_in(fields[i], row.names[i], file, block.data[k].number);
  return numbers;
}

/// Lists those of the numbers that are given as dropped.
void drop(Card &card, const std::vector<std::optional<Number>> &numbers, std::size_t from,
          const std::vector<std::string> &meanings) {
  for (std::size_t k = 0; k < meanings.size() && from + k < numbers.size(); ++k)
    if (is_given(numbers[from + k])) card.dropped.push_back(text_of(*numbers[from + k], meanings[k]));
}

void read_material(const Block &b, Card &card, const std::string &file) {
  if (!b.data.empty()) card.title = title_of(b.data.front().text);
  const auto density = numbers_in(b, 1, {{"RHO_I", "RHO_0"}, {20}}, file);
  const auto elastic = numbers_in(b, 2, {{"E", "Nu", "Iflag"}, {20, 20, 10}}, file);
  if (is_given(elastic[2]))
    refuse_line(file, elastic[2]->line,
                "Iflag = " + elastic[2]->text +
                    ": must be 0; for yield stress and strength there is \"ogive materials from-tensile\"");
  const auto hardening = numbers_in(b, 3, {{"a", "b", "n", "EPS_p_max", "SIG_max0"}, {20}}, file);
  const auto rate =
      numbers_in(b, 4, {{"c", "EPS_DOT_0", "ICC", "Fsmooth", "F_cut", "Chard"}, {20, 20, 10, 10, 20, 20}}, file);
  const auto heat = numbers_in(b, 5, {{"m", "T_melt", "rhoC_p", "T_r"}, {20}}, file);
  if (b.data.size() > 6) refuse_line(file, b.data[6].number, "is a line too many: the material has 6");
  card.density = density[0], card.young = elastic[0], card.poisson = elastic[1];
  card.A = hardening[0], card.B = hardening[1], card.n = hardening[2];
  card.C = rate[0], card.reference_rate = rate[1];
  card.m = heat[0], card.melting = heat[1], card.heat_per_volume = heat[2],
  card.room = is_given(heat[3]) ? heat[3] : std::nullopt;
  drop(card, density, 1, {"reference density"});
  drop(card, hardening, 3, {"plastic strain of failure", "largest flow stress"});
  drop(card, rate, 2,
       {"rate effect on the largest flow stress", "smoothing of the rate", "smoothing of the rate",
        "kinematic hardening"});
}

void read_failure(const Block &b, Card &card, const std::string &file) {
  const Row constants{{"D1", "D2", "D3", "D4", "D5"}, {20}};
  const auto numbers = numbers_in(b, 0, constants, file);
  card.damage.clear();
  for (std::size_t k = 0; k < 5; ++k)
    card.damage.push_back(numbers[k].value_or(Number{constants.names[k], "0", 0, b.line}));
  const auto rate = numbers_in(b, 1, {{"EPSILON_0", "Ifail_sh", "Ifail_so"}, {20, 10, 10}}, file);
  card.damage_reference_rate = rate[0];
  drop(card, rate, 1, {"what a failed shell does", "what a failed solid does; ogive has --failure"});
}

} // namespace

Card read_radioss(std::string_view text, const std::string &file) {
  Card card{.format = "OpenRadioss /MAT/LAW2"};
  const auto blocks = blocks_of(text);
  std::string id, unit_id;
  for (const Block &b : blocks)
    if (is_law_2(b)) {
      if (card.line > 0)
        refuse_line(file, b.line,
                    "is a second material of this kind, the first is in line " + std::to_string(card.line) +
                        "; keep one of them");
      card.line = b.line, id = part(b, 2), unit_id = part(b, 3);
      read_material(b, card, file);
    }
  for (const Block &b : blocks) {
    const bool is_failure = part(b, 0) == "FAIL" && part(b, 1) == "JOHNSON" && part(b, 2) == id;
    if (is_failure)
      read_failure(b, card, file);
    else if (part(b, 0) == "BEGIN" && unit_id.empty())
      card.units = units_in(b);
    else if (part(b, 0) == "UNIT" && part(b, 1) == unit_id)
      card.units = units_in(b);
    else if (!is_law_2(b) && part(b, 0) != "END")
      card.dropped.push_back(options::printable(b.text) + " (line " + std::to_string(b.line) + ")");
  }
  return card;
}

} // namespace cards
