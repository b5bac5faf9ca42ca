// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/frame.hpp"

#include <optional>
#include <string>
#include <vector>

/// \file
/// What pictures take from a frame besides its parts: the projectile's velocity, the time, and how much there is to
/// see.

namespace draw {

/// Mean velocity of the projectile in the direction of flight, weighted by mass, m/s. Nothing if the frame lacks what
/// it takes.
std::optional<double> projectile_velocity(const ogive::Frame &frame);

/// "40 µs, 151 m/s", without the velocity where the frame does not give it.
std::string time_text(const ogive::Frame &frame);

/// What is seen of a section, mm; z = 0 is the plate's front face.
struct SeenBox {
  double low_mm = -20;   ///< lowest z
  double high_mm = 22;   ///< highest z
  double radius_mm = 28; ///< farthest x on either side
};

/// The box down to 4 mm below the projectile and the plug of the frame, and that of `box`.
SeenBox extended(SeenBox box, const ogive::Frame &frame);

/// Numbers of the frames that are shown: all of them, or `most` from the first to the last, at even distances.
std::vector<std::size_t> shown_frames(std::size_t frames, int most);

} // namespace draw
