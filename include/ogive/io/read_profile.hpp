// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/csv_rows.hpp"
#include "ogive/mesh/profile.hpp"

#include <string>
#include <string_view>

namespace ogive {

/// The profile in a CSV text with the columns z_mm and r_mm, distance from the front and radius, a row for each point
/// from the front to the rear. z counts from the first point. Throws SetupError, one line with `name` and the line, for
/// anything else and for a profile that is no body, see check().
inline Profile<double> read_profile(std::string_view text, const std::string &name) {
  Profile<double> profile;
  bool has_header = false;
  for_each_csv_row(text, name, 2, [&](const CsvRow &row) {
    const auto refuse = [&](const std::string &what) { throw SetupError(place(name, row.line) + ": " + what); };
    if (!has_header) {
      if (row.fields != std::vector<std::string>{"z_mm", "r_mm"}) refuse("columns: must be z_mm,r_mm");
      has_header = true;
      return;
    }
    if (row.fields.size() != 2) refuse("fields in the row: must be 2, z_mm and r_mm");
    if (profile.size() == most_profile_points)
      refuse("points of the profile: must be at most " + std::to_string(most_profile_points));
    double values[2];
    for (int k = 0; k < 2; ++k) {
      const auto number = number_from(row.fields[k]);
      if (!number || !std::isfinite(*number))
        refuse((k == 0 ? "z_mm = " : "r_mm = ") + printable(row.fields[k]) + ": must be a number");
      values[k] = *number;
    }
    if (!profile.empty() && !(values[0] * 1e-3 > profile.back().z))
      refuse("z_mm = " + shortest(values[0]) + ": must be larger than in the row before");
    if (!(values[1] > 0)) refuse("r_mm = " + shortest(values[1]) + ": must be positive; hexes need a flat at the tip");
    profile.push_back({values[0] * 1e-3, values[1] * 1e-3});
  });
  try {
    check(profile);
  } catch (const SetupError &error) {
    throw SetupError(printable(name) + ": " + error.what());
  }
  const double first = profile.front().z;
  for (auto &point : profile) point.z -= first;
  return profile;
}

} // namespace ogive
