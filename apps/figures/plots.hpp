// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "campaign.hpp"

/// \file
/// The curves of the figures, drawn by gnuplot as SVG and PNG.

namespace figures {

/// Draws a figure from all rows and limits into `out` as figure_<number>.svg and .png; its points go to
/// plot_data/figure_<number>_*.csv. A figure of which no shot is known is left out; says whether it was drawn. Throws
/// WriteError.
bool draw_plot(const Plot &plot, const std::vector<SeriesKey> &series, const std::vector<ShotRow> &rows,
               const std::vector<LimitRow> &limits, const std::filesystem::path &data,
               const std::filesystem::path &out);

} // namespace figures
