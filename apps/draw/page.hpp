// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>
#include <vtkColorTransferFunction.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

/// \file
/// A page with scenes of VTK, text, bars and colours with their values, and its PNG. No display is needed.

namespace draw {

/// A rectangle on a page, pixels from the page's lower left corner.
struct Box {
  double x = 0, y = 0, width = 0, height = 0; ///< lower left corner and size
};

/// The middle of a box, `share` of its width.
inline Box narrowed(const Box &box, double share) {
  return {box.x + (1 - share) / 2 * box.width, box.y, share * box.width, box.height};
}

/// The ink of text and bars.
inline constexpr std::array page_ink{0.1, 0.1, 0.1};

/// A picture that is being drawn. VTK's fonts and OpenGL are not for several threads: while one thread has a page,
/// another that begins one waits.
struct Page {
  int width = 0, height = 0;                        ///< pixels
  vtkSmartPointer<vtkRenderer> ground, ink;         ///< below the scenes, and above them
  std::vector<vtkSmartPointer<vtkRenderer>> scenes; ///< each in its box
  std::unique_lock<std::mutex> alone;               ///< the right to draw
};

/// An empty page. Throws ogive::SetupError unless its sides are 64 to 16384 pixels.
Page white_page(int width, int height);

/// Puts a scene into a box of the page.
void add_scene(Page &page, vtkSmartPointer<vtkRenderer> scene, const Box &box);

/// Width of a line of text, pixels.
double text_width(const std::string &text, int size);

/// The largest size up to `size` at which the text is at most `width` pixels wide, and at least 8.
int fitting_size(const std::string &text, int size, double width);

/// Writes a line of text in the middle of a box, smaller than `size` if it is wider than the box.
void add_text(Page &page, const std::string &text, const Box &box, int size);

/// Fills a box with ink.
void add_bar(Page &page, const Box &box);

/// Draws the colours with their values in a box.
void add_colour_bar(Page &page, vtkColorTransferFunction *colours, int font_size, const Box &box);

/// Draws the page and writes it as a PNG. With fewer than 256 `levels` of red, green and blue each the shading of many
/// small balls takes half the bytes or less; white stays white. Throws ogive::WriteError if OpenGL is not there or the
/// file cannot be written. `compression` is 1, fast, to 9, small.
void write_png(const Page &page, const std::filesystem::path &path, int levels = 256, int compression = 9);

} // namespace draw
