#pragma once

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/display.hpp"
#include "ogive/io/section_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vtkActor2D.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

// Without these VTK has no renderer and no fonts; here, so that whoever includes this header need not know.
VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)

namespace ogive {

/// What a picture of the section shows, and how large.
struct SectionPicture {
  SectionStyle style{};
  std::string title{};        ///< one line above the picture: case, time, velocity
  std::string bar_title{};    ///< beside the colours; the field's name if empty
  double half_height_mm = 30; ///< half of what is seen from bottom to top
  double centre_z_mm = -8;    ///< height in the middle of the picture; the plate's front face is z = 0
  double scale_bar_mm = 10;   ///< length of the scale bar
  int width = 1600;           ///< pixels
  int height = 1200;          ///< pixels
};

/// A line of text at (x, y) of the page, both 0 to 1.
inline vtkSmartPointer<vtkTextActor> page_text(const std::string &text, double x, double y, int size) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedDisplay();
  actor->SetPosition(x, y);
  return actor;
}

/// A horizontal bar from (x, y) of the page, `length` long, both in units of the page.
inline vtkSmartPointer<vtkActor2D> page_bar(double x, double y, double length, double thickness) {
  vtkNew<vtkPoints> corners;
  for (const auto &[dx, dy] : {std::pair{0., 0.}, {length, 0.}, {length, thickness}, {0., thickness}})
    corners->InsertNextPoint(x + dx, y + dy, 0);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> bar;
  bar->SetPoints(corners);
  bar->SetPolys(quads);
  vtkNew<vtkCoordinate> page;
  page->SetCoordinateSystemToNormalizedDisplay();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(bar);
  mapper->SetTransformCoordinate(page);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.1, 0.1, 0.1);
  return actor;
}

/// The colours with their values, at the right of the page.
inline vtkSmartPointer<vtkScalarBarActor> colour_bar(vtkColorTransferFunction *colours, const std::string &title,
                                                     int font_size) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours);
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(6);
  bar->SetMaximumNumberOfColors(256);
  bar->SetLabelFormat(" %.3g");
  bar->UnconstrainedFontSizeOn();
  for (auto *text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(font_size);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  bar->SetVerticalTitleSeparation(font_size / 2);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.885, 0.16);
  bar->SetWidth(0.10);
  bar->SetHeight(0.68);
  bar->SetBarRatio(0.28);
  return bar;
}

/// Draws the section y = 0 of a frame as a PNG: the half behind the plane, seen along y with z upwards, mirrored at
/// x = 0 if that is a symmetry plane. The computed part of a model lies where the coordinates of its symmetry planes
/// are positive. Throws SetupError if a part lacks the field asked for, WriteError if there is no display to draw on
/// (see display_available) or the file cannot be written.
inline void render_section(const Frame &frame, SymmetryPlanes planes, const std::filesystem::path &path,
                           const SectionPicture &picture = {}) {
  require(picture.width >= 64 && picture.height >= 64 && picture.width <= 16384 && picture.height <= 16384,
          "size of the picture", std::to_string(picture.width) + " x " + std::to_string(picture.height),
          "must be 64 to 16384 pixels each way");
  require(picture.half_height_mm > 0, "half height of the picture (mm)", picture.half_height_mm, "must be positive");
  require(picture.style.largest > picture.style.smallest, "largest value of the colours", picture.style.largest,
          "must be above the smallest");
  const auto colours = section_colours(picture.style);
  const double scene_width = 0.87, scene_height = 0.93;
  const double page_width_mm = 2 * picture.half_height_mm / scene_height * picture.width / picture.height;
  const int font_size = std::max(8, picture.height / 36);

  vtkNew<vtkRenderer> scene;
  scene->SetViewport(0, 0, scene_width, scene_height);
  scene->SetBackground(1, 1, 1);
  for (const auto &cloud : frame.clouds) scene->AddActor(section_actor(cloud, planes, picture.style, colours));
  for (const auto &grid : frame.grids) scene->AddActor(section_actor(grid, planes, picture.style, colours));
  vtkCamera *camera = scene->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(picture.half_height_mm);
  camera->SetFocalPoint(0, 0, picture.centre_z_mm);
  camera->SetPosition(0, -1000, picture.centre_z_mm);
  camera->SetViewUp(0, 0, 1);
  scene->ResetCameraClippingRange();
  scene->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.5, 0.7, 1.0);
  scene->AddLight(light);

  vtkNew<vtkRenderer> page;
  page->SetBackground(1, 1, 1);
  page->AddActor2D(page_text(picture.title, 0.5, 0.965, font_size + 4));
  page->AddActor2D(colour_bar(colours, picture.bar_title.empty() ? picture.style.field : picture.bar_title, font_size));

  vtkNew<vtkRenderer> scale;
  scale->SetLayer(1);
  const double bar_length = picture.scale_bar_mm / page_width_mm;
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", picture.scale_bar_mm);
  scale->AddActor2D(page_bar(0.03, 0.04, bar_length, 0.006));
  scale->AddActor2D(page_text(label, 0.03 + bar_length / 2, 0.07, font_size));

  // VTK crashes at its first window where there is none.
  if (!display_available())
    throw write_error(path, "drawing needs an X server with GLX; set DISPLAY, or run the program under xvfb-run");
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(picture.width, picture.height);
  window->SetNumberOfLayers(2);
  window->AddRenderer(page);
  window->AddRenderer(scene);
  window->AddRenderer(scale);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> png;
  png->SetInputConnection(image->GetOutputPort());
  png->WriteToMemoryOn();
  png->Write();
  vtkUnsignedCharArray *result = png->GetResult();
  if (result == nullptr || result->GetNumberOfValues() == 0) throw write_error(path, "VTK drew nothing");
  write_atomically(path, {reinterpret_cast<const char *>(result->GetPointer(0)),
                          static_cast<std::size_t>(result->GetNumberOfValues())});
}

} // namespace ogive
