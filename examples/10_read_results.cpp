// Reading results back: writes three frames of a shot as ogive shoot does, and reads them again. Needs VTK
// (ogive::vtk). Run: 10_read_results [series.pvd]. It prints time and largest plastic strain of each frame; without
// an argument the series is its own, in the temporary folder, and the last strain is the one of the model.
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ogive/io/read_frame.hpp>
#include <ogive/ogive.hpp>

using namespace ogive;

static double largest(const std::vector<float> &values) { return *std::max_element(values.begin(), values.end()); }

/// Prints all frames of a series and gives the largest plastic strain of the last one's particles.
static double print_series(const std::filesystem::path &pvd) {
  const StoredSeries series = read_series(pvd);
  double strain = 0;
  for (std::size_t k = 0; k < series.frames.size(); ++k) {
    const Frame frame = read_frame(series, k);
    const PointCloud &plate = frame.clouds.at(0);
    strain = largest(find_field(plate.fields, "plastic_strain", plate.name).values);
    std::printf("%5.2f us  %s of %zu particles: largest plastic strain %.4f\n", frame.time * 1e6, plate.name.c_str(),
                plate.positions.size(), strain);
  }
  return strain;
}

int main(int argc, char **argv) try {
  if (argc > 1) return print_series(argv[1]), 0;
  const PerforationCase<double> shot{.thickness = 6e-3, .spacing = 1.5e-3};
  auto model = make_perforation(shot, library::weldox_460e_mjc<double>(), library::arne_tool_steel<double>());

  const auto folder = std::filesystem::temp_directory_path() / "ogive_example_read_results";
  VtkSeries series = open_series(folder, "shot");
  run(model, RunOptions<double>{.end_time = 4e-6, .observe_every = 2e-6}, [&](const auto &now, const auto &) {
    add_frame(series, gather_frame(now));
    return true;
  });
  const auto &strain = plate_particles(model).points.plastic_strain;
  const double written = *std::max_element(strain.begin(), strain.end()), read = print_series(pvd_path(series));
  std::filesystem::remove_all(folder);
  return std::abs(read - written) < 1e-6 ? 0 : 1; // frames are in single precision
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
