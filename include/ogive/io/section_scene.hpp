// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/symmetry.hpp"
#include "ogive/io/vtk_data_set.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataSetMapper.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkLight.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkReflectionFilter.h>
#include <vtkRenderer.h>
#include <vtkTableBasedClipDataSet.h>

/// \file
/// Parts of a frame as VTK actors, cut open at the plane y = 0. The half with y >= 0 stays. Lengths in mm.

namespace ogive {

/// How the parts of a section are drawn.
struct SectionStyle {
  std::string field = "plastic_strain";              ///< a scalar field of particles and cells that gives the colour
  double smallest = 0;                               ///< value of the first colour
  double largest = 1.5;                              ///< value of the last colour
  std::vector<std::string> grey_parts{"projectile"}; ///< drawn in one grey instead
  bool mesh_edges = true;                            ///< thin lines between hexes
  /// Radius of the spheres in particle distances; at half a lattice's diagonal, 0.7, neighbours close the face.
  double particle_radius = 0.7;
  double particle_ambient = 0.5; ///< light on spheres that does not shade them, 0 to 1
};

/// The colours: light grey for the metal as it was, through yellow and red to almost black.
inline vtkSmartPointer<vtkColorTransferFunction> section_colours(const SectionStyle &style) {
  constexpr double colours[][3] = {{0.80, 0.84, 0.88}, {0.98, 0.90, 0.55}, {0.98, 0.65, 0.25},
                                   {0.88, 0.32, 0.16}, {0.60, 0.06, 0.16}, {0.25, 0.02, 0.15}};
  constexpr int last = std::size(colours) - 1;
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int k = 0; k <= last; ++k)
    function->AddRGBPoint(style.smallest + (style.largest - style.smallest) * k / last, colours[k][0], colours[k][1],
                          colours[k][2]);
  return function;
}

/// True if the style leaves this part grey.
inline bool drawn_grey(const SectionStyle &style, const std::string &part) {
  return std::find(style.grey_parts.begin(), style.grey_parts.end(), part) != style.grey_parts.end();
}

/// The field that gives the colour of a part's `count` particles or cells. Throws SetupError if the part lacks it or if
/// it is not one number for each.
inline const Field &colour_field(const std::vector<Field> &fields, const SectionStyle &style, const std::string &part,
                                 std::size_t count) {
  const Field &field = find_field(fields, style.field, part);
  require(field.values.size() == count, part + " " + field.name + " values", field.values.size(),
          "must be one for each of " + std::to_string(count));
  return field;
}

/// Sets what the surfaces of a section share: mostly ambient light, so that colours can be read off, some shading.
inline void set_matt(vtkProperty *property, double ambient) {
  property->SetAmbient(ambient);
  property->SetDiffuse(1 - ambient);
  property->SetSpecular(0);
  property->SetColor(0.47, 0.50, 0.54);
}

/// The particles of the half y >= 0 as spheres, mirrored at x = 0 where that is a symmetry plane.
inline vtkSmartPointer<vtkActor> section_actor(const PointCloud &cloud, SymmetryPlanes planes,
                                               const SectionStyle &style, vtkColorTransferFunction *colours) {
  const bool grey = drawn_grey(style, cloud.name);
  std::vector<Vec3<float>> positions;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  const Field *field = grey ? nullptr : &colour_field(cloud.fields, style, cloud.name, cloud.positions.size());
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    const Vec3<float> &x = cloud.positions[i];
    // Particles in the plane itself stay, whatever the round-off.
    if (x[1] < -0.01F * cloud.diameter) continue;
    for (int copy = 0; copy < (planes.x ? 2 : 1); ++copy) {
      vertices->InsertNextCell({static_cast<vtkIdType>(positions.size())});
      positions.emplace_back(copy == 0 ? x[0] : -x[0], x[1], x[2]);
      values->InsertNextValue(field ? field->values[i] : 0.F);
    }
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(to_vtk_points(positions));
  points->SetVerts(vertices);
  points->GetPointData()->SetScalars(values);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetRadius(static_cast<float>(style.particle_radius) * 1e3F * cloud.diameter);
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetScalarVisibility(!grey);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_matt(actor->GetProperty(), style.particle_ambient);
  return actor;
}

/// The hexes of the half y >= 0 as a closed surface, mirrored at x = 0 where that is a symmetry plane.
inline vtkSmartPointer<vtkActor> section_actor(const HexGrid &hexes, SymmetryPlanes planes, const SectionStyle &style,
                                               vtkColorTransferFunction *colours) {
  const bool grey = drawn_grey(style, hexes.name);
  if (!grey) colour_field(hexes.cell_fields, style, hexes.name, hexes.hexes.size());
  vtkSmartPointer<vtkUnstructuredGrid> solid = to_vtk(hexes);
  if (!planes.y) {
    vtkNew<vtkPlane> plane;
    // A micrometre off: hexes that touch the plane from the other side would leave slivers that shine through.
    plane->SetOrigin(0, 1e-3, 0);
    plane->SetNormal(0, 1, 0);
    vtkNew<vtkTableBasedClipDataSet> clip;
    clip->SetInputData(solid);
    clip->SetClipFunction(plane);
    clip->Update();
    solid = clip->GetOutput();
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(solid);
  vtkNew<vtkReflectionFilter> mirror;
  mirror->SetInputConnection(surface->GetOutputPort());
  mirror->SetPlaneToX();
  mirror->SetCenter(0);
  mirror->CopyInputOn();
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(planes.x ? mirror->GetOutputPort() : surface->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(style.field.c_str());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetScalarVisibility(!grey);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  set_matt(actor->GetProperty(), 0.55);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetEdgeVisibility(style.mesh_edges);
  actor->GetProperty()->SetEdgeColor(0.36, 0.39, 0.43);
  actor->GetProperty()->SetLineWidth(1);
  return actor;
}

/// An empty scene: white, with one light that moves with the camera.
inline vtkSmartPointer<vtkRenderer> white_scene() {
  auto scene = vtkSmartPointer<vtkRenderer>::New();
  scene->SetBackground(1, 1, 1);
  scene->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.5, 0.7, 1.0);
  scene->AddLight(light);
  return scene;
}

/// What a section shows of the plane y = 0, seen along y with z upwards.
struct SectionView {
  double centre_x_mm = 0;     ///< in the middle of the view
  double centre_z_mm = -8;    ///< in the middle of the view; the plate's front face is z = 0
  double half_height_mm = 30; ///< half of what is seen from bottom to top
};

/// Points a scene's camera at a section.
inline void aim(vtkRenderer *scene, const SectionView &view) {
  vtkCamera *camera = scene->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(view.half_height_mm);
  camera->SetFocalPoint(view.centre_x_mm, 0, view.centre_z_mm);
  camera->SetPosition(view.centre_x_mm, -1000, view.centre_z_mm);
  camera->SetViewUp(0, 0, 1);
  scene->ResetCameraClippingRange();
}

/// The section of a frame as a scene. The computed part of a model lies where the coordinates of its symmetry planes
/// are positive. Throws SetupError if a part lacks the field asked for.
inline vtkSmartPointer<vtkRenderer> section_scene(const Frame &frame, SymmetryPlanes planes, const SectionStyle &style,
                                                  vtkColorTransferFunction *colours, const SectionView &view) {
  auto scene = white_scene();
  for (const auto &cloud : frame.clouds) scene->AddActor(section_actor(cloud, planes, style, colours));
  for (const auto &grid : frame.grids) scene->AddActor(section_actor(grid, planes, style, colours));
  aim(scene, view);
  return scene;
}

} // namespace ogive
