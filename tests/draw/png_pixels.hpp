// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <vtkImageData.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

using PixelColour = std::array<int, 3>;

inline vtkSmartPointer<vtkImageData> read_png(const std::filesystem::path &path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// The colour at a pixel, from the lower left corner.
inline PixelColour pixel(vtkImageData *image, double column, double row) {
  PixelColour colour{};
  for (int k = 0; k < 3; ++k)
    colour[static_cast<std::size_t>(k)] =
        static_cast<int>(image->GetScalarComponentAsDouble(static_cast<int>(column), static_cast<int>(row), 0, k));
  return colour;
}

inline bool reddish(const PixelColour &c) { return c[0] > 2 * c[2] + 10; }
inline bool white(const PixelColour &c) { return c == PixelColour{255, 255, 255}; }
