// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/frame.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

/// \file
/// Parts of a frame as VTK data sets. Lengths are in mm: the points' array is called "position_mm".

namespace ogive {

/// Points in mm from positions in m.
inline vtkSmartPointer<vtkPoints> to_vtk_points(const std::vector<Vec3<float>> &positions) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("position_mm");
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(positions.size()));
  float *next = coordinates->GetPointer(0);
  for (const Vec3<float> &x : positions)
    for (int k = 0; k < 3; ++k) *next++ = 1e3F * x[k];
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

/// Adds the fields of a part as arrays on its `count` points or cells. Throws SetupError for a field whose size does
/// not fit.
inline void add_fields(vtkDataSetAttributes *attributes, const std::vector<Field> &fields, const std::string &part,
                       std::size_t count) {
  constexpr std::array vector_names{"X", "Y", "Z"};
  constexpr std::array tensor_names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  for (const Field &field : fields) {
    require(field.values.size() == count * static_cast<std::size_t>(field.components),
            part + " " + field.name + " values", field.values.size(),
            "must be " + std::to_string(count) + " times " + std::to_string(field.components));
    vtkNew<vtkFloatArray> array;
    array->SetName(field.name.c_str());
    array->SetNumberOfComponents(field.components);
    if (field.components == 3)
      for (int k = 0; k < 3; ++k) array->SetComponentName(k, vector_names[k]);
    if (field.components == 6)
      for (int k = 0; k < 6; ++k) array->SetComponentName(k, tensor_names[k]);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
    std::copy(field.values.begin(), field.values.end(), array->GetPointer(0));
    attributes->AddArray(array);
  }
}

/// Adds the number of the part as the array "part" on each of `count` points or cells.
inline void add_part_number(vtkDataSetAttributes *attributes, int part, std::size_t count) {
  vtkNew<vtkIntArray> parts;
  parts->SetName("part");
  parts->SetNumberOfTuples(static_cast<vtkIdType>(count));
  parts->FillValue(part);
  attributes->AddArray(parts);
}

/// Name of the field data with the mirror planes at which a part ends: 1 or 0 for x = 0, then for y = 0.
inline constexpr char symmetry_array[] = "symmetry_planes";

/// Adds the mirror planes, without which a quarter alone cannot be distinguished from the whole.
inline void add_symmetry(vtkUnstructuredGrid *grid, SymmetryPlanes planes) {
  vtkNew<vtkIntArray> array;
  array->SetName(symmetry_array);
  array->SetNumberOfComponents(2);
  array->SetComponentName(0, "X");
  array->SetComponentName(1, "Y");
  array->InsertNextTuple2(planes.x, planes.y);
  grid->GetFieldData()->AddArray(array);
}

/// Name of the field data that hold the particle distance.
inline constexpr char diameter_array[] = "particle_diameter_mm";

/// A cloud as one vertex for each particle; the field data hold the particle distance.
inline vtkSmartPointer<vtkUnstructuredGrid> to_vtk(const PointCloud &cloud) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto count = static_cast<vtkIdType>(cloud.positions.size());
  grid->SetPoints(to_vtk_points(cloud.positions));
  grid->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i) grid->InsertNextCell(VTK_VERTEX, 1, &i);
  add_fields(grid->GetPointData(), cloud.fields, cloud.name, cloud.positions.size());
  add_part_number(grid->GetPointData(), cloud.part, cloud.positions.size());
  vtkNew<vtkFloatArray> diameter;
  diameter->SetName(diameter_array);
  diameter->InsertNextValue(1e3F * cloud.diameter);
  grid->GetFieldData()->AddArray(diameter);
  return grid;
}

/// A grid of hexes. The part's number is on the cells.
inline vtkSmartPointer<vtkUnstructuredGrid> to_vtk(const HexGrid &hexes) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto count = static_cast<vtkIdType>(hexes.hexes.size());
  grid->SetPoints(to_vtk_points(hexes.positions));
  grid->AllocateExact(count, 8 * count);
  for (const auto &corners : hexes.hexes) {
    vtkIdType ids[8];
    std::copy(corners.begin(), corners.end(), ids);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  add_fields(grid->GetPointData(), hexes.point_fields, hexes.name, hexes.positions.size());
  add_fields(grid->GetCellData(), hexes.cell_fields, hexes.name, hexes.hexes.size());
  add_part_number(grid->GetCellData(), hexes.part, hexes.hexes.size());
  return grid;
}

} // namespace ogive
