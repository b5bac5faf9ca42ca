// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/text.hpp"
#include "ogive/mesh/part_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// \file
/// A mesh of hexes as a file has it, before it is checked as a body: numbers, parts and lines for messages.

namespace ogive {

/// A mesh of a file. Nodes and hexes are in the order of their numbers, nodes that no hex has left out, so that one
/// mesh is the same in all formats.
struct FileMesh {
  std::string file;                       ///< its name, for messages
  PartMesh<double> body;                  ///< m; parts with numbers in their order, then those with names
  std::vector<std::int64_t> node_numbers; ///< as the file has them
  std::vector<std::int64_t> hex_numbers;  ///< likewise
  std::vector<long> hex_lines;            ///< first line of each hex, from 1; empty for a file without lines
};

/// "FILE: hex 12", or "FILE:40: hex 12" where the line is known.
inline std::string hex_place(const FileMesh &mesh, Index e) {
  const std::string line = mesh.hex_lines.empty() ? "" : ":" + std::to_string(mesh.hex_lines[e]);
  return printable(mesh.file) + line + ": hex " + std::to_string(mesh.hex_numbers[e]);
}

/// "FILE: node 12"
inline std::string node_place(const FileMesh &mesh, Index n) {
  return printable(mesh.file) + ": node " + std::to_string(mesh.node_numbers[n]);
}

/// One part of a mesh with its own nodes alone, as a mesh of a file.
inline FileMesh part_of_mesh(const FileMesh &mesh, std::size_t part) {
  const auto is_of_other = [&](Index e) { return !mesh.body.part_of.empty() && mesh.body.part_of[e] != part; };
  FileMesh own{mesh.file, without_hexes(mesh.body, is_of_other), {}, {}, {}};
  std::vector<bool> is_kept(mesh.node_numbers.size(), false);
  for (Index e = 0; e < static_cast<Index>(mesh.body.mesh.hexes.size()); ++e) {
    if (is_of_other(e)) continue;
    own.hex_numbers.push_back(mesh.hex_numbers[e]);
    if (!mesh.hex_lines.empty()) own.hex_lines.push_back(mesh.hex_lines[e]);
    for (const Index n : mesh.body.mesh.hexes[e]) is_kept[n] = true;
  }
  for (std::size_t n = 0; n < is_kept.size(); ++n)
    if (is_kept[n]) own.node_numbers.push_back(mesh.node_numbers[n]);
  return own;
}

/// Collects the nodes and hexes of a file, in any order, and refuses what is given twice or not at all.
struct MeshCollector {
  std::string file;                                   ///< its name, for messages
  double unit = 1e-3;                                 ///< length unit of its coordinates, m
  std::vector<Vec3<double>> positions{};              ///< m, of all nodes
  std::vector<std::int64_t> node_numbers{};           ///< likewise
  std::unordered_map<std::int64_t, Index> node_at{};  ///< place of a node by its number
  std::vector<std::array<std::int64_t, 8>> corners{}; ///< numbers of the nodes of each hex
  std::vector<std::int64_t> hex_numbers{};            ///< of each hex
  std::vector<long> hex_lines{};                      ///< of each hex
  std::unordered_map<std::int64_t, long> hex_seen{};  ///< line of a hex by its number
  std::vector<std::size_t> part_of{};                 ///< of each hex
  std::vector<std::string> parts{};                   ///< names
  std::size_t most = 20'000'000;                      ///< nodes or hexes that are read at most
};

/// Throws the SetupError "FILE:LINE: what".
[[noreturn]] inline void refuse_line(const MeshCollector &all, long line, const std::string &what) {
  throw SetupError(printable(all.file) + ":" + std::to_string(line) + ": " + what);
}

/// Place of a part by its name, which is added if it is new. Names have letters, digits, '-', '_' and '.' alone.
inline std::size_t part_named(MeshCollector &all, std::string name) {
  for (char &c : name)
    if (!is_letter_or_digit(c) && c != '-' && c != '_' && c != '.') c = '_';
  for (std::size_t place = 0; place < all.parts.size(); ++place)
    if (all.parts[place] == name) return place;
  all.parts.push_back(name);
  return all.parts.size() - 1;
}

/// Most parts of a mesh.
inline constexpr std::size_t most_parts_of_mesh = 16;

/// Adds a node at the coordinates x, in the unit of the file. Throws SetupError.
inline void add_node(MeshCollector &all, std::int64_t number, const Vec3<double> &x, long line) {
  const Vec3<double> position = all.unit * x;
  if (!position.allFinite() || position.cwiseAbs().maxCoeff() > 1e3)
    refuse_line(all, line, "node " + std::to_string(number) + ": coordinates must be finite and below 1000 m");
  if (all.positions.size() >= all.most) refuse_line(all, line, "has too many nodes");
  if (!all.node_at.emplace(number, static_cast<Index>(all.positions.size())).second)
    refuse_line(all, line, "node " + std::to_string(number) + ": is given a second time");
  all.positions.push_back(position), all.node_numbers.push_back(number);
}

/// Adds a hex. Throws SetupError.
inline void add_hex(MeshCollector &all, std::int64_t number, std::size_t part, const std::array<std::int64_t, 8> &nodes,
                    long line) {
  const std::string hex = "hex " + std::to_string(number) + ": ";
  if (all.corners.size() >= all.most) refuse_line(all, line, "has too many hexes");
  if (all.parts.size() > most_parts_of_mesh)
    refuse_line(all, line,
                hex + "is of part " + std::to_string(all.parts.size()) + ", at most " +
                    std::to_string(most_parts_of_mesh) + " are allowed");
  if (const auto [seen, is_new] = all.hex_seen.emplace(number, line); !is_new)
    refuse_line(all, line, hex + "is given a second time, the first is in line " + std::to_string(seen->second));
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (nodes[a] == nodes[b])
        refuse_line(all, line,
                    hex + "has node " + std::to_string(nodes[a]) +
                        " twice: wedges, pyramids and tetrahedra cannot be taken, only hexes of eight nodes");
  all.corners.push_back(nodes), all.hex_numbers.push_back(number), all.hex_lines.push_back(line);
  all.part_of.push_back(part);
}

namespace file_mesh_detail {

/// Places of values in ascending order.
template <class Values> std::vector<std::size_t> ascending(const Values &values) {
  std::vector<std::size_t> places(values.size());
  std::iota(places.begin(), places.end(), std::size_t(0));
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return places;
}

/// Sorts numbers before names.
inline std::pair<double, std::string> order_of(const std::string &part) {
  return {number_from(part).value_or(std::numeric_limits<double>::infinity()), part};
}

} // namespace file_mesh_detail

/// The mesh of what was collected. Throws SetupError for hexes whose nodes are not there, and if there is none.
inline FileMesh mesh_of(const MeshCollector &all, bool has_lines = true) {
  using file_mesh_detail::ascending;
  FileMesh mesh{all.file, {}, {}, {}, {}};
  if (all.corners.empty()) throw SetupError(printable(all.file) + ": hexes = 0: must be at least 1");
  std::vector<std::pair<double, std::string>> names;
  for (const std::string &part : all.parts) names.push_back(file_mesh_detail::order_of(part));
  std::vector<std::size_t> part_at(names.size());
  mesh.body.parts.clear();
  for (const std::size_t part : ascending(names))
    part_at[part] = mesh.body.parts.size(), mesh.body.parts.push_back(all.parts[part]);

  std::vector<Index> place(all.positions.size(), -1);
  for (const std::size_t e : ascending(all.hex_numbers)) {
    mesh.hex_numbers.push_back(all.hex_numbers[e]), mesh.body.part_of.push_back(part_at[all.part_of[e]]);
    if (has_lines) mesh.hex_lines.push_back(all.hex_lines[e]);
    auto &hex = mesh.body.mesh.hexes.emplace_back();
    for (std::size_t a = 0; a < 8; ++a) {
      const auto node = all.node_at.find(all.corners[e][a]);
      if (node == all.node_at.end())
        refuse_line(all, all.hex_lines[e],
                    "hex " + std::to_string(all.hex_numbers[e]) + ": node " + std::to_string(all.corners[e][a]) +
                        ": must be a node of the file");
      hex[a] = node->second, place[node->second] = 0;
    }
  }
  for (const std::size_t n : ascending(all.node_numbers)) {
    if (place[n] < 0) continue;
    place[n] = static_cast<Index>(mesh.body.mesh.positions.size());
    mesh.body.mesh.positions.push_back(all.positions[n]), mesh.node_numbers.push_back(all.node_numbers[n]);
  }
  for (auto &hex : mesh.body.mesh.hexes)
    for (Index &n : hex) n = place[n];
  return mesh;
}

} // namespace ogive
