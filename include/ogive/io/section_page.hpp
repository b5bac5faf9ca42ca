// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vtkActor2D.h>
#include <vtkAutoInit.h>
#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

// Without these VTK has no renderer and no fonts; here, so that whoever includes this header need not know.
VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)

/// \file
/// What stands around scenes on a page: text, bars, colours with their values; and the page as a PNG.

namespace ogive {

/// A rectangle on a page, from its lower left corner. Fractions of the page, or pixels where said so.
struct PageBox {
  double x = 0, y = 0, width = 0, height = 0; ///< lower left corner and size
};

/// The ink of text and bars.
inline constexpr std::array page_ink{0.1, 0.1, 0.1};

/// A line of text at (x, y) of the page, both 0 to 1.
inline vtkSmartPointer<vtkTextActor> page_text(const std::string &text, double x, double y, int size) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(page_ink[0], page_ink[1], page_ink[2]);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedDisplay();
  actor->SetPosition(x, y);
  return actor;
}

/// Width of a line of page_text, pixels.
inline double page_text_width(const std::string &text, int size) {
  vtkNew<vtkTextProperty> property;
  property->SetFontSize(size);
  std::array<int, 4> box{};
  // The renderer's pages have VTK's usual 72 dots per inch.
  vtkTextRenderer *renderer = vtkTextRenderer::GetInstance();
  if (text.empty() || !renderer || !renderer->GetBoundingBox(property, text, box.data(), 72)) return 0;
  return box[1] - box[0] + 1;
}

/// The largest size up to `size` at which the text is at most `width` pixels wide, and at least 8.
inline int fitting_size(const std::string &text, int size, double width) {
  const double wide = page_text_width(text, size);
  return wide <= width ? size : std::max(8, static_cast<int>(size * width / wide));
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
  actor->GetProperty()->SetColor(page_ink[0], page_ink[1], page_ink[2]);
  return actor;
}

/// The colours with their values, the title above them, in a box of the page.
inline vtkSmartPointer<vtkScalarBarActor> colour_bar(vtkColorTransferFunction *colours, const std::string &title,
                                                     int font_size, const PageBox &box) {
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours);
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(6);
  bar->SetMaximumNumberOfColors(256);
  bar->SetLabelFormat(" %.3g");
  bar->UnconstrainedFontSizeOn();
  for (auto *text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetColor(page_ink[0], page_ink[1], page_ink[2]);
    text->SetFontSize(font_size);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  bar->SetVerticalTitleSeparation(font_size / 2);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(box.x, box.y);
  bar->SetWidth(box.width);
  bar->SetHeight(box.height);
  bar->SetBarRatio(0.28);
  return bar;
}

/// A window of a size in pixels that nobody sees. Throws WriteError, with the name of the picture to be, if there is no
/// display to draw on (see display_available).
inline vtkSmartPointer<vtkRenderWindow> picture_window(int width, int height, const std::filesystem::path &path) {
  // VTK crashes at its first window where there is none.
  if (!display_available())
    throw write_error(path, "drawing needs an X server with GLX; set DISPLAY, or run the program under xvfb-run");
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(width, height);
  return window;
}

/// Draws a window and writes it as a PNG. With fewer than 256 `levels` of red, green and blue each the shading of many
/// small balls takes half the bytes or less; white stays white. Throws WriteError.
inline void write_png(const std::filesystem::path &path, vtkRenderWindow *window, int levels = 256) {
  window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->Update();
  vtkImageData *image = capture->GetOutput();
  auto *bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) throw write_error(path, "VTK drew nothing");
  std::array<unsigned char, 256> rounded{};
  for (int v = 0; v < 256; ++v)
    rounded[static_cast<std::size_t>(v)] =
        static_cast<unsigned char>(std::lround(255.0 * std::round(v * (levels - 1) / 255.0) / (levels - 1)));
  std::transform(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues(), bytes->GetPointer(0),
                 [&](unsigned char v) { return rounded[v]; });
  vtkNew<vtkPNGWriter> png;
  png->SetInputData(image);
  png->SetCompressionLevel(9);
  png->WriteToMemoryOn();
  png->Write();
  vtkUnsignedCharArray *result = png->GetResult();
  if (result == nullptr || result->GetNumberOfValues() == 0) throw write_error(path, "VTK cannot encode it");
  write_atomically(path, {reinterpret_cast<const char *>(result->GetPointer(0)),
                          static_cast<std::size_t>(result->GetNumberOfValues())});
}

} // namespace ogive
