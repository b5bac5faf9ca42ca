// SPDX-License-Identifier: BSD-3-Clause
#include "model.hpp"

#include "ogive/io/text.hpp"
#include "page.hpp"
#include "scene.hpp"

#include "options/text.hpp"

#include <vtkCamera.h>
#include <vtkProperty.h>

namespace draw {

namespace {

using ogive::Frame;

constexpr int page_width = 1400, top_height = 644, label_height = 54, lower_height = 500, font_size = 28;

template <class Part> void add_part(vtkRenderer *scene, const Part &part, ogive::SymmetryPlanes planes) {
  // Balls that do not touch are seen one by one.
  SectionStyle style{.grey_parts = {part.name}, .particle_radius = 0.5, .particle_ambient = 0.7};
  const auto actor = section_actor(part, planes, style, section_colours(style));
  const std::array colour = part.name == "disc"  ? std::array{0.93, 0.66, 0.30}
                            : part.name == "rim" ? std::array{0.70, 0.79, 0.88}
                                                 : std::array{0.78, 0.80, 0.84};
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetEdgeColor(0.33, 0.36, 0.40);
  scene->AddActor(actor);
}

vtkSmartPointer<vtkRenderer> scene_of(const Frame &frame, ogive::SymmetryPlanes planes) {
  auto scene = white_scene();
  for (const auto &cloud : frame.clouds) add_part(scene, cloud, planes);
  for (const auto &grid : frame.grids) add_part(scene, grid, planes);
  return scene;
}

/// Points the camera at the quarter from outside of its mirror planes, from above.
void aim_from_outside(vtkRenderer *scene, const std::array<double, 3> &centre, double distance_mm, double angle) {
  vtkCamera *camera = scene->GetActiveCamera();
  camera->SetViewAngle(angle);
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(centre[0] - 0.52 * distance_mm, centre[1] - 0.62 * distance_mm, centre[2] + 0.58 * distance_mm);
  camera->SetViewUp(0, 0, 1);
  scene->ResetCameraClippingRange();
}

/// The lowest z of the target, mm.
double low_mm(const Frame &frame) {
  double low = 0;
  for (const auto &cloud : frame.clouds)
    for (const auto &x : cloud.positions) low = std::min(low, 1e3 * (x[2] - cloud.diameter / 2.0));
  for (const auto &grid : frame.grids)
    for (const auto &x : grid.positions) low = std::min(low, 1e3 * x[2]);
  return low;
}

/// "(a) quarter model: 25820 particles, 1344 hexes in the plate, 1120 in the projectile"
std::string parts_text(const Frame &frame) {
  std::size_t particles = 0, plate = 0, projectile = 0;
  for (const auto &cloud : frame.clouds) particles += cloud.positions.size();
  for (const auto &grid : frame.grids) (is_of_projectile(grid.name) ? projectile : plate) += grid.hexes.size();
  const char *extent = frame.symmetry.x ? "quarter" : frame.symmetry.y ? "half" : "full";
  return options::printed("(a) %s model: %zu particles, %zu hexes in the plate, %zu in the projectile", extent,
                          particles, plate, projectile);
}

} // namespace

void render_model(const Frame &frame, const std::string &title, const std::filesystem::path &path) {
  const int title_height = title.empty() ? 10 : 64, upper = lower_height + 2 * label_height;
  Page page = white_page(page_width, upper + top_height + title_height);
  const auto add_line = [&](const std::string &text, double low, double high, int size) {
    add_text(page, text, narrowed({0, low, page_width, high - low}, 0.98), size);
  };

  // The part seen from outside is neither mirrored nor cut.
  const auto whole = scene_of(frame, {false, true});
  const double depth = low_mm(frame);
  aim_from_outside(whole, {83, 97, 2 + depth}, 690 - depth, 16);
  add_scene(page, whole, {0, upper, page_width, top_height});
  add_line(parts_text(frame), upper - label_height, upper, font_size);

  const auto near = scene_of(frame, frame.symmetry);
  const double high = 16, low = depth - 4;
  aim(near, {0, (low + high) / 2, (high - low) / 2});
  add_scene(page, near, {0, label_height, page_width, lower_height});
  const std::string particles =
      frame.clouds.empty() ? "" : options::printed(": particles %.3g mm apart", 1e3 * frame.clouds.front().diameter);
  add_line("(b) section at the impact point" + particles, 0, label_height, font_size);
  add_line(title, page.height - title_height, page.height, font_size + 4);
  write_png(page, path, 52);
}

} // namespace draw
