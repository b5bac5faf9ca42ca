// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/frame.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sample {

using ogive::Field;
using ogive::Frame;
using ogive::HexGrid;
using ogive::Index;
using ogive::PointCloud;
using Point = ogive::Vec3<float>;

/// A quarter of a solid of revolution about z as hexes between two radii and two heights, m.
inline HexGrid quarter_ring(const char *name, int part, float inner, float outer, float bottom, float top, int rings,
                            int turns, int layers) {
  HexGrid grid;
  grid.name = name;
  grid.part = part;
  for (int k = 0; k <= layers; ++k)
    for (int j = 0; j <= turns; ++j)
      for (int i = 0; i <= rings; ++i) {
        const auto r = inner + (outer - inner) * float(i) / float(rings);
        const auto angle = 1.5707963F * float(j) / float(turns);
        grid.positions.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                    bottom + (top - bottom) * float(k) / float(layers));
      }
  const auto node = [&](int i, int j, int k) { return Index((k * (turns + 1) + j) * (rings + 1) + i); };
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < turns; ++j)
      for (int i = 0; i < rings; ++i)
        grid.hexes.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                              node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                              node(i, j + 1, k + 1)});
  grid.point_fields = {{"velocity_m_per_s", 3, std::vector<float>(3 * grid.positions.size(), -100.F)}};
  grid.cell_fields = {{"plastic_strain", 1, std::vector<float>(grid.hexes.size(), 0.F)},
                      {"stress_MPa", 6, std::vector<float>(6 * grid.hexes.size(), 1.F)}};
  for (std::size_t e = 0; e < grid.hexes.size(); ++e) grid.cell_fields[0].values[e] = 1e-3F * float(e);
  return grid;
}

/// A quarter of a plate 12 mm thick whose plug, 10 mm in radius, a projectile has pushed by `push` m; particles
/// `spacing` m apart within 24 mm, hexes from there to 40 mm.
inline Frame perforated_plate(float push = 8e-3F, float spacing = 1.2e-3F) {
  Frame frame;
  frame.time = 60e-6;
  PointCloud plate{"plate_sph", 0, spacing, {}, {{"plastic_strain", 1, {}}, {"velocity_m_per_s", 3, {}}}};
  const int layers = int(std::lround(12e-3F / spacing));
  const int across = int(24e-3F / spacing) + 1;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        Point x((float(i) + 0.5F) * spacing, (float(j) + 0.5F) * spacing, -(float(k) + 0.5F) * spacing);
        const float r = std::hypot(x[0], x[1]);
        if (r > 24e-3F) continue;
        const float band = (r - 10e-3F) / 1.2e-3F;
        x[2] -= r < 10e-3F ? push : 0.15F * push * std::exp(-(r - 10e-3F) / 5e-3F);
        plate.positions.push_back(x);
        plate.fields[0].values.push_back(1.8F * std::exp(-band * band));
        for (const float v : {0.F, 0.F, r < 10e-3F ? -100.F : 0.F}) plate.fields[1].values.push_back(v);
      }
  frame.clouds.push_back(plate);
  frame.grids.push_back(quarter_ring("plate_rim", 1, 24e-3F, 40e-3F, -12e-3F, 0.F, 8, 12, 8));
  frame.grids.push_back(quarter_ring("projectile", 2, 0.5e-3F, 10e-3F, -push, 80e-3F - push, 6, 8, 32));
  auto &rim = frame.grids[0].cell_fields[0].values;
  std::fill(rim.begin(), rim.end(), 0.F);
  return frame;
}

} // namespace sample
