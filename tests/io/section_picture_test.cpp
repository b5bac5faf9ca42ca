// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/section_picture.hpp"

#include "io/png_pixels.hpp"
#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cstdlib>

using namespace ogive;

namespace {

/// The colour at a place of the section (mm) in a picture 800 x 600 with a half height of 30 mm around z = -8 mm.
PixelColour colour_at(vtkImageData *image, double x_mm, double z_mm) {
  const double pixels_per_mm = 600 * 0.93 / 60;
  return pixel(image, 800 * 0.87 / 2 + pixels_per_mm * x_mm, 600 * 0.93 / 2 + pixels_per_mm * (z_mm + 8));
}

SectionPicture small_picture() {
  SectionPicture picture;
  picture.width = 800;
  picture.height = 600;
  picture.title = "t = 60 µs, v = 141 m/s";
  picture.style.mesh_edges = false;
  return picture;
}

void check_section(vtkImageData *image) {
  REQUIRE(image->GetDimensions()[0] == 800);
  REQUIRE(image->GetDimensions()[1] == 600);
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

TEST_CASE("without a display a picture is refused, and a program goes on") {
  const TemporaryFolder folder;
  const char *before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  for (const char *name : {"", ":987654", "nonsense"}) {
    ::setenv("DISPLAY", name, 1);
    CHECK_FALSE(display_available());
    CHECK_THROWS_AS(render_section(sample::perforated_plate(), {true, true}, folder.path / "a.png"), WriteError);
  }
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
  else
    ::unsetenv("DISPLAY");
  CHECK(count_files(folder.path) == 0);
}

TEST_CASE("a picture's size, range and field are checked") {
  const TemporaryFolder folder;
  const auto refuse = [&](const SectionPicture &picture) {
    CHECK_THROWS_AS(render_section(sample::perforated_plate(), {true, true}, folder.path / "a.png", picture),
                    SetupError);
  };
  auto picture = small_picture();
  picture.width = 0;
  refuse(picture);
  picture = small_picture();
  picture.half_height_mm = 0;
  refuse(picture);
  picture = small_picture();
  picture.style.largest = picture.style.smallest;
  refuse(picture);
  picture = small_picture();
  for (const char *field : {"heat", "velocity_m_per_s"}) {
    picture.style.field = field;
    refuse(picture);
  }
}

TEST_CASE("the section of a quarter model shows both halves, the plug's shear band and the projectile") {
  if (!display_available()) {
    WARN("skipped: there is no display");
    return;
  }
  const TemporaryFolder folder;
  const auto path = folder.path / "section.png";
  render_section(sample::perforated_plate(), {true, true}, path, small_picture());
  const auto image = read_png(path);
  check_section(image);
  const PixelColour projectile = colour_at(image, 4, 5), plate = colour_at(image, 30, -6);
  CHECK(projectile[1] + 40 < plate[1]);
  CHECK(count_files(folder.path) == 1);
}

TEST_CASE("the section of a model without symmetry is cut open") {
  if (!display_available()) {
    WARN("skipped: there is no display");
    return;
  }
  const TemporaryFolder folder;
  const Frame quarter = sample::perforated_plate();
  Frame frame;
  for (const float x_sign : {1.F, -1.F})
    for (const float y_sign : {1.F, -1.F}) {
      Frame turned = quarter;
      const auto turn = [&](auto &part, Field &strain) {
        for (auto &x : part.positions) x = Vec3<float>(x_sign * x[0], y_sign * x[1], x[2]);
        // The half in front would hide the section: all of it is marked by strain.
        if (y_sign < 0) std::fill(strain.values.begin(), strain.values.end(), 1.F);
      };
      turn(turned.clouds[0], turned.clouds[0].fields[0]);
      for (auto &grid : turned.grids) turn(grid, grid.cell_fields[0]);
      frame.clouds.push_back(turned.clouds[0]);
      frame.grids.insert(frame.grids.end(), turned.grids.begin(), turned.grids.end());
    }
  render_section(frame, {}, folder.path / "section.png", small_picture());
  check_section(read_png(folder.path / "section.png"));
}

TEST_CASE("a picture that cannot be written says so") {
  if (!display_available()) {
    WARN("skipped: there is no display");
    return;
  }
  const TemporaryFolder folder;
  CHECK_THROWS_AS(
      render_section(sample::perforated_plate(), {true, true}, folder.path / "gone" / "a.png", small_picture()),
      WriteError);
}
