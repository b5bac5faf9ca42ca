// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include "ogive/io/section_page.hpp"
#include "ogive/io/section_scene.hpp"
#include "ogive/material/library.hpp"
#include "ogive/perforation/setup.hpp"

#include <cstdio>

namespace section {

namespace {

using ogive::Frame;
using Colour3 = std::array<double, 3>;

constexpr int page_width = 1400, top_height = 644, label_height = 54, lower_height = 500, font_size = 28;

/// The model before its first step.
Frame first_frame(const Options &o) {
  ogive::PerforationCase<double> c;
  c.thickness = o.thickness_mm * 1e-3;
  c.spacing = o.spacing_mm * 1e-3;
  c.projectile = ogive::paper_projectile<double>(o.nose);
  return ogive::gather_frame(
      ogive::make_perforation(c, ogive::library::weldox_460e_mjc<double>(), ogive::library::arne_tool_steel<double>()));
}

template <class Part> void add_part(vtkRenderer *scene, const Part &part, ogive::SymmetryPlanes planes) {
  // Balls that do not touch are seen one by one.
  ogive::SectionStyle style{.grey_parts = {part.name}, .particle_radius = 0.5, .particle_ambient = 0.7};
  const auto actor = section_actor(part, planes, style, section_colours(style));
  const Colour3 colour = part.name == "disc"  ? Colour3{0.93, 0.66, 0.30}
                         : part.name == "rim" ? Colour3{0.70, 0.79, 0.88}
                                              : Colour3{0.78, 0.80, 0.84};
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetEdgeColor(0.33, 0.36, 0.40);
  scene->AddActor(actor);
}

vtkSmartPointer<vtkRenderer> scene_of(const Frame &frame, ogive::SymmetryPlanes planes) {
  auto scene = ogive::white_scene();
  for (const auto &cloud : frame.clouds) add_part(scene, cloud, planes);
  for (const auto &grid : frame.grids) add_part(scene, grid, planes);
  return scene;
}

/// Looks at the quarter from outside of its mirror planes, from above.
void look_down(vtkRenderer *scene, const std::array<double, 3> &centre, double distance_mm, double angle) {
  vtkCamera *camera = scene->GetActiveCamera();
  camera->SetViewAngle(angle);
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(centre[0] - 0.52 * distance_mm, centre[1] - 0.62 * distance_mm, centre[2] + 0.58 * distance_mm);
  camera->SetViewUp(0, 0, 1);
  scene->ResetCameraClippingRange();
}

std::size_t hexes_of(const Frame &frame, const char *name) {
  for (const auto &grid : frame.grids)
    if (grid.name == name) return grid.hexes.size();
  return 0;
}

} // namespace

void draw_mesh(const Options &o) {
  const Frame frame = first_frame(o);
  const auto &disc = frame.clouds.front();
  const int title_height = o.title.empty() ? 10 : 64;
  const int height = top_height + lower_height + 2 * label_height + title_height;

  const auto window = ogive::picture_window(page_width, height, o.out);
  vtkNew<vtkRenderer> page;
  page->SetBackground(1, 1, 1);
  window->AddRenderer(page);
  const auto add_text = [&](const std::string &text, double y, int size) {
    page->AddActor2D(ogive::page_text(text, 0.5, y / height, ogive::fitting_size(text, size, 0.98 * page_width)));
  };
  const auto place = [&](vtkRenderer *scene, double low, double high) {
    scene->SetViewport(0, low / height, 1, high / height);
    window->AddRenderer(scene);
  };

  // A quarter seen from outside is neither mirrored nor cut.
  const auto whole = scene_of(frame, {false, true});
  look_down(whole, {83, 97, 2 - o.thickness_mm}, 690 + o.thickness_mm, 16);
  place(whole, lower_height + 2 * label_height, lower_height + 2 * label_height + top_height);
  char text[200];
  std::snprintf(text, sizeof text, "(a) quarter model: %zu particles, %zu hexes in the plate, %zu in the projectile",
                disc.positions.size(), hexes_of(frame, "rim"), hexes_of(frame, "projectile"));
  add_text(text, lower_height + 1.5 * label_height, font_size);

  const auto near = scene_of(frame, frame.symmetry);
  const double high = 16, low = -o.thickness_mm - 4;
  ogive::aim(near, {0, (low + high) / 2, (high - low) / 2});
  place(near, label_height, label_height + lower_height);
  std::snprintf(text, sizeof text, "(b) section at the impact point: particles %.3g mm apart", 1e3 * disc.diameter);
  add_text(text, 0.5 * label_height, font_size);
  add_text(o.title, height - title_height / 2.0, font_size + 4);
  ogive::write_png(o.out, window, 52);
}

} // namespace section
