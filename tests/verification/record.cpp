// SPDX-License-Identifier: BSD-3-Clause
#include "record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace verification {

namespace {

std::string formatted(const char *format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void add(Rung &rung, const std::string &what, const std::string &theory, const std::string &computed,
         const std::string &error, const std::string &bound, bool ok) {
  rung.lines.push_back({{what, theory, computed, error, bound}, ok});
}

/// Characters, not bytes: the page has Greek letters and superscripts.
std::size_t width_of(const std::string &text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

} // namespace

std::string number(double value) { return formatted("%.6g", value); }
std::string roughly(double value) { return formatted("%.2g", value); }

void compare(Rung &rung, const std::string &what, double theory, double computed, double bound) {
  const double error = computed / theory - 1;
  add(rung, what, number(theory), number(computed), roughly(error), roughly(bound), std::abs(error) <= bound);
}

void vanishes(Rung &rung, const std::string &what, double computed, double bound) {
  add(rung, what, "0", roughly(computed), "", roughly(bound), std::abs(computed) <= bound);
}

void lies_between(Rung &rung, const std::string &what, double computed, double low, double high) {
  add(rung, what, number(low) + " to " + number(high), number(computed), "", "", computed >= low && computed <= high);
}

void converges(Rung &rung, const std::string &what, double theory, const std::vector<double> &errors, double least) {
  std::string computed;
  double order = 0;
  for (std::size_t k = 1; k < errors.size(); ++k) {
    order = std::log2(std::abs(errors[k - 1] / errors[k]));
    computed += (k == 1 ? "" : ", ") + formatted("%.2f", order);
  }
  add(rung, what, roughly(theory), computed, "", "≥ " + roughly(least), order >= least);
}

std::string markdown(const Rung &rung) {
  std::vector<std::vector<std::string>> rows{rung.titles};
  rows.front().emplace_back("");
  for (const Line &line : rung.lines) {
    rows.push_back(line.cells);
    rows.back().emplace_back(line.ok ? "ok" : "OFF");
  }
  std::vector<std::size_t> width(rows.front().size(), 3);
  for (const auto &row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], width_of(row[c]));
  const std::string mark = "<!-- table: " + rung.name + " (tests/verification.sh) -->\n";
  std::string text = mark;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < width.size(); ++c) {
      const std::string blanks(width[c] - width_of(rows[r][c]), ' ');
      text += (c == 0 ? "| " : " | ") + (c == 0 ? rows[r][c] + blanks : blanks + rows[r][c]);
    }
    text += " |\n";
    if (r > 0) continue;
    for (std::size_t c = 0; c < width.size(); ++c)
      text += (c == 0 ? "| " : " | ") + (c == 0 ? std::string(width[c], '-') : std::string(width[c] - 1, '-') + ":");
    text += " |\n";
  }
  return text + mark;
}

} // namespace verification
