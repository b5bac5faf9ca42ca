// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/fit/curve_table.hpp"

#include "fuzz/targets.hpp"

/// A table of test curves, true and engineering ones, up to what a fit takes.
void fuzz::try_curve_table(std::string_view bytes) {
  for (const bool engineering : {false, true}) try {
      std::vector<std::string> messages;
      const ogive::CurveTableFormat format{engineering, 200e9, 1800};
      auto curves = ogive::read_curves({{"curves.csv", bytes}}, format, messages);
      ogive::SeriesSettings settings;
      settings.melting = format.melting;
      settings.heat_per_work = 0.9 / (7850 * 452);
      ogive::used_points(ogive::sorted_series(std::move(curves), settings));
    } catch (const ogive::SetupError &) {
    }
}
