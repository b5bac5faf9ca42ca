// SPDX-License-Identifier: BSD-3-Clause
#include "history.hpp"

#include "options/text.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/csv_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace draw {

History read_history(const std::filesystem::path &file) {
  const std::string name = file.string();
  const auto text = options::text_in(file);
  if (!text) throw ogive::SetupError(name + ": must be a file that can be read");
  History all;
  std::size_t time = 0, velocity = 0;
  bool header = true;
  ogive::for_each_csv_row(*text, name, 1000, [&](const ogive::CsvRow &row) {
    const auto column = [&](const char *wanted) {
      const auto found = std::find(row.fields.begin(), row.fields.end(), wanted);
      if (found == row.fields.end()) throw ogive::SetupError(name + ": column " + wanted + " is missing");
      return static_cast<std::size_t>(found - row.fields.begin());
    };
    if (std::exchange(header, false)) {
      time = column("time_us"), velocity = column("velocity_m_per_s");
      return;
    }
    const auto number = [&](std::size_t k) {
      const auto value = k < row.fields.size() ? ogive::number_from(row.fields[k]) : std::nullopt;
      if (!value || !std::isfinite(*value))
        throw ogive::SetupError(ogive::place(name, row.line) + ": time and velocity must be numbers");
      return *value;
    };
    all.time_us.push_back(number(time)), all.velocity_mps.push_back(number(velocity));
  });
  return all;
}

std::optional<double> velocity_at(const History &history, double time_us) {
  const auto &times = history.time_us, &velocities = history.velocity_mps;
  if (times.empty()) return std::nullopt;
  const auto after = std::lower_bound(times.begin(), times.end(), time_us);
  if (after == times.begin()) return velocities.front();
  if (after == times.end()) return velocities.back();
  const auto k = static_cast<std::size_t>(after - times.begin());
  return std::lerp(velocities[k - 1], velocities[k], (time_us - times[k - 1]) / (times[k] - times[k - 1]));
}

} // namespace draw
