// SPDX-License-Identifier: BSD-3-Clause
#include "frame_facts.hpp"

#include "options/text.hpp"

#include <algorithm>
#include <cmath>

namespace draw {

using ogive::Frame;

namespace {

/// The z below which the share `below` of the positions within a radius of the axis lies, mm; 0 if there are none.
double low_mm(const std::vector<ogive::Vec3<float>> &positions, double radius_mm, double below) {
  std::vector<float> heights;
  for (const auto &x : positions)
    if (std::hypot(x[0], x[1]) <= 1e-3F * static_cast<float>(radius_mm)) heights.push_back(x[2]);
  if (heights.empty()) return 0;
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(below * double(heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  return 1e3 * double(*place);
}

} // namespace

std::string time_text(double time, const Motion &motion) {
  const auto velocity = velocity_at(motion.history, time * 1e6);
  const std::string part = motion.part.empty() ? "" : " (" + motion.part + ")";
  return options::printed("%.0f µs", time * 1e6) +
         // A rebound is no "-0".
         (velocity ? options::printed(", %.0f m/s", std::round(*velocity) + 0.0) + part : "");
}

SeenBox extended(SeenBox box, const Frame &frame) {
  const auto extend = [&](const auto &parts, double below) {
    for (const auto &part : parts)
      box.low_mm = std::min(box.low_mm, std::floor(low_mm(part.positions, box.radius_mm, below) - 4));
  };
  extend(frame.grids, 0);
  // A plug is a sixth of the disc; splinters are far less, and may have flown far ahead.
  extend(frame.clouds, 0.01);
  return box;
}

std::vector<std::size_t> shown_frames(std::size_t frames, int most) {
  const auto count = std::min(frames, static_cast<std::size_t>(most));
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < count; ++k)
    numbers.push_back(count == 1
                          ? frames - 1
                          : static_cast<std::size_t>(std::llround(double(k) * double(frames - 1) / double(count - 1))));
  return numbers;
}

} // namespace draw
