// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/read_frame.hpp"

#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

using namespace ogive;

namespace {

/// Three frames of the sample, 10 us apart, each pushed further, with the symmetry of a quarter.
StoredSeries written_series(const std::filesystem::path &folder) {
  auto series = open_series(folder, "run");
  for (int n = 0; n < 3; ++n) {
    Frame frame = sample::perforated_plate(2e-3F * static_cast<float>(n), 3e-3F);
    frame.time = 10e-6 * n;
    frame.symmetry = {true, true};
    add_frame(series, frame);
  }
  return read_series(folder / "run.pvd");
}

void check_fields(const std::vector<Field> &read, const std::vector<Field> &written) {
  REQUIRE(read.size() == written.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    INFO(written[k].name);
    CHECK(read[k].name == written[k].name);
    CHECK(read[k].components == written[k].components);
    CHECK(read[k].values == written[k].values);
  }
}

void check_positions(const std::vector<Vec3<float>> &read, const std::vector<Vec3<float>> &written) {
  REQUIRE(read.size() == written.size());
  float largest = 0;
  for (std::size_t k = 0; k < read.size(); ++k) largest = std::max(largest, (read[k] - written[k]).norm());
  // They went through mm in single precision.
  CHECK(largest < 2e-8F);
}

std::string read_error_of(const StoredSeries &series) {
  try {
    read_frame(series, 0);
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

std::string series_error_of(const std::filesystem::path &pvd) {
  try {
    read_series(pvd);
  } catch (const SetupError &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a series reads back with the times and parts that were written") {
  const TemporaryFolder folder;
  const auto series = written_series(folder.path);
  REQUIRE(series.frames.size() == 3);
  for (std::size_t n = 0; n < 3; ++n) CHECK(series.frames[n].time == Approx(10e-6 * double(n)).margin(1e-12));
  REQUIRE(series.frames[1].parts.size() == 3);
  CHECK(series.frames[1].parts[2].part_name == "projectile");
  CHECK(series.frames[1].parts[2].part == 2);
  CHECK(series.frames[1].parts[2].file == "frames/run_projectile_0001.vtu");
  CHECK(nearest_frame(series, 14e-6) == 1);
  CHECK(nearest_frame(series, 16e-6) == 2);
  CHECK(nearest_frame(series, 1) == 2);
  CHECK(nearest_frame(series, -1) == 0);
}

TEST_CASE("a frame reads back as it was written") {
  const TemporaryFolder folder;
  const Frame read = read_frame(written_series(folder.path), 2), written = sample::perforated_plate(4e-3F, 3e-3F);
  CHECK(read.time == Approx(20e-6));
  CHECK(read.symmetry.copies() == 4);
  REQUIRE(read.clouds.size() == 1);
  REQUIRE(read.grids.size() == 2);
  CHECK(read.clouds[0].name == "plate_sph");
  CHECK(read.clouds[0].part == 0);
  CHECK(read.clouds[0].diameter == Approx(3e-3F));
  check_positions(read.clouds[0].positions, written.clouds[0].positions);
  check_fields(read.clouds[0].fields, written.clouds[0].fields);
  for (std::size_t g = 0; g < 2; ++g) {
    CHECK(read.grids[g].name == written.grids[g].name);
    CHECK(read.grids[g].part == written.grids[g].part);
    CHECK(read.grids[g].hexes == written.grids[g].hexes);
    check_positions(read.grids[g].positions, written.grids[g].positions);
    check_fields(read.grids[g].point_fields, written.grids[g].point_fields);
    check_fields(read.grids[g].cell_fields, written.grids[g].cell_fields);
  }
}

TEST_CASE("each symmetry reads back, and an empty part is not written") {
  const TemporaryFolder folder;
  for (const auto &planes : {SymmetryPlanes{}, SymmetryPlanes{false, true}, SymmetryPlanes{true, true}}) {
    auto series = open_series(folder.path, "run");
    Frame frame;
    frame.symmetry = planes;
    frame.clouds.push_back({"empty", 7, 1e-3F, {}, {{"plastic_strain", 1, {}}}});
    frame.clouds.push_back({"one", 8, 1e-3F, {Vec3<float>(0.1F, 0.1F, 0.1F)}, {{"plastic_strain", 1, {0.5F}}}});
    frame.grids.push_back({"removed", 9, {}, {}, {}, {{"plastic_strain", 1, {}}}});
    add_frame(series, frame);
    CHECK(count_files(folder.path) == 2);
    const Frame read = read_frame(read_series(pvd_path(series)), 0);
    CHECK(read.symmetry.x == planes.x);
    CHECK(read.symmetry.y == planes.y);
    REQUIRE(read.clouds.size() == 1);
    CHECK(read.clouds[0].part == 8);
    CHECK(read.clouds[0].positions.size() == 1);
    CHECK(read.grids.empty());
  }
}

TEST_CASE("a frame that does not tell its symmetry needs the caller to") {
  const TemporaryFolder folder;
  const auto series = written_series(folder.path);
  const Frame frame = sample::perforated_plate(0, 3e-3F);
  // As files were before they told.
  write_vtu(folder.path / series.frames[0].parts[0].file, frame.clouds[0]);
  for (std::size_t g = 0; g < 2; ++g) write_vtu(folder.path / series.frames[0].parts[g + 1].file, frame.grids[g]);
  CHECK_THROWS_WITH(read_frame(series, 0), (folder.path / "frames" / "run_plate_sph_0000.vtu").string() +
                                               ": does not state whether it is a quarter, a half or all of a model");
  CHECK(read_frame(series, 0, SymmetryPlanes{false, true}).symmetry.copies() == 2);
  CHECK(read_frame(series, 1, SymmetryPlanes{false, true}).symmetry.copies() == 4);
}

TEST_CASE("a whole model is not taken for a quarter") {
  const TemporaryFolder folder;
  Frame frame = sample::perforated_plate(0, 3e-3F);
  for (auto &x : frame.grids[0].positions) x[1] = -x[1];
  auto series = open_series(folder.path, "run");
  frame.symmetry = {true, false};
  add_frame(series, frame);
  CHECK(read_frame(read_series(pvd_path(series)), 0).grids.size() == 2);
  frame.symmetry = {true, true};
  add_frame(series, frame);
  CHECK_THROWS_WITH(read_frame(read_series(pvd_path(series)), 1),
                    (folder.path / "frames" / "run_plate_rim_0001.vtu").string() +
                        ": is not the quarter or half of a model that its symmetry states");
}

TEST_CASE("a .pvd that is missing, damaged or foreign is named") {
  const TemporaryFolder folder;
  const auto pvd = folder.path / "run.pvd";
  CHECK(series_error_of(pvd) == pvd.string() + ": must be a .pvd file that can be read");
  CHECK(series_error_of(folder.path) == folder.path.string() + ": must be a .pvd file that can be read");
  CHECK(series_error_of("/dev/zero") == "/dev/zero: must be a .pvd file that can be read");
  for (const char *text : {"", "nonsense", "<VTKFile type=\"Collection\"><Collection>",
                           "<VTKFile type=\"Collection\"></VTKFile>", "<VTKFile><Collection/></VTKFile>"}) {
    write_atomically(pvd, text);
    CHECK(series_error_of(pvd) == pvd.string() + ": must be a .pvd file, as ogive writes it");
  }
  const auto listing = [&](const std::string &attributes) {
    write_atomically(pvd, "<VTKFile type=\"Collection\"><Collection>" + attributes + "</Collection></VTKFile>");
    return series_error_of(pvd);
  };
  CHECK(listing("") == pvd.string() + ": must list at least one frame");
  for (const char *timestep : {"", "soon", "nan", "1e999"})
    CHECK(listing(std::string("<DataSet timestep=\"") + timestep + "\" part=\"0\" name=\"a\" file=\"a.vtu\"/>") ==
          pvd.string() + ": data set 1 must have a timestep, a part, a name and a file");
  CHECK_FALSE(listing("<DataSet timestep=\"1\" part=\"0\" name=\"a\"/>").empty());
  CHECK(listing("<DataSet timestep=\"1\" part=\"0\" name=\"a\" file=\"a.vtu\"/>").empty());
}

TEST_CASE("a .vtu that is missing, damaged or foreign is named") {
  const TemporaryFolder folder;
  const auto series = written_series(folder.path);
  CHECK_THROWS_AS(read_frame(series, 3), SetupError);
  const auto path = folder.path / series.frames[0].parts[2].file;
  const std::string whole = read_text(path);
  for (const std::size_t size : {std::size_t(0), std::size_t(40), whole.size() / 3, whole.size() - 200}) {
    INFO("cut to " << size);
    write_atomically(path, whole.substr(0, size));
    CHECK(read_error_of(series) == path.string() + ": must be a whole .vtu file, as ogive writes it");
  }
  std::filesystem::remove(path);
  CHECK(read_error_of(series) == path.string() + ": must be a .vtu file that can be read");

  vtkNew<vtkUnstructuredGrid> lines;
  lines->SetPoints(to_vtk_points({{0, 0, 0}, {1, 0, 0}}));
  lines->InsertNextCell(VTK_LINE, 2, std::array<vtkIdType, 2>{0, 1}.data());
  add_symmetry(lines, {});
  write_vtu(path, lines);
  CHECK(read_error_of(series) == path.string() + ": must hold hexes, or particles with a particle_diameter_mm");
  lines->InsertNextCell(VTK_LINE, 2, std::array<vtkIdType, 2>{0, 9}.data());
  write_vtu(path, lines);
  CHECK(read_error_of(series) == path.string() + ": must be a whole .vtu file, as ogive writes it");
}

TEST_CASE("a .vtu with wrong bytes is refused or read, and nothing worse") {
  const TemporaryFolder folder;
  auto series = written_series(folder.path);
  const auto path = folder.path / series.frames[0].parts[1].file;
  series.frames[0].parts = {series.frames[0].parts[1]};
  const std::string whole = read_text(path);
  int refused = 0;
  constexpr std::size_t attempts = 150;
  for (std::size_t k = 0; k < attempts; ++k) {
    std::string wrong = whole;
    wrong[whole.size() * k / attempts] ^= static_cast<char>(1 + k % 255);
    std::ofstream(path, std::ios::binary) << wrong;
    refused += !read_error_of(series).empty();
  }
  CHECK(refused > 50);
}
