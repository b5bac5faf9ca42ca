// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limits.hpp"

/// \file
/// The curves of a study, drawn by gnuplot as SVG and PNG; their points are in <out>/plot_data.

namespace study {

/// A picture: its title, and the name of its files without an ending.
struct Plot {
  std::string name;
  std::string title;
};

/// Residual against initial velocity, a panel for each plate and nose, with the tests where there are any and, where
/// `with_fit`, the curve that fits each series. False if no shot is known. Throws WriteError.
bool draw_residuals(const Plot &plot, const std::vector<Series> &series, const std::vector<Row> &rows,
                    const Texts &own_columns, const std::filesystem::path &out, bool with_fit = false);

/// Limits against thickness, or against the first other number that varies, each with a bar over what lies between the
/// shots that bracket it, as measured ones have. False if no limit is known. Throws WriteError.
bool draw_limits(const Plot &plot, const std::vector<LimitRow> &limits, const Texts &own_columns,
                 const std::filesystem::path &out);

} // namespace study
