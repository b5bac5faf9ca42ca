// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "history.hpp"

#include "ogive/io/frame.hpp"

#include <string>
#include <vector>

/// \file
/// Labels of frames with time and velocity, the visible box of a section, and the frames that are shown.

namespace draw {

/// The motion of a shot's projectile, for labels.
struct Motion {
  History history{};  ///< empty: the velocity is not known
  std::string part{}; ///< the part that the velocity is of; empty: the whole projectile
};

/// Label of a frame at `time` (s): "40 µs, 151 m/s", "40 µs, 151 m/s (core)", or "40 µs" where the velocity is not
/// known.
std::string time_text(double time, const Motion &motion);

/// Visible box of a section, mm; z = 0 is the plate's front face.
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
