// SPDX-License-Identifier: BSD-3-Clause
#include "ogive/io/vtk.hpp"

#include "io/sample_frame.hpp"
#include "io/temporary_folder.hpp"

#include "catch.hpp"

#include <vtkXMLDataElement.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUtilities.h>

using namespace ogive;

namespace {

vtkSmartPointer<vtkUnstructuredGrid> read_vtu(const std::filesystem::path &path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  REQUIRE(reader->CanReadFile(path.c_str()) == 1);
  reader->SetFileName(path.c_str());
  reader->Update();
  REQUIRE(reader->GetErrorCode() == 0);
  return reader->GetOutput();
}

void check_array(vtkDataSetAttributes *attributes, const Field &field) {
  INFO(field.name);
  vtkDataArray *array = attributes->GetArray(field.name.c_str());
  REQUIRE(array != nullptr);
  REQUIRE(array->GetNumberOfComponents() == field.components);
  REQUIRE(array->GetNumberOfValues() == static_cast<vtkIdType>(field.values.size()));
  int different = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    different += array->GetComponent(i / field.components, static_cast<int>(i % field.components)) !=
                 static_cast<double>(field.values[static_cast<std::size_t>(i)]);
  CHECK(different == 0);
}

struct Listed {
  double timestep;
  std::string file;
};

/// What the .pvd lists, as VTK's XML parser reads it.
std::vector<Listed> read_pvd(const std::filesystem::path &path) {
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  REQUIRE(root);
  CHECK(std::string(root->GetAttribute("type")) == "Collection");
  const auto collection = root->FindNestedElementWithName("Collection");
  REQUIRE(collection);
  std::vector<Listed> listed;
  for (int k = 0; k < collection->GetNumberOfNestedElements(); ++k) {
    auto *element = collection->GetNestedElement(k);
    listed.push_back({std::stod(element->GetAttribute("timestep")), element->GetAttribute("file")});
  }
  return listed;
}

} // namespace

TEST_CASE("particles read back from a .vtu as they were, in mm") {
  const TemporaryFolder folder;
  const PointCloud cloud = sample::perforated_plate().clouds[0];
  write_vtu(folder.path / "plate.vtu", cloud);
  const auto grid = read_vtu(folder.path / "plate.vtu");
  const auto count = static_cast<vtkIdType>(cloud.positions.size());
  REQUIRE(grid->GetNumberOfPoints() == count);
  CHECK(grid->GetNumberOfCells() == count);
  CHECK(grid->GetCellType(0) == VTK_VERTEX);
  CHECK(grid->GetPoint(count - 1)[2] == Approx(1e3 * double(cloud.positions.back()[2])));
  CHECK(grid->GetFieldData()->GetArray("particle_diameter_mm")->GetTuple1(0) == Approx(1.2));
  for (const Field &field : cloud.fields) check_array(grid->GetPointData(), field);
  CHECK(grid->GetPointData()->GetArray("part")->GetTuple1(0) == 0);
}

TEST_CASE("hexes read back from a .vtu as they were, in mm") {
  const TemporaryFolder folder;
  const HexGrid hexes = sample::perforated_plate().grids[1];
  write_vtu(folder.path / "projectile.vtu", hexes);
  const auto grid = read_vtu(folder.path / "projectile.vtu");
  REQUIRE(grid->GetNumberOfPoints() == static_cast<vtkIdType>(hexes.positions.size()));
  REQUIRE(grid->GetNumberOfCells() == static_cast<vtkIdType>(hexes.hexes.size()));
  CHECK(grid->GetCellType(7) == VTK_HEXAHEDRON);
  for (int corner = 0; corner < 8; ++corner)
    CHECK(grid->GetCell(7)->GetPointId(corner) == hexes.hexes[7][static_cast<std::size_t>(corner)]);
  CHECK(grid->GetPoint(5)[0] == Approx(1e3 * double(hexes.positions[5][0])));
  for (const Field &field : hexes.point_fields) check_array(grid->GetPointData(), field);
  for (const Field &field : hexes.cell_fields) check_array(grid->GetCellData(), field);
  CHECK(grid->GetCellData()->GetArray("part")->GetTuple1(0) == 2);
  CHECK(std::string(grid->GetCellData()->GetArray("stress_MPa")->GetComponentName(5)) == "XZ");
}

TEST_CASE("a field of the wrong size is refused") {
  PointCloud cloud = sample::perforated_plate().clouds[0];
  cloud.fields[0].values.pop_back();
  CHECK_THROWS_AS(to_vtk(cloud), SetupError);
}

