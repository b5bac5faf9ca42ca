// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "mesh_io/sample.hpp"

#include "ogive/io/vtk_mesh.hpp"
#include "ogive/mesh_io/own_projectile.hpp"
#include "ogive/mesh_io/read_ls_dyna.hpp"

#include <vtkDoubleArray.h>

using namespace mesh_io_test;

namespace {

/// A body as a grid of VTK in mm, with the parts' numbers.
vtkSmartPointer<vtkUnstructuredGrid> grid_of(const PartMesh<double> &body) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto &x : body.mesh.positions)
    points->InsertNextPoint(std::round(x[0] * 1e9) / 1e6, std::round(x[1] * 1e9) / 1e6, std::round(x[2] * 1e9) / 1e6);
  grid->SetPoints(points);
  vtkNew<vtkIntArray> parts;
  parts->SetName("part");
  for (std::size_t e = 0; e < body.mesh.hexes.size(); ++e) {
    vtkIdType ids[8];
    std::copy(body.mesh.hexes[e].begin(), body.mesh.hexes[e].end(), ids);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
    parts->InsertNextValue(std::stoi(body.parts[body.part_of.empty() ? 0 : body.part_of[e]]));
  }
  grid->GetCellData()->AddArray(parts);
  return grid;
}

PartMesh<double> two_parts() {
  auto body = bricks({-2e-3, 0, 2e-3}, {-2e-3, 0, 2e-3}, {0, 3e-3, 6e-3});
  body.parts = {"4", "2"};
  for (std::size_t e = 0; e < 8; ++e) body.part_of.push_back(e < 4 ? 0 : 1);
  return body;
}

} // namespace

TEST_CASE("a mesh from VTK is the same as from LS-DYNA, to the last bit") {
  const TemporaryFolder folder;
  const auto file = folder.path / "a.vtu";
  const auto body = two_parts();
  write_vtu(file, grid_of(body));
  const auto mesh = read_vtu_mesh(file, 1e-3);
  CHECK(mesh.body.mesh.hexes == body.mesh.hexes);
  CHECK(mesh.body.parts == std::vector<std::string>{"2", "4"});
  CHECK(mesh.body.part_of == std::vector<std::size_t>{1, 1, 1, 1, 0, 0, 0, 0});
  const auto own = own_projectile(mesh, Extent::quarter);
  const auto k = own_projectile(read_ls_dyna_mesh(k_text(body), "a.k", 1e-3), Extent::quarter);
  CHECK(own.body.mesh.positions == k.body.mesh.positions);
  CHECK(own.body.mesh.hexes == k.body.mesh.hexes);
  CHECK(own.body.part_of == k.body.part_of);
}

TEST_CASE("VTK files that hold no mesh of hexes are refused") {
  const TemporaryFolder folder;
  const auto file = folder.path / "a.vtu";
  const auto refused = [&] { return refusal([&] { read_vtu_mesh(file, 1e-3); }); };
  CHECK(refused() == file.string() + ": must be a .vtu file that can be read");
  std::ofstream(file) << "<VTKFile type=\"UnstructuredGrid\">";
  CHECK(refused() == file.string() + ": must be a whole .vtu file, as ogive writes it");
  auto grid = grid_of(two_parts());
  const vtkIdType tetrahedron[4] = {0, 1, 3, 9};
  grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  grid->GetCellData()->Initialize();
  write_vtu(file, grid);
  CHECK(refused() ==
        file.string() + ": cell 8: type = 10: must be 12, a hex of eight nodes; other cells cannot be mixed in");
  auto body = two_parts();
  body.mesh.hexes[3][7] = body.mesh.hexes[3][6];
  write_vtu(file, grid_of(body));
  CHECK(refused() == file.string() + ": hex 3: has node " + std::to_string(body.mesh.hexes[3][6]) +
                         " twice: wedges, pyramids and tetrahedra cannot be taken, only hexes of eight nodes");
  grid = grid_of(two_parts());
  vtkNew<vtkDoubleArray> parts;
  parts->SetName("part");
  for (int e = 0; e < 8; ++e) parts->InsertNextValue(1.5);
  grid->GetCellData()->Initialize();
  grid->GetCellData()->AddArray(parts);
  write_vtu(file, grid);
  CHECK(refused() == file.string() + ": hex 0: part = 1.5: must be a whole number");
}
