// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/text.hpp"
#include "ogive/mesh/part_mesh.hpp"

#include <string>

namespace mesh_io_test {

using namespace ogive;

/// A length in mm with all its digits: reads back as the same number of metres where the conversion is exact to the
/// last bit, which is so for whole micrometres.
inline std::string in_mm(double metres) { return with_digits(std::round(metres * 1e9) / 1e6, 12); }

/// A body as an LS-DYNA file with commas, numbers from 1 on.
inline std::string k_text(const PartMesh<double> &body) {
  std::string text = "*KEYWORD\n$ a comment\n*NODE\n";
  for (std::size_t n = 0; n < body.mesh.positions.size(); ++n) {
    const auto &x = body.mesh.positions[n];
    text += std::to_string(n + 1) + "," + in_mm(x[0]) + "," + in_mm(x[1]) + "," + in_mm(x[2]) + "\n";
  }
  text += "*ELEMENT_SOLID\n";
  for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) {
    text += std::to_string(e + 1) + "," + body.parts[body.part_of.empty() ? 0 : body.part_of[e]];
    for (const Index n : body.mesh.hexes[e]) text += "," + std::to_string(n + 1);
    text += "\n";
  }
  return text + "*END\n";
}

/// The same for Abaqus, with a set for each part.
inline std::string inp_text(const PartMesh<double> &body) {
  std::string text = "*HEADING\na test\n** a comment\n*NODE\n";
  for (std::size_t n = 0; n < body.mesh.positions.size(); ++n) {
    const auto &x = body.mesh.positions[n];
    text += std::to_string(n + 1) + ", " + in_mm(x[0]) + ", " + in_mm(x[1]) + ", " + in_mm(x[2]) + "\n";
  }
  for (std::size_t part = 0; part < body.parts.size(); ++part) {
    text += "*ELEMENT, TYPE=C3D8R, ELSET=" + body.parts[part] + "\n";
    for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) {
      if (!body.part_of.empty() && body.part_of[e] != part) continue;
      text += std::to_string(e + 1);
      for (std::size_t a = 0; a < 8; ++a) text += (a == 4 ? ",\n " : ", ") + std::to_string(body.mesh.hexes[e][a] + 1);
      text += "\n";
    }
  }
  return text;
}

/// Bricks on a grid with the lines `x`, `y`, `z` (m).
inline PartMesh<double> bricks(const std::vector<double> &x, const std::vector<double> &y,
                               const std::vector<double> &z) {
  PartMesh<double> body;
  const auto node = [&](std::size_t i, std::size_t j, std::size_t k) {
    return static_cast<Index>((k * y.size() + j) * x.size() + i);
  };
  for (const double at_z : z)
    for (const double at_y : y)
      for (const double at_x : x) body.mesh.positions.push_back({at_x, at_y, at_z});
  for (std::size_t k = 0; k + 1 < z.size(); ++k)
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        body.mesh.hexes.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                                   node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                   node(i, j + 1, k + 1)});
  return body;
}

/// What `f()` is refused with; empty if it is not.
template <class F> std::string refusal(F &&f) {
  try {
    f();
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

} // namespace mesh_io_test
