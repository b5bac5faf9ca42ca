// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh_io/mesh_text.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ogive {

namespace ls_dyna_detail {

/// The fields of a line: between commas, or in columns, the first `narrow` of them 8 wide and the others 16; all 20
/// wide in the long format.
inline std::vector<std::string_view> fields_of(const MeshCollector &all, const TextLine &line, std::size_t narrow,
                                               bool is_long) {
  if (line.text.find(',') != std::string_view::npos) return comma_fields(line.text);
  if (line.text.find('\t') != std::string_view::npos)
    refuse_line(all, line.number, "has a tab, with which columns cannot be counted; put blanks in its place");
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at < line.text.size() && fields.size() < 16;) {
    const std::size_t width = is_long ? 20 : fields.size() < narrow ? 8 : 16;
    fields.push_back(trimmed_text(line.text.substr(at, width)));
    at += width;
  }
  return fields;
}

/// The nodes of a hex from the fields behind its number and part, or from a line of their own.
inline void add_solid(MeshCollector &all, std::int64_t number, std::string_view part,
                      const std::vector<std::string_view> &nodes, long line) {
  if (nodes.size() < 8)
    refuse_line(all, line,
                "hex " + std::to_string(number) + ": nodes = " + std::to_string(nodes.size()) + ": must be 8");
  for (std::size_t k = 8; k < nodes.size(); ++k)
    if (!nodes[k].empty() && nodes[k] != "0")
      refuse_line(all, line,
                  "hex " + std::to_string(number) + ": has " + std::to_string(k + 1) + " nodes: must be a hex of 8");
  std::array<std::int64_t, 8> corners{};
  for (std::size_t a = 0; a < 8; ++a) corners[a] = number_of_field(all, nodes[a], "node", line);
  const auto id = number_of_field(all, part, "part", line);
  add_hex(all, number, part_named(all, std::to_string(id)), corners, line);
}

} // namespace ls_dyna_detail

/// The hexes of an LS-DYNA keyword file: *NODE and *ELEMENT_SOLID, in columns, in the long format or with commas, a
/// solid on one line or on two. Parts are named by their numbers. Other keywords are left out, but for those that would
/// change the mesh. `unit` is the length unit of the coordinates in m. Throws SetupError with file, line and reason.
inline FileMesh read_ls_dyna_mesh(std::string_view text, const std::string &file, double unit) {
  using namespace ls_dyna_detail;
  MeshCollector all{file, unit};
  enum class Block { other, nodes, solids } block = Block::other;
  bool is_long_file = false, is_long = false;
  std::int64_t begun = 0; // a solid whose nodes are on the next line
  std::string part;
  long begun_in = 0;
  const auto end_solid = [&] {
    if (begun != 0) refuse_line(all, begun_in, "hex " + std::to_string(begun) + ": its nodes are missing");
  };
  for_each_line(text, "$", [&](const TextLine &line) {
    if (line.text.front() == '*') {
      end_solid();
      // "*ELEMENT_SOLID (ten nodes format)": a remark.
      std::string keyword = squeezed_text(line.text.substr(0, line.text.find('(')));
      is_long = is_long_file;
      if (keyword.ends_with('+') || keyword.ends_with('-')) is_long = keyword.back() == '+', keyword.pop_back();
      const std::string shown = printable(keyword);
      block = keyword == "*NODE" ? Block::nodes : keyword == "*ELEMENT_SOLID" ? Block::solids : Block::other;
      if (keyword.starts_with("*KEYWORD")) is_long_file = keyword.find("LONG=Y") != std::string::npos;
      if (keyword.starts_with("*INCLUDE"))
        refuse_line(all, line.number, shown + ": other files are not read; put the mesh into one file");
      if (block == Block::other && keyword.starts_with("*ELEMENT_") && !keyword.starts_with("*ELEMENT_MASS"))
        refuse_line(all, line.number, shown + ": must be *ELEMENT_SOLID, hexes alone");
      if (block == Block::other && (keyword.starts_with("*NODE_") || keyword.starts_with("*NODE%")))
        refuse_line(all, line.number, shown + ": must be *NODE");
      return keyword != "*END";
    }
    if (block == Block::nodes) add_node_of_fields(all, fields_of(all, line, 1, is_long), line.number);
    if (block != Block::solids) return true;
    std::vector<std::string_view> fields = fields_of(all, line, 16, is_long);
    if (begun != 0) {
      add_solid(all, begun, part, fields, line.number);
      begun = 0;
      return true;
    }
    if (fields.size() < 2)
      refuse_line(all, line.number,
                  "fields of a solid = " + std::to_string(fields.size()) + ": must be 10, number, part and 8 nodes");
    const std::int64_t number = number_of_field(all, fields[0], "hex", line.number);
    if (fields.size() == 2) {
      begun = number, part = fields[1], begun_in = line.number;
      return true;
    }
    const std::string_view own_part = fields[1];
    fields.erase(fields.begin(), fields.begin() + 2);
    add_solid(all, number, own_part, fields, line.number);
    return true;
  });
  end_solid();
  return mesh_of(all);
}

} // namespace ogive
