// SPDX-License-Identifier: BSD-3-Clause
#include "draw/film.hpp"

#include "draw/frame_facts.hpp"
#include "draw/png_pixels.hpp"
#include "draw/process.hpp"
#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

#include <chrono>
#include <cstdlib>
#include <unistd.h>

using namespace draw;

namespace {

/// A quarter that is pushed through by 4 mm a frame, at 0, 10, 20, ... us.
ogive::StoredSeries sample_series(const std::filesystem::path &folder, int frames) {
  auto series = ogive::open_series(folder, "perforation");
  for (int k = 0; k < frames; ++k) {
    auto frame = sample::perforated_plate(4e-3F * float(k), 2e-3F);
    frame.time = 10e-6 * k;
    frame.symmetry = {true, true};
    ogive::add_frame(series, frame);
  }
  return ogive::read_series(folder / "perforation.pvd");
}

/// The picture number `k` of a film.
vtkSmartPointer<vtkImageData> picture_of(const std::filesystem::path &film, int k) {
  const auto picture = film.parent_path() / "picture.png";
  const std::string select = "select=eq(n\\," + std::to_string(k) + ")";
  REQUIRE(run_program("ffmpeg",
                      {"-v", "error", "-y", "-i", film.string(), "-vf", select, "-frames:v", "1", "-update", "1",
                       picture.string()},
                      60) == 0);
  return read_png(picture);
}

double seconds_of(const std::function<void()> &act) {
  const auto begin = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

TEST_CASE("the endings of films") {
  for (const char *name : {"a.mp4", "b/a.webm", "a.gif", "a.apng"}) CHECK(is_film(name));
  for (const char *name : {"a.png", "mp4", ".mp4", "a.MP4", "a.avi", ""}) CHECK_FALSE(is_film(name));
}

TEST_CASE("a film has the frames of its series in every form, and moves") {
  if (!ffmpeg_available()) {
    WARN("ffmpeg is missing (Debian: ffmpeg)");
    return;
  }
  const TemporaryFolder folder;
  const auto series = sample_series(folder.path, 3);
  Film film;
  film.panel.width = film.panel.height = 240;
  film.panel.font_size = 9;
  film.frames_per_second = 1;
  SectionPanel seen = film.panel;
  seen.low_mm = extended({}, ogive::read_frame(series, 2)).low_mm;
  const Box cell = panel_layout(1, seen).cells[0];
  const auto colour_at = [&](vtkImageData *image, double depth_mm) {
    const double height = cell.height * (-depth_mm - seen.low_mm) / (seen.high_mm - seen.low_mm);
    return pixel(image, cell.x + cell.width / 2, cell.y + height);
  };
  const auto bright = [](const PixelColour &c) { return c[0] > 235 && c[1] > 235 && c[2] > 235; };
  for (const char *name : {"a.mp4", "a.webm", "a.gif", "a.apng"}) {
    INFO(name);
    render_film(series, film, folder.path / name);
    const auto first = picture_of(folder.path / name, 0), last = picture_of(folder.path / name, 2);
    REQUIRE(first->GetDimensions()[0] == last->GetDimensions()[0]);
    // 16 mm below the front face there is nothing but the plug of 12 mm, once it is pushed by 8 mm.
    CHECK(bright(colour_at(first, 16)));
    CHECK_FALSE(bright(colour_at(last, 16)));
    CHECK_FALSE(bright(colour_at(first, 6)));
  }
  // No single pictures and halves: the .pvd, three parts at three times, four films and the picture above.
  CHECK(count_files(folder.path) == 15);
}

TEST_CASE("a film without ffmpeg names the package and leaves the old one") {
  const TemporaryFolder folder;
  const auto series = sample_series(folder.path, 1);
  ogive::write_atomically(folder.path / "old.mp4", "old");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path.c_str(), 1);
  CHECK_THROWS_WITH(render_film(series, {}, folder.path / "old.mp4"), Catch::Contains("(Debian: ffmpeg)"));
  ::setenv("PATH", path.c_str(), 1);
  CHECK(read_text(folder.path / "old.mp4") == "old");
}

TEST_CASE("from behind all of the plate is seen, without the projectile; obliquely both") {
  const TemporaryFolder folder;
  auto frame = sample::perforated_plate(20e-3F);
  frame.symmetry = {true, true};
  // Without the plug the hole is open.
  auto &plate = frame.clouds[0];
  for (std::size_t i = 0; i < plate.positions.size(); ++i)
    if (std::hypot(plate.positions[i][0], plate.positions[i][1]) < 10e-3F)
      plate.positions[i] += ogive::Vec3<float>(1, 0, 0);
  SectionPanel panel{.low_mm = -28, .high_mm = 28, .radius_mm = 28, .width = 400, .height = 400};
  render_panel({{frame, "", Seen::behind}, {frame, "", Seen::oblique}}, folder.path / "a.png", panel);
  const auto image = read_png(folder.path / "a.png");
  const auto layout = panel_layout(2, panel);
  const auto colour_at = [&](std::size_t cell, double x_mm, double y_mm) {
    const Box &box = layout.cells[cell];
    return pixel(image, box.x + box.width / 2 + layout.pixels_per_mm * x_mm,
                 box.y + box.height / 2 + layout.pixels_per_mm * y_mm);
  };
  for (const double angle : {0.3, 1.9, 3.5, 5.1}) {
    INFO("angle " << angle);
    CHECK(white(colour_at(0, 5 * std::cos(angle), 5 * std::sin(angle))));
    CHECK_FALSE(white(colour_at(0, 18 * std::cos(angle), 18 * std::sin(angle))));
  }
  CHECK_FALSE(white(colour_at(1, 0, 10)));
}

TEST_CASE("the box of a picture reaches below the projectile") {
  const auto frame = sample::perforated_plate(30e-3F);
  const SeenBox box = extended({}, frame);
  CHECK(box.low_mm <= -34);
  CHECK(box.low_mm >= -52);
  CHECK(extended({.low_mm = -100}, frame).low_mm == -100);
}

TEST_CASE("a label has the velocity of the history at its time, and the part that it is of") {
  const History history{{0, 10, 20}, {300, 200, -0.2}};
  CHECK(time_text(60e-6, {}) == "60 µs");
  CHECK(time_text(5e-6, {history, ""}) == "5 µs, 250 m/s");
  CHECK(time_text(20e-6, {history, "core"}) == "20 µs, 0 m/s (core)");
  CHECK(velocity_at(history, -1) == 300);
  CHECK(velocity_at(history, 10) == 200);
  CHECK(velocity_at(history, 21) == -0.2);
  CHECK(velocity_at({}, 0) == std::nullopt);
}

TEST_CASE("a program has an exit status and a time limit") {
  CHECK(run_program("true", {}, 10) == 0);
  CHECK(run_program("sh", {"-c", "exit 5"}, 10) == 5);
  CHECK(run_program("no-such-program", {}, 10) == not_started);
  int status = 0;
  CHECK(seconds_of([&] { status = run_program("sleep", {"30"}, 0.2); }) < 10);
  CHECK(status == out_of_time);
  CHECK(failure_of("ffmpeg", "ffmpeg", out_of_time, 600) == "ffmpeg takes more than 600 s");
}

TEST_CASE("drawing apart reports what is thrown, a crash and a time limit") {
  const TemporaryFolder folder;
  const auto picture = folder.path / "a.png";
  draw_apart(picture, 10, [&] { ogive::write_atomically(picture, "drawn"); });
  CHECK(read_text(picture) == "drawn");
  CHECK_THROWS_WITH(draw_apart(picture, 10, [] { throw std::runtime_error("no colours"); }), "no colours");
  CHECK_THROWS_WITH(draw_apart(picture, 10, [] { ::_exit(9); }), Catch::Contains("drawing fails with exit status 9"));
  CHECK_THROWS_WITH(draw_apart(picture, 0.2, [] { ::sleep(30); }), Catch::Contains("drawing takes more than 0.2 s"));
}

TEST_CASE("frames of a long series are left out at even distances") {
  using Numbers = std::vector<std::size_t>;
  CHECK(shown_frames(3, 20) == Numbers{0, 1, 2});
  CHECK(shown_frames(5, 3) == Numbers{0, 2, 4});
  CHECK(shown_frames(25, 1) == Numbers{24});
  CHECK(shown_frames(100, 20).front() == 0);
  CHECK(shown_frames(100, 20).back() == 99);
  CHECK(shown_frames(0, 20).empty());
}
