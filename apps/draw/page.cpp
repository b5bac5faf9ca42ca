// SPDX-License-Identifier: BSD-3-Clause
#include "page.hpp"

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vtkActor2D.h>
#include <vtkAutoInit.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

// Without these VTK has no renderer and no fonts.
VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)

namespace draw {

namespace {

/// The places where EGL may draw, the best first: memory alone, as Mesa has it; a graphics card without a display, for
/// drivers that know no other way; and an X server or its like, a virtual one too.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> all{eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)};
  if (const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"))) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query(EGLint(devices.size()), devices.data(), &count))
      for (EGLint k = 0; k < count; ++k)
        all.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(k)], nullptr));
  }
  all.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return all;
}

/// OpenGL that draws into memory, current in this thread: EGL without a surface. Debian's VTK itself would open a
/// window on an X server, and crash or wait where none answers.
struct Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  bool current = false;

  Context() {
    for (EGLDisplay one : displays()) {
      if (one == EGL_NO_DISPLAY || !eglInitialize(one, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) continue;
      constexpr EGLint version_3_2[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
      context = eglCreateContext(one, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version_3_2);
      display = one;
      current = context != EGL_NO_CONTEXT && eglMakeCurrent(one, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
      if (current) return;
      if (context != EGL_NO_CONTEXT) eglDestroyContext(one, context);
      context = EGL_NO_CONTEXT;
    }
  }
  ~Context() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
  Context(const Context &) = delete;
  Context &operator=(const Context &) = delete;
};

/// A window of VTK's on the context that is current.
struct Window : vtkGenericOpenGLRenderWindow {
  static Window *New() { VTK_STANDARD_NEW_BODY(Window); }

  void OpenGLInitContext() override {
    if (Initialized) return;
    // It finds the functions of OpenGL and then misses those of GLX, which a picture in memory does not need.
    const int warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    vtkGenericOpenGLRenderWindow::OpenGLInitContext();
    vtkObject::SetGlobalWarningDisplay(warnings);
    GlewInitValid = Initialized = true;
  }
};

/// The lower left corner and the size of a box in units of the page.
Box in_page_units(const Page &page, const Box &box) {
  return {box.x / page.width, box.y / page.height, box.width / page.width, box.height / page.height};
}

/// Contents of the window: red, green and blue of each pixel.
vtkSmartPointer<vtkImageData> pixels(vtkRenderWindow *window, int levels) {
  window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->Update();
  vtkSmartPointer<vtkImageData> image = capture->GetOutput();
  auto *bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) return nullptr;
  std::array<unsigned char, 256> rounded{};
  for (int v = 0; v < 256; ++v)
    rounded[static_cast<std::size_t>(v)] =
        static_cast<unsigned char>(std::lround(255.0 * std::round(v * (levels - 1) / 255.0) / (levels - 1)));
  std::transform(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues(), bytes->GetPointer(0),
                 [&](unsigned char v) { return rounded[v]; });
  return image;
}

} // namespace

Page white_page(int width, int height) {
  ogive::require(width >= 64 && height >= 64 && width <= 16384 && height <= 16384, "size of the picture",
                 std::to_string(width) + " x " + std::to_string(height), "must be 64 to 16384 pixels each way");
  static std::mutex mutex;
  Page page{width, height, vtkNew<vtkRenderer>(), vtkNew<vtkRenderer>(), {}, std::unique_lock(mutex)};
  page.ground->SetBackground(1, 1, 1);
  page.ink->SetLayer(1);
  return page;
}

void add_scene(Page &page, vtkSmartPointer<vtkRenderer> scene, const Box &box) {
  const Box at = in_page_units(page, box);
  scene->SetViewport(at.x, at.y, at.x + at.width, at.y + at.height);
  page.scenes.push_back(std::move(scene));
}

double text_width(const std::string &text, int size) {
  vtkNew<vtkTextProperty> property;
  property->SetFontSize(size);
  std::array<int, 4> box{};
  // The renderer's pages have VTK's usual 72 dots per inch.
  vtkTextRenderer *renderer = vtkTextRenderer::GetInstance();
  if (text.empty() || !renderer || !renderer->GetBoundingBox(property, text, box.data(), 72)) return 0;
  return box[1] - box[0] + 1;
}

int fitting_size(const std::string &text, int size, double width) {
  const double wide = text_width(text, size);
  return wide <= width ? size : std::max(8, static_cast<int>(size * width / wide));
}

void add_text(Page &page, const std::string &text, const Box &box, int size) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->GetTextProperty()->SetFontSize(fitting_size(text, size, box.width));
  actor->GetTextProperty()->SetColor(page_ink[0], page_ink[1], page_ink[2]);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  const Box at = in_page_units(page, box);
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedDisplay();
  actor->SetPosition(at.x + at.width / 2, at.y + at.height / 2);
  page.ink->AddActor2D(actor);
}

void add_bar(Page &page, const Box &box) {
  const Box at = in_page_units(page, box);
  vtkNew<vtkPoints> corners;
  for (const auto &[dx, dy] : {std::pair{0., 0.}, {at.width, 0.}, {at.width, at.height}, {0., at.height}})
    corners->InsertNextPoint(at.x + dx, at.y + dy, 0);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> bar;
  bar->SetPoints(corners);
  bar->SetPolys(quads);
  vtkNew<vtkCoordinate> display;
  display->SetCoordinateSystemToNormalizedDisplay();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(bar);
  mapper->SetTransformCoordinate(display);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(page_ink[0], page_ink[1], page_ink[2]);
  page.ink->AddActor2D(actor);
}

void add_colour_bar(Page &page, vtkColorTransferFunction *colours, int font_size, const Box &box) {
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
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
  const Box at = in_page_units(page, box);
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(at.x, at.y);
  bar->SetWidth(at.width);
  bar->SetHeight(at.height);
  bar->SetBarRatio(0.28);
  page.ink->AddActor2D(bar);
}

void write_png(const Page &page, const std::filesystem::path &path, int levels, int compression) {
  const Context context;
  if (!context.current)
    throw ogive::write_error(path, "drawing needs EGL of Mesa 3D (Debian: libegl1 and libgl1-mesa-dri)");
  vtkNew<Window> window;
  window->SetIsCurrent(true);
  window->SetForceMaximumHardwareLineWidth(255);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(page.width, page.height);
  window->SetNumberOfLayers(2);
  window->AddRenderer(page.ground);
  for (const auto &scene : page.scenes) window->AddRenderer(scene);
  window->AddRenderer(page.ink);
  const auto image = pixels(window, levels);
  if (image == nullptr) throw ogive::write_error(path, "VTK drew nothing");
  vtkNew<vtkPNGWriter> png;
  png->SetInputData(image);
  png->SetCompressionLevel(compression);
  png->WriteToMemoryOn();
  png->Write();
  vtkUnsignedCharArray *result = png->GetResult();
  if (result == nullptr || result->GetNumberOfValues() == 0) throw ogive::write_error(path, "VTK cannot encode it");
  ogive::write_atomically(path, {reinterpret_cast<const char *>(result->GetPointer(0)),
                                 static_cast<std::size_t>(result->GetNumberOfValues())});
}

} // namespace draw
