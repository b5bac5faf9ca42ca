// SPDX-License-Identifier: BSD-3-Clause
#include "frame_facts.hpp"

#include "ogive/fem/hex8.hpp"
#include "options/text.hpp"
#include "scene.hpp"

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

std::optional<double> projectile_velocity(const Frame &frame) {
  const auto named = [](const auto &all, const char *name) {
    return std::find_if(all.begin(), all.end(), [&](const auto &one) { return one.name == name; });
  };
  double mass = 0, momentum = 0;
  for (const ogive::HexGrid &grid : frame.grids) {
    if (!is_of_projectile(grid.name)) continue;
    const auto velocity = named(grid.point_fields, "velocity_m_per_s");
    const auto density = named(grid.cell_fields, "density_kg_per_m3");
    if (velocity == grid.point_fields.end() || density == grid.cell_fields.end() || velocity->components != 3)
      return std::nullopt;
    for (std::size_t e = 0; e < grid.hexes.size(); ++e) {
      ogive::Corners<double> corners;
      double mean = 0;
      int c = 0;
      for (const auto n : grid.hexes[e]) {
        corners.row(c++) = grid.positions[static_cast<std::size_t>(n)].cast<double>();
        mean -= velocity->values[3 * static_cast<std::size_t>(n) + 2] / 8.0;
      }
      const double m = density->values[e] * ogive::hex_volume(corners);
      mass += m;
      momentum += m * mean;
    }
  }
  if (!(mass > 0)) return std::nullopt;
  return momentum / mass;
}

std::string time_text(const Frame &frame) {
  const auto velocity = projectile_velocity(frame);
  return options::printed("%.0f µs", frame.time * 1e6) +
         // A rebound is no "-0".
         (velocity ? options::printed(", %.0f m/s", std::round(*velocity) + 0.0) : "");
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
