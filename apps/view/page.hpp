// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "draw/history.hpp"

#include "ogive/io/read_frame.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// A result as one HTML file that a browser opens from disk: the frames in three dimensions, with the time.

namespace view {

/// The history in a history.csv, of at most 400 rows at even distances. Throws SetupError as draw::read_history().
draw::History read_velocity(const std::filesystem::path &history);

/// Contents of a page.
struct Result {
  std::string title;
  ogive::StoredSeries series;
  std::optional<ogive::SymmetryPlanes> symmetry; ///< of files that do not hold it
  std::vector<std::string> fields;               ///< empty: those of default_fields() that all parts have
  int most_frames = 20;                          ///< of a longer series some are left out, at even distances
  draw::History velocity;                        ///< may be empty
};

/// The default fields of a page.
const std::vector<std::string> &default_fields();

/// The HTML of a result. `three` is the folder of three.js, with three.min.js and
/// examples/js/controls/OrbitControls.js. Throws SetupError if frames or three.js cannot be read.
std::string page(const Result &result, const std::filesystem::path &three);

} // namespace view
