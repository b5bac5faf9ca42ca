// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/core/nodes.hpp"
#include "ogive/core/symmetry.hpp"
#include "ogive/core/types.hpp"
#include "ogive/material/points.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// \file
/// A model at one time as output sees it: plain arrays in single precision, copied out of the model. Each field's name
/// contains its unit.

namespace ogive {

// Frames alone, such as pictures are made from, need neither kind of body.
template <class T, class Law, class Rule, class Width> struct HexBody;
template <class T, class Law, class Kernel, class Form, class Width> struct SphBody;

/// Values on points or cells, `components` after each other for each. One component is a scalar, three a vector
/// (x, y, z), six a symmetric tensor (xx, yy, zz, xy, yz, zx).
struct Field {
  std::string name;          ///< with its unit: "von_mises_MPa"
  int components = 1;        ///< 1, 3 or 6
  std::vector<float> values; ///< components of the first, of the second, ...
};

/// A body of particles.
struct PointCloud {
  std::string name;                   ///< of the body
  int part = 0;                       ///< number of the body in the model, from 0
  float diameter = 0;                 ///< particle distance, m
  std::vector<Vec3<float>> positions; ///< m
  std::vector<Field> fields;          ///< on the particles
};

/// A body of eight-node hexes.
struct HexGrid {
  std::string name;                        ///< of the body
  int part = 0;                            ///< number of the body in the model, from 0
  std::vector<Vec3<float>> positions;      ///< m
  std::vector<std::array<Index, 8>> hexes; ///< corners, indices into positions
  std::vector<Field> point_fields;         ///< on the nodes
  std::vector<Field> cell_fields;          ///< on the hexes
};

/// All bodies of a model at one time.
struct Frame {
  double time = 0;                ///< s
  std::vector<PointCloud> clouds; ///< bodies of particles
  std::vector<HexGrid> grids;     ///< bodies of hexes
  SymmetryPlanes symmetry{}; ///< the bodies are the part that is computed, where the planes' coordinates are positive
};

/// The field `name` of the part `part`. Throws SetupError if there is none.
inline const Field &find_field(const std::vector<Field> &fields, std::string_view name, std::string_view part) {
  std::string names;
  for (const Field &field : fields) {
    if (field.name == name) return field;
    names += (names.empty() ? "" : ", ") + field.name;
  }
  throw SetupError(std::string(part) + " field = " + std::string(name) + ": must be one of " + names);
}

/// Positions of nodes, m.
template <class T> std::vector<Vec3<float>> gather_positions(const Nodes<T> &nodes, const std::vector<Index> &numbers) {
  std::vector<Vec3<float>> positions;
  positions.reserve(numbers.size());
  for (const Index n : numbers) positions.push_back(nodes.position[n].template cast<float>());
  return positions;
}

/// Field "velocity_m_per_s" of nodes: half a step older than the positions.
template <class T> Field gather_velocity(const Nodes<T> &nodes, const std::vector<Index> &numbers) {
  Field field{"velocity_m_per_s", 3, {}};
  field.values.reserve(3 * numbers.size());
  for (const Index n : numbers)
    for (int k = 0; k < 3; ++k) field.values.push_back(static_cast<float>(nodes.velocity[n][k]));
  return field;
}

/// The state of material points as fields, a value for each of `cells`: the mean over its `points_per_cell` consecutive
/// points (von Mises stress is that of the mean stress). Stress is Cauchy's, positive in tension; pressure is positive
/// in compression.
template <class T>
std::vector<Field> gather_state(const MaterialPoints<T> &points, const std::vector<Index> &cells,
                                Index points_per_cell) {
  std::vector<Field> fields{{"stress_MPa", 6, {}},
                            {"von_mises_MPa", 1, {}},
                            {"pressure_MPa", 1, {}},
                            {"plastic_strain", 1, {}},
                            {"plastic_strain_rate_per_s", 1, {}},
                            {"temperature_K", 1, {}},
                            {"damage", 1, {}},
                            {"density_kg_per_m3", 1, {}}};
  for (Field &field : fields) field.values.reserve(cells.size() * static_cast<std::size_t>(field.components));
  const T share = T(1) / static_cast<T>(points_per_cell);
  const T to_MPa = T(1e-6);
  for (const Index cell : cells) {
    MaterialPoint<T> mean;
    for (Index i = cell * points_per_cell; i < (cell + 1) * points_per_cell; ++i) {
      mean.deviator += share * points.deviator[i];
      mean.pressure += share * points.pressure[i];
      mean.plastic_strain += share * points.plastic_strain[i];
      mean.plastic_strain_rate += share * points.plastic_strain_rate[i];
      mean.temperature += share * points.temperature[i];
      mean.damage += share * points.damage[i];
      mean.density += share * points.density[i];
    }
    const Sym3<T> s = to_MPa * stress(mean);
    for (const T component : {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx})
      fields[0].values.push_back(static_cast<float>(component));
    std::size_t f = 1;
    for (const T scalar : {to_MPa * von_mises(mean.deviator), to_MPa * mean.pressure, mean.plastic_strain,
                           mean.plastic_strain_rate, mean.temperature, mean.damage, mean.density})
      fields[f++].values.push_back(static_cast<float>(scalar));
  }
  return fields;
}

/// The numbers from `begin` to `end` that `is_kept` wants.
template <class F> std::vector<Index> numbers_of(Index begin, Index end, F &&is_kept) {
  std::vector<Index> numbers;
  numbers.reserve(static_cast<std::size_t>(end - begin));
  for (Index i = begin; i < end; ++i)
    if (is_kept(i)) numbers.push_back(i);
  return numbers;
}

/// Adds a body of particles to a frame, as a cloud of points. Removed particles are left out.
template <class T, class Law, class K, class F, class Width>
void gather_body(Frame &frame, const Nodes<T> &nodes, const SphBody<T, Law, K, F, Width> &body, int part) {
  const auto particles = numbers_of(0, body.points.size(), [&](Index i) { return !is_removed(body, i); });
  std::vector<Index> numbers = particles;
  for (Index &n : numbers) n += body.nodes.begin;
  PointCloud cloud{body.name, part, static_cast<float>(body.spacing), gather_positions(nodes, numbers),
                   gather_state(body.points, particles, 1)};
  cloud.fields.push_back(gather_velocity(nodes, numbers));
  frame.clouds.push_back(std::move(cloud));
}

/// Adds a body of hexes to a frame, as a grid. Elements with several material points give their mean. Removed hexes,
/// their corners and nodes that belong to other parts alone are left out.
template <class T, class Law, class Rule, class Width>
void gather_body(Frame &frame, const Nodes<T> &nodes, const HexBody<T, Law, Rule, Width> &body, int part) {
  const auto count = static_cast<Index>(body.hexes.size());
  const auto hexes = numbers_of(0, count, [&](Index e) { return !is_removed(body, e); });
  const std::vector<Index> &corners_before = body.corners_of_nodes.begin;
  const auto numbers = numbers_of(body.nodes.begin, body.nodes.end, [&](Index n) {
    const Index own = n - body.nodes.begin;
    return corners_before[own] < corners_before[own + 1] && !is_node_removed(body, own);
  });
  std::vector<Index> place(static_cast<std::size_t>(body.nodes.size()), -1);
  for (std::size_t k = 0; k < numbers.size(); ++k) place[numbers[k] - body.nodes.begin] = static_cast<Index>(k);
  HexGrid grid{body.name,
               part,
               gather_positions(nodes, numbers),
               {},
               {gather_velocity(nodes, numbers)},
               gather_state(body.points, hexes, points_of_hex(body))};
  for (const Index e : hexes) {
    auto &corners = grid.hexes.emplace_back(body.hexes[e]);
    for (Index &corner : corners) corner = place[corner - body.nodes.begin];
  }
  frame.grids.push_back(std::move(grid));
}

/// The bodies of a model now, in the order of the model.
template <class M> Frame gather_frame(const M &model) {
  Frame frame;
  frame.time = static_cast<double>(model.time);
  frame.symmetry = model.symmetry;
  int part = 0;
  // Found with the model, in sim/model.hpp: pictures of frames alone do not compile contact and ties.
  for_each_body(model, [&](const auto &body) { gather_body(frame, model.nodes, body, part++); });
  return frame;
}

} // namespace ogive
