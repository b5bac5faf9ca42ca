// SPDX-License-Identifier: BSD-3-Clause
#include "draw/section.hpp"

#include "draw/png_pixels.hpp"
#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

using namespace draw;

namespace {

/// The sample as a quarter, pushed through by 0, 4, 8, ... mm.
std::vector<PanelCell> cells(int count) {
  std::vector<PanelCell> all;
  for (int k = 0; k < count; ++k) {
    all.push_back({sample::perforated_plate(4e-3F * float(k)), "(a) 40 µs, 151 m/s"});
    all.back().frame.symmetry = {true, true};
  }
  return all;
}

SectionPanel small_panel() {
  SectionPanel panel;
  panel.title = "12 mm, blunt";
  panel.width = 1000;
  return panel;
}

bool overlap(const Box &a, const Box &b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// The colour at a place of a section, mm.
PixelColour colour_at(vtkImageData *image, const SectionPanel &panel, std::size_t count, std::size_t k, double x_mm,
                      double z_mm) {
  const PanelLayout layout = panel_layout(count, panel);
  const Box &cell = layout.cells[k];
  const double middle = (panel.low_mm + panel.high_mm) / 2;
  return pixel(image, cell.x + cell.width / 2 + layout.pixels_per_mm * x_mm,
               cell.y + cell.height / 2 + layout.pixels_per_mm * (z_mm - middle));
}

/// How many pixels of a box are not white.
int inked(vtkImageData *image, const Box &box) {
  int count = 0;
  for (double x = std::ceil(box.x); x < std::floor(box.x + box.width); ++x)
    for (double y = std::ceil(box.y); y < std::floor(box.y + box.height); ++y) count += !white(pixel(image, x, y));
  return count;
}

} // namespace

TEST_CASE("sections, labels, title, colours and scale bar of a panel do not overlap and stay on the page") {
  for (const std::size_t count : {1U, 2U, 4U, 5U, 9U, 13U})
    for (const int columns : {0, 1, 3})
      for (const double high_mm : {-15.0, 22.0, 60.0}) {
        SectionPanel panel;
        panel.columns = columns;
        panel.high_mm = high_mm;
        panel.low_mm = high_mm > 50 ? -100 : -25;
        panel.title = columns == 0 ? "" : "title";
        INFO(count << " sections in " << columns << " columns up to " << high_mm << " mm");
        const auto layout = panel_layout(count, panel);
        CHECK(layout.width <= panel.width);
        CHECK(layout.height <= panel.height);
        CHECK(layout.bar.height > 5 * layout.font_size);
        std::vector<Box> boxes = layout.cells;
        boxes.insert(boxes.end(), layout.labels.begin(), layout.labels.end());
        boxes.insert(boxes.end(), {layout.bar, layout.scale, layout.title});
        REQUIRE(boxes.size() == 2 * count + 3);
        int wrong = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          const Box &box = boxes[i];
          wrong += box.x < 0 || box.y < 0 || box.width <= 0 || box.height <= 0 ||
                   box.x + box.width > layout.width + 1e-9 || box.y + box.height > layout.height + 1e-9;
          for (std::size_t j = 0; j < i; ++j) wrong += overlap(box, boxes[j]);
        }
        CHECK(wrong == 0);
      }
}

TEST_CASE("a panel has even rows") {
  CHECK(panel_columns(1) == 1);
  CHECK(panel_columns(4) == 4);
  CHECK(panel_columns(5) == 3);
  CHECK(panel_columns(6) == 3);
  CHECK(panel_columns(8) == 4);
  CHECK(panel_columns(9) == 3);
}

TEST_CASE("a panel that cannot be drawn is refused") {
  const TemporaryFolder folder;
  const auto refuse = [&](const std::vector<PanelCell> &sections, auto &&spoil) {
    SectionPanel panel = small_panel();
    spoil(panel);
    CHECK_THROWS_AS(render_panel(sections, folder.path / "a.png", panel), ogive::SetupError);
  };
  refuse({}, [](SectionPanel &) {});
  refuse(cells(1), [](SectionPanel &panel) { panel.width = 10; });
  refuse(cells(1), [](SectionPanel &panel) { panel.high_mm = panel.low_mm; });
  refuse(cells(1), [](SectionPanel &panel) { panel.radius_mm = 0; });
  refuse(cells(1), [](SectionPanel &panel) { panel.columns = -1; });
  refuse(cells(1), [](SectionPanel &panel) { panel.style.largest = panel.style.smallest; });
  refuse(cells(1), [](SectionPanel &panel) { panel.style.field = "heat"; });
  CHECK_THROWS_AS(panel_layout(100, SectionPanel{.columns = 100, .width = 400}), ogive::SetupError);
  CHECK(count_files(folder.path) == 0);
}

TEST_CASE("a panel shows each section with both halves, at one scale, with labels, colours and scale bar") {
  const TemporaryFolder folder;
  const auto path = folder.path / "panel.png";
  const SectionPanel panel = small_panel();
  render_panel(cells(3), path, panel);
  CHECK(count_files(folder.path) == 1);
  CHECK(std::filesystem::file_size(path) < 400'000);
  const auto image = read_png(path);
  const auto layout = panel_layout(3, panel);
  REQUIRE(image->GetDimensions()[0] == layout.width);
  REQUIRE(image->GetDimensions()[1] == layout.height);
  for (std::size_t k = 0; k < 3; ++k)
    for (const double side : {-1.0, 1.0}) {
      INFO("section " << k << ", side " << side);
      const auto at = [&](double x, double z) { return colour_at(image, panel, 3, k, side * x, z); };
      const double push = 4.0 * double(k);
      CHECK(white(at(20, 10)));
      CHECK(white(at(4, -12 - push - 4)));
      CHECK_FALSE(white(at(4, 5)));
      CHECK_FALSE(white(at(26, -6)));
      CHECK_FALSE(white(at(4, -12 - push + 2)));
      CHECK(reddish(at(9.5, -push - 8)));
      CHECK_FALSE(reddish(at(26, -6)));
    }
  for (const auto &label : layout.labels) CHECK(inked(image, label) > 100);
  for (const auto &box : {layout.title, layout.bar, layout.scale}) CHECK(inked(image, box) > 100);
  // Nothing between the sections.
  CHECK(inked(image, {layout.cells[0].x + layout.cells[0].width, layout.cells[0].y,
                      layout.cells[1].x - layout.cells[0].x - layout.cells[0].width, layout.cells[0].height}) == 0);
}

TEST_CASE("text is made smaller until it fits") {
  const std::string text = "(a) weldox_460e_mjc_blunt_12mm_303.5mps";
  const double width = text_width(text, 30);
  CHECK(width > 300);
  CHECK(fitting_size(text, 30, width + 1) == 30);
  const int size = fitting_size(text, 30, width / 2);
  CHECK(size < 16);
  CHECK(text_width(text, size) < 1.1 * width / 2);
}
