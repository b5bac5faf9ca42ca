// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/read_frame.hpp"
#include "ogive/mesh_io/file_mesh.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace ogive {

/// The hexes of a .vtu, of its points in the unit `unit` (m). Parts are the values of the first of the cell arrays
/// "part", "part_id", "PartId" and "material" that is there; without one all hexes are of part 1. Points and hexes are
/// counted from 0. Throws SetupError with the file and the reason.
inline FileMesh read_vtu_mesh(const std::filesystem::path &path, double unit) {
  const auto grid = read_detail::read_vtu(path);
  MeshCollector all{path.string(), unit};
  vtkDataArray *parts = nullptr;
  for (const char *name : {"part", "part_id", "PartId", "material"})
    if (parts == nullptr) parts = grid->GetCellData()->GetArray(name);
  if (parts != nullptr &&
      (parts->GetNumberOfComponents() != 1 || parts->GetNumberOfTuples() != grid->GetNumberOfCells()))
    throw read_error(path, std::string(parts->GetName()) + " must have one value for each hex");
  for (vtkIdType n = 0; n < grid->GetNumberOfPoints(); ++n) {
    Vec3<double> x;
    grid->GetPoint(n, x.data());
    if (!(unit * x.cwiseAbs().maxCoeff() <= 1e3))
      throw read_error(path, "node " + std::to_string(n) + ": coordinates must be finite and below 1000 m");
    add_node(all, n, x, 0);
  }
  vtkIdType size = 0;
  const vtkIdType *corners = nullptr;
  for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e) {
    const std::string hex = "hex " + std::to_string(e);
    grid->GetCells()->GetCellAtId(e, size, corners);
    if (grid->GetCellType(e) != VTK_HEXAHEDRON || size != 8)
      throw read_error(path, "cell " + std::to_string(e) + ": type = " + std::to_string(grid->GetCellType(e)) +
                                 ": must be 12, a hex of eight nodes; other cells cannot be mixed in");
    std::array<std::int64_t, 8> nodes{};
    for (std::size_t a = 0; a < 8; ++a) nodes[a] = corners[a];
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (nodes[a] == nodes[b])
          throw read_error(path,
                           hex + ": has node " + std::to_string(nodes[a]) +
                               " twice: wedges, pyramids and tetrahedra cannot be taken, only hexes of eight nodes");
    const double part = parts == nullptr ? 1 : parts->GetComponent(e, 0);
    if (!(part == std::floor(part) && std::abs(part) < 1e9))
      throw read_error(path, hex + ": part = " + shortest(part) + ": must be a whole number");
    const std::size_t place = part_named(all, std::to_string(static_cast<std::int64_t>(part)));
    if (all.parts.size() > most_parts_of_mesh)
      throw read_error(path, "parts = " + std::to_string(all.parts.size()) + ": must be at most " +
                                 std::to_string(most_parts_of_mesh));
    add_hex(all, e, place, nodes, 0);
  }
  return mesh_of(all, false);
}

} // namespace ogive
