// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frame_facts.hpp"
#include "section.hpp"

#include "ogive/io/read_frame.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// \file
/// Films: the frames of a series one after the other, all at the same scale and with the same colours. ffmpeg encodes
/// them.

namespace draw {

/// The endings of films.
inline constexpr std::array film_endings{"mp4", "webm", "gif", "apng"};

/// Allowed names of a film, for errors; completes "must be".
inline constexpr char film_names[] = "the name of a .mp4, .webm, .gif or .apng file";

/// True if the name of a file has one of the endings.
bool is_film(const std::filesystem::path &path);

/// True if ffmpeg can be run.
bool ffmpeg_available();

/// View, symmetry and speed of a film.
struct Film {
  SectionPanel panel{.width = 1000, .height = 1000, .font_size = 26, .compression = 1}; ///< of a single cell
  Seen from = Seen::section;                                                            ///< direction of view
  bool fits = true;                                ///< down to the lowest part of all frames, whatever the panel
  Motion motion{};                                 ///< for the labels
  std::optional<ogive::SymmetryPlanes> symmetry{}; ///< of files that do not hold it
  int most_frames = 50;                            ///< of a longer series some are left out, at even distances
  double frames_per_second = 8;                    ///< the last frame stays for a second more
};

/// Draws a film, with the time and, where it is known, the velocity below the picture. Throws ogive::SetupError as
/// render_panel() does or if a frame cannot be read, ogive::WriteError if ffmpeg is missing, fails or takes more than
/// ten minutes, or the file cannot be written; an old one stays then.
void render_film(const ogive::StoredSeries &series, const Film &film, const std::filesystem::path &path);

} // namespace draw
