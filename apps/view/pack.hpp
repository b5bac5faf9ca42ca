// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/frame.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Frames in 16-bit numbers, small enough for a page that a browser opens from disk.
///
/// A frame is a list of words. Each part has, one after the other: x, y and z of all points; of hexes their eight
/// corners, all first corners first, and the same again with the upper halves of the numbers where a grid has more than
/// 65536 nodes; then each field's values, of particles or hexes. What the words mean is in the frame's description:
/// a value is low + size * word / 65535.

namespace view {

using Words = std::vector<std::uint16_t>;

/// The range of values that 65536 steps divide.
struct Steps {
  double low = 0;  ///< value of step 0
  double size = 0; ///< of the whole range; 0 where all values are equal
};

/// The range of the values that are finite; 0 if there are none.
Steps steps_of(const std::vector<float> &values);

/// The step nearest to a value; those that are not finite count as the lowest.
std::uint16_t step_of(double value, const Steps &steps);

/// Words as text: base64 of zlib's form of all lower bytes and then all upper ones, which takes less room than pairs.
std::string packed(const Words &words);

/// Name of the field that pack() makes of velocities: the amount of a particle's, or of the mean of a hex's corners.
inline constexpr char speed_field[] = "speed_m_per_s";

/// The scalar fields that all parts of a frame have, by name, speed_field last.
std::vector<std::string> common_fields(const ogive::Frame &frame);

/// A frame for the page.
struct PackedFrame {
  std::string description; ///< JSON: time_us, mirrored_x, mirrored_y, words, and of each part what its words mean
  std::string words;       ///< packed()
};

/// Packs the positions and these fields of a frame, lengths in mm. Throws ogive::SetupError if a part lacks a field.
PackedFrame pack(const ogive::Frame &frame, const std::vector<std::string> &fields);

} // namespace view
