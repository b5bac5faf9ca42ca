// SPDX-License-Identifier: BSD-3-Clause
#include "scene.hpp"

#include "ogive/io/vtk_data_set.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataSetMapper.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkReflectionFilter.h>
#include <vtkTableBasedClipDataSet.h>

namespace draw {

namespace {

/// True if the style leaves this part grey.
bool drawn_grey(const SectionStyle &style, const std::string &part) {
  return std::any_of(style.grey_parts.begin(), style.grey_parts.end(),
                     [&](const std::string &grey) { return part == grey || part.starts_with(grey + "_"); });
}

/// Greys of the parts of a projectile, which follow each other in a frame.
constexpr std::array<double, 3> greys{0.62, 0.78, 0.46};

/// The field that gives the colour of a part's `count` particles or cells. Throws SetupError if the part lacks it or if
/// it is not one number for each.
const ogive::Field &colour_field(const std::vector<ogive::Field> &fields, const SectionStyle &style,
                                 const std::string &part, std::size_t count) {
  const ogive::Field &field = ogive::find_field(fields, style.field, part);
  ogive::require(field.values.size() == count, part + " " + field.name + " values", field.values.size(),
                 "must be one for each of " + std::to_string(count));
  return field;
}

/// An actor in the colours of its values, or grey: mostly ambient light, so that colours can be read off, some shading.
vtkSmartPointer<vtkActor> matt_actor(vtkMapper *mapper, vtkColorTransferFunction *colours, bool grey, double ambient) {
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetScalarVisibility(!grey);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(ambient);
  actor->GetProperty()->SetDiffuse(1 - ambient);
  actor->GetProperty()->SetSpecular(0);
  actor->GetProperty()->SetColor(0.47, 0.50, 0.54);
  return actor;
}

} // namespace

vtkSmartPointer<vtkColorTransferFunction> section_colours(const SectionStyle &style) {
  ogive::require(style.largest > style.smallest, "largest value of the colours", style.largest,
                 "must be above the smallest");
  constexpr double colours[][3] = {{0.80, 0.84, 0.88}, {0.98, 0.90, 0.55}, {0.98, 0.65, 0.25},
                                   {0.88, 0.32, 0.16}, {0.60, 0.06, 0.16}, {0.25, 0.02, 0.15}};
  constexpr int last = std::size(colours) - 1;
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int k = 0; k <= last; ++k)
    function->AddRGBPoint(style.smallest + (style.largest - style.smallest) * k / last, colours[k][0], colours[k][1],
                          colours[k][2]);
  return function;
}

vtkSmartPointer<vtkActor> section_actor(const ogive::PointCloud &cloud, ogive::SymmetryPlanes planes,
                                        const SectionStyle &style, vtkColorTransferFunction *colours) {
  const bool grey = drawn_grey(style, cloud.name);
  std::vector<ogive::Vec3<float>> positions;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  const ogive::Field *field = grey ? nullptr : &colour_field(cloud.fields, style, cloud.name, cloud.positions.size());
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    const ogive::Vec3<float> &x = cloud.positions[i];
    // Particles in the plane itself stay, whatever the round-off.
    if (!style.whole && x[1] < -0.01F * cloud.diameter) continue;
    for (int x_copy = 0; x_copy < (planes.x ? 2 : 1); ++x_copy)
      for (int y_copy = 0; y_copy < (style.whole && planes.y ? 2 : 1); ++y_copy) {
        vertices->InsertNextCell({static_cast<vtkIdType>(positions.size())});
        positions.emplace_back(x_copy == 0 ? x[0] : -x[0], y_copy == 0 ? x[1] : -x[1], x[2]);
        values->InsertNextValue(field ? field->values[i] : 0.F);
      }
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(ogive::to_vtk_points(positions));
  points->SetVerts(vertices);
  points->GetPointData()->SetScalars(values);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetRadius(static_cast<float>(style.particle_radius) * 1e3F * cloud.diameter);
  return matt_actor(mapper, colours, grey, style.particle_ambient);
}

vtkSmartPointer<vtkActor> section_actor(const ogive::HexGrid &hexes, ogive::SymmetryPlanes planes,
                                        const SectionStyle &style, vtkColorTransferFunction *colours) {
  const bool grey = drawn_grey(style, hexes.name);
  if (!grey) colour_field(hexes.cell_fields, style, hexes.name, hexes.hexes.size());
  vtkSmartPointer<vtkUnstructuredGrid> solid = ogive::to_vtk(hexes);
  if (!planes.y && !style.whole) {
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
  vtkSmartPointer<vtkAlgorithm> shown = surface.Get();
  for (const auto &[mirrored, plane] :
       {std::pair{planes.x, vtkReflectionFilter::USE_X}, {planes.y && style.whole, vtkReflectionFilter::USE_Y}}) {
    if (!mirrored) continue;
    vtkNew<vtkReflectionFilter> mirror;
    mirror->SetInputConnection(shown->GetOutputPort());
    mirror->SetPlane(plane);
    mirror->SetCenter(0);
    mirror->CopyInputOn();
    shown = mirror.Get();
  }
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(shown->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(style.field.c_str());
  auto actor = matt_actor(mapper, colours, grey, 0.55);
  if (grey && hexes.name.starts_with(std::string(projectile_name) + "_")) {
    const double shade = greys[static_cast<std::size_t>(std::abs(hexes.part)) % greys.size()];
    actor->GetProperty()->SetColor(shade, shade, shade);
  }
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetEdgeVisibility(style.mesh_edges);
  actor->GetProperty()->SetEdgeColor(0.36, 0.39, 0.43);
  actor->GetProperty()->SetLineWidth(1);
  return actor;
}

vtkSmartPointer<vtkRenderer> white_scene() {
  auto scene = vtkSmartPointer<vtkRenderer>::New();
  scene->SetBackground(1, 1, 1);
  scene->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.5, 0.7, 1.0);
  scene->AddLight(light);
  return scene;
}

void aim(vtkRenderer *scene, const SectionView &view) {
  vtkCamera *camera = scene->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(view.half_height_mm);
  const bool behind = view.from == Seen::behind;
  const double z = behind ? 0 : view.centre_z_mm;
  const std::array<double, 3> way = behind                       ? std::array{0., 0., -1000.}
                                    : view.from == Seen::oblique ? std::array{-480., -760., 440.}
                                                                 : std::array{0., -1000., 0.};
  camera->SetFocalPoint(view.centre_x_mm, 0, z);
  camera->SetPosition(view.centre_x_mm + way[0], way[1], z + way[2]);
  camera->SetViewUp(0, behind ? 1 : 0, behind ? 0 : 1);
  scene->ResetCameraClippingRange();
}

vtkSmartPointer<vtkRenderer> section_scene(const ogive::Frame &frame, const SectionStyle &style,
                                           vtkColorTransferFunction *colours, const SectionView &view) {
  auto scene = white_scene();
  SectionStyle shown = style;
  shown.whole = view.from == Seen::behind;
  for (const auto &cloud : frame.clouds) scene->AddActor(section_actor(cloud, frame.symmetry, shown, colours));
  for (const auto &grid : frame.grids)
    if (view.from != Seen::behind || !is_of_projectile(grid.name))
      scene->AddActor(section_actor(grid, frame.symmetry, shown, colours));
  aim(scene, view);
  return scene;
}

} // namespace draw
