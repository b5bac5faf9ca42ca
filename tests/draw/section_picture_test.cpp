// SPDX-License-Identifier: BSD-3-Clause
#include "draw/section.hpp"

#include "draw/png_pixels.hpp"
#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"
#include "ogive/io/write_error.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

using namespace draw;
using ogive::Frame;

namespace {

/// The sample as the quarter of a model.
Frame quarter() {
  Frame frame = sample::perforated_plate();
  frame.symmetry = {true, true};
  return frame;
}

constexpr double low_mm = -38, high_mm = 22;

void draw_section(const Frame &frame, const std::filesystem::path &path) {
  render_section({frame, "60 µs, 141 m/s"}, "12 mm, blunt", low_mm, path);
}

/// The colour at a place of the section, mm.
PixelColour colour_at(vtkImageData *image, double x_mm, double z_mm) {
  SectionPanel panel{.title = "title", .low_mm = low_mm, .high_mm = high_mm, .height = 1200};
  panel.radius_mm = 0.62 * (high_mm - low_mm);
  const PanelLayout layout = panel_layout(1, panel);
  const Box &cell = layout.cells[0];
  return pixel(image, cell.x + cell.width / 2 + layout.pixels_per_mm * x_mm,
               cell.y + cell.height / 2 + layout.pixels_per_mm * (z_mm - (low_mm + high_mm) / 2));
}

void check_section(vtkImageData *image) {
  CHECK(image->GetDimensions()[0] > 1500);
  CHECK(image->GetDimensions()[1] > 1100);
  for (const double side : {-1.0, 1.0}) {
    INFO("side " << side);
    CHECK(white(colour_at(image, 20 * side, 10)));
    CHECK(white(colour_at(image, 20 * side, -25)));
    for (const auto &[x, z] : {std::pair{4., 5.}, {17., -6.}, {30., -6.}, {4., -15.}})
      CHECK_FALSE(white(colour_at(image, x * side, z)));
    CHECK(reddish(colour_at(image, 9.5 * side, -18)));
    CHECK_FALSE(reddish(colour_at(image, 3 * side, -15)));
    CHECK_FALSE(reddish(colour_at(image, 30 * side, -6)));
  }
}

} // namespace

TEST_CASE("a picture needs no display, and waits for none") {
  const TemporaryFolder folder;
  const char *before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  for (const char *name : {"", ":987654", "nonsense"}) {
    ::setenv("DISPLAY", name, 1);
    draw_section(quarter(), folder.path / "a.png");
    check_section(read_png(folder.path / "a.png"));
  }
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
  else
    ::unsetenv("DISPLAY");
}

TEST_CASE("pictures drawn by several threads at once are those drawn one by one") {
  const TemporaryFolder folder;
  const auto file = [&](int k) { return folder.path / ("picture_" + std::to_string(k) + ".png"); };
  draw_section(quarter(), file(0));
  std::vector<std::thread> threads;
  for (int k = 1; k <= 3; ++k) threads.emplace_back([&, k] { draw_section(quarter(), file(k)); });
  for (auto &thread : threads) thread.join();
  for (int k = 1; k <= 3; ++k) CHECK(read_text(file(k)) == read_text(file(0)));
}

TEST_CASE("the projectile is darker than the plate") {
  const TemporaryFolder folder;
  draw_section(quarter(), folder.path / "a.png");
  const auto image = read_png(folder.path / "a.png");
  CHECK(colour_at(image, 4, 5)[1] + 40 < colour_at(image, 31, -5.2)[1]);
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("the section of a model without symmetry is cut open") {
  const TemporaryFolder folder;
  const Frame part = sample::perforated_plate();
  Frame frame;
  for (const float x_sign : {1.F, -1.F})
    for (const float y_sign : {1.F, -1.F}) {
      Frame turned = part;
      const auto turn = [&](auto &body, ogive::Field &strain) {
        for (auto &x : body.positions) x = ogive::Vec3<float>(x_sign * x[0], y_sign * x[1], x[2]);
        // The half in front would hide the section: all of it is marked by strain.
        if (y_sign < 0) std::fill(strain.values.begin(), strain.values.end(), 1.F);
      };
      turn(turned.clouds[0], turned.clouds[0].fields[0]);
      for (auto &grid : turned.grids) turn(grid, grid.cell_fields[0]);
      frame.clouds.push_back(turned.clouds[0]);
      frame.grids.insert(frame.grids.end(), turned.grids.begin(), turned.grids.end());
    }
  draw_section(frame, folder.path / "section.png");
  check_section(read_png(folder.path / "section.png"));
}

TEST_CASE("a picture that cannot be written is an error") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(draw_section(quarter(), folder.path / "gone" / "a.png"), ogive::WriteError);
}
