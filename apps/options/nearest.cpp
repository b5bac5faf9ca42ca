// SPDX-License-Identifier: BSD-3-Clause
#include "nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace options {

namespace {

/// Letters changed, added, dropped or swapped with a neighbour (Damerau 1964, optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(last, row);
  }
  return last.back();
}

} // namespace

std::string nearest(std::string_view name, const std::vector<std::string> &known) {
  constexpr std::size_t longest = 100;
  if (name.size() > longest) return "";
  std::string best;
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string &one : known)
    // A name that only lacks its end, such as a unit, is meant too.
    if (const std::size_t d = name.size() > 3 && one.starts_with(name) ? 1 : distance(name, one); d < fewest) {
      fewest = d;
      best = one;
    }
  return best;
}

std::string nearest_text(std::string_view name, const std::vector<std::string> &known) {
  const std::string found = nearest(name, known);
  return found.empty() ? "" : ", the nearest is " + found;
}

} // namespace options