TEST_CASE("a body without particles can be written") {
  const TemporaryFolder folder;
  write_vtu(folder.path / "empty.vtu", PointCloud{"empty", 0, 1e-3F, {}, {{"plastic_strain", 1, {}}}});
  CHECK(read_vtu(folder.path / "empty.vtu")->GetNumberOfPoints() == 0);
}

TEST_CASE("after each frame the .pvd lists whole files, at times in microseconds") {
  const TemporaryFolder folder;
  auto series = open_series(folder.path / "made" / "here", "run");
  Frame frame = sample::perforated_plate();
  for (int n = 1; n <= 3; ++n) {
    frame.time = 10e-6 * n;
    add_frame(series, frame);
    const auto listed = read_pvd(series.folder / "run.pvd");
    REQUIRE(listed.size() == static_cast<std::size_t>(3 * n));
    CHECK(listed.back().timestep == Approx(10.0 * n));
    for (const auto &entry : listed) read_vtu(series.folder / entry.file);
  }
  CHECK(series.frames == 3);
  CHECK(count_files(series.folder) == 10);
  CHECK(std::filesystem::exists(series.folder / "frames" / "run_projectile_0002.vtu"));
}

TEST_CASE("a new series removes its own old frames and no others") {
  const TemporaryFolder folder;
  const Frame frame = sample::perforated_plate();
  auto other = open_series(folder.path, "run_b");
  add_frame(other, frame);
  auto old = open_series(folder.path, "run");
  add_frame(old, frame);
  add_frame(old, frame);
  REQUIRE(count_files(folder.path) == 4 + 7);
  const auto fresh = open_series(folder.path, "run");
  CHECK(fresh.frames == 0);
  CHECK(count_files(folder.path) == 4);
  CHECK(read_pvd(folder.path / "run_b.pvd").size() == 3);
}

TEST_CASE("a .pvd that names other files does not make a new series remove them") {
  const TemporaryFolder folder;
  open_series(folder.path, "run");
  write_atomically(folder.path / "precious.vtu", "data");
  write_atomically(folder.path / "frames" / "other_plate_0000.vtu", "data");
  write_atomically(folder.path / "run.pvd", "<DataSet file=\"precious.vtu\"/><DataSet file=\"frames/run_/../../"
                                            "precious.vtu\"/><DataSet file=\"frames/other_plate_0000.vtu\"/>");
  open_series(folder.path, "run");
  CHECK(std::filesystem::exists(folder.path / "precious.vtu"));
  CHECK(std::filesystem::exists(folder.path / "frames" / "other_plate_0000.vtu"));
}

TEST_CASE("a frame that does not fit on the disk leaves the earlier ones") {
  const TemporaryFolder folder;
  auto series = open_series(folder.path, "run");
  const Frame frame = sample::perforated_plate();
  add_frame(series, frame);
  const std::string before = read_text(folder.path / "run.pvd");
  {
    const FullDisk full(2000);
    CHECK_THROWS_WITH(add_frame(series, frame), "cannot write " +
                                                    (folder.path / "frames" / "run_plate_sph_0001.vtu").string() +
                                                    ": File too large");
  }
  CHECK(series.frames == 1);
  CHECK(read_text(folder.path / "run.pvd") == before);
  CHECK(count_files(folder.path) == 4);
  add_frame(series, frame);
  CHECK(read_pvd(folder.path / "run.pvd").size() == 6);
}

TEST_CASE("a series whose folder has gone says so") {
  const TemporaryFolder folder;
  auto series = open_series(folder.path / "out", "run");
  std::filesystem::remove_all(folder.path / "out");
  CHECK_THROWS_AS(add_frame(series, sample::perforated_plate()), WriteError);
  write_atomically(folder.path / "file", "text");
  CHECK_THROWS_AS(open_series(folder.path / "file", "run"), WriteError);
}

TEST_CASE("names that cannot stand in a file's name are refused") {
  const TemporaryFolder folder;
  for (const char *name : {"", "a/b", "..", "a b", "a\"b"}) CHECK_THROWS_AS(open_series(folder.path, name), SetupError);
  auto series = open_series(folder.path, "run");
  Frame frame = sample::perforated_plate();
  frame.grids[0].name = "plate rim";
  CHECK_THROWS_AS(add_frame(series, frame), SetupError);
  frame.grids[0].name = frame.grids[1].name;
  CHECK_THROWS_AS(add_frame(series, frame), SetupError);
  CHECK_FALSE(std::filesystem::exists(folder.path / "run.pvd"));
}
