// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/mesh_io/mesh_text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ogive {

namespace abaqus_detail {

/// A keyword with its parameters, in capitals and without blanks; names as they are written.
struct Keyword {
  std::string name;                                        ///< "*NODE"
  std::vector<std::pair<std::string, std::string>> values; ///< parameter and value
  long line = 0;                                           ///< its first line
};

/// Value of a parameter; empty if it is missing.
inline std::string parameter(const Keyword &keyword, std::string_view name) {
  for (const auto &[parameter, value] : keyword.values)
    if (parameter == name) return value;
  return "";
}

/// Adds the parameters of a line to a keyword; true if the next line has more.
inline bool add_parameters(Keyword &keyword, std::string_view line) {
  bool first = keyword.name.empty();
  const auto fields = comma_fields(line);
  for (const std::string_view field : fields) {
    if (std::exchange(first, false)) {
      keyword.name = squeezed_text(field);
      continue;
    }
    const std::size_t equals = std::min(field.find('='), field.size());
    std::string_view value = trimmed_text(field.substr(std::min(equals + 1, field.size())));
    if (value.size() > 1 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    if (!field.empty()) keyword.values.emplace_back(squeezed_text(field.substr(0, equals)), value);
  }
  return fields.size() > 1 && fields.back().empty();
}

/// Throws SetupError for keywords that would change the mesh or are of other elements.
inline void check(const MeshCollector &all, const Keyword &keyword) {
  const auto refuse = [&](const std::string &what) { refuse_line(all, keyword.line, printable(keyword.name) + what); };
  if (keyword.name == "*INCLUDE") refuse(": other files are not read; put the mesh into one file");
  for (const char *made : {"*NGEN", "*NCOPY", "*NFILL", "*NMAP", "*ELGEN", "*ELCOPY", "*SYSTEM", "*TRANSFORM"})
    if (keyword.name == made) refuse(": must be written out as nodes and elements");
  if (keyword.name != "*NODE" && keyword.name != "*ELEMENT") return;
  if (!parameter(keyword, "INPUT").empty()) refuse(", INPUT: other files are not read; put the mesh into one file");
  const std::string system = squeezed_text(parameter(keyword, "SYSTEM"));
  if (keyword.name == "*NODE" && !system.empty() && system != "R") refuse(", SYSTEM: must be rectangular");
  if (keyword.name != "*ELEMENT") return;
  const std::string type = squeezed_text(parameter(keyword, "TYPE"));
  if (type != "C3D8" && type != "C3D8R" && type != "C3D8I")
    refuse(", TYPE = " + printable(type) + ": must be C3D8, C3D8R or C3D8I, hexes alone");
}

} // namespace abaqus_detail

/// The hexes of an Abaqus input file: *NODE and *ELEMENT of type C3D8, C3D8R or C3D8I. Parts are the sets of *ELEMENT,
/// ELSET=NAME; elements without are of part 1. `unit` is the length unit of the coordinates in m. Throws SetupError
/// with file, line and reason.
inline FileMesh read_abaqus_mesh(std::string_view text, const std::string &file, double unit) {
  using namespace abaqus_detail;
  MeshCollector all{file, unit};
  Keyword keyword;
  bool continues = false;
  std::vector<std::string_view> element; // fields of one that continues on the next line
  long element_line = 0;
  std::vector<Keyword> sections;
  std::vector<std::string> sets; // of each part, in capitals and without blanks: as Abaqus compares names
  const auto end_keyword = [&] {
    check(all, keyword);
    if (keyword.name == "*SOLIDSECTION") sections.push_back(keyword);
  };
  const auto end_element = [&] {
    if (!element.empty())
      refuse_line(all, element_line,
                  "fields of an element = " + std::to_string(element.size()) + ": must be 9, number and 8 nodes");
  };
  for_each_line(text, "**", [&](const TextLine &line) {
    if (continues) {
      continues = add_parameters(keyword, line.text);
      if (!continues) end_keyword();
      return true;
    }
    if (line.text.front() == '*') {
      end_element();
      keyword = {"", {}, line.number};
      continues = add_parameters(keyword, line.text);
      if (!continues) end_keyword();
      return true;
    }
    if (keyword.name == "*INSTANCE")
      refuse_line(all, line.number, "moves an instance: its nodes must have their final coordinates");
    if (keyword.name != "*NODE" && keyword.name != "*ELEMENT") return true;
    auto fields = comma_fields(line.text);
    if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
    if (keyword.name == "*NODE") {
      add_node_of_fields(all, fields, line.number);
      return true;
    }
    if (element.empty()) element_line = line.number;
    element.insert(element.end(), fields.begin(), fields.end());
    if (element.size() < 9 && line.text.ends_with(',')) return true;
    if (element.size() != 9) end_element();
    const std::int64_t number = number_of_field(all, element[0], "element", element_line);
    std::array<std::int64_t, 8> corners{};
    for (std::size_t a = 0; a < 8; ++a) corners[a] = number_of_field(all, element[a + 1], "node", element_line);
    const std::string set = parameter(keyword, "ELSET");
    auto place = static_cast<std::size_t>(std::find(sets.begin(), sets.end(), squeezed_text(set)) - sets.begin());
    if (place == sets.size()) {
      if (set.size() > 80) refuse_line(all, keyword.line, "*ELEMENT, ELSET: must have at most 80 characters");
      place = part_named(all, set.empty() ? "1" : set);
      if (place < sets.size())
        refuse_line(all, keyword.line,
                    "*ELEMENT, ELSET = " + printable(set) +
                        ": must differ from other sets by letters, digits, '-', '_' or '.'");
      sets.push_back(squeezed_text(set));
    }
    add_hex(all, number, place, corners, element_line);
    element.clear();
    return true;
  });
  if (continues) end_keyword();
  end_element();
  for (const Keyword &section : sections) {
    const std::string set = squeezed_text(parameter(section, "ELSET"));
    // One section for all elements, whatever its set is called, makes one part.
    const bool is_only = sections.size() == 1 && sets == std::vector<std::string>{""};
    if (!is_only && std::find(sets.begin(), sets.end(), set) == sets.end())
      refuse_line(all, section.line,
                  "*SOLIDSECTION, ELSET = " + printable(set) +
                      ": must be a set of *ELEMENT, ELSET=; those of *ELSET are not read");
  }
  return mesh_of(all);
}

} // namespace ogive
