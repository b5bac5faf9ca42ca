// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/text.hpp"
#include "ogive/io/vtk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>
#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkObject.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLUnstructuredGridReader.h>

/// \file
/// Frames read back from the files that vtk.hpp wrote.

namespace ogive {

/// The files of one frame.
struct StoredFrame {
  double time = 0;                     ///< s
  std::vector<VtkSeriesEntry> parts{}; ///< at least one
};

/// The content of a .pvd file.
struct StoredSeries {
  std::filesystem::path pvd;       ///< the file itself
  std::vector<StoredFrame> frames; ///< at least one, in the order of the file
};

/// The error "<path>: <reason>" for a file that is not what it should be.
inline SetupError read_error(const std::filesystem::path &path, const std::string &reason) {
  return SetupError(printable(path.string()) + ": " + reason);
}

/// Throws SetupError unless `path` is a file that can be opened.
inline void require_readable(const std::filesystem::path &path, const char *kind) {
  std::error_code ignored;
  // A folder can be opened too, and a device may have no end.
  if (!std::filesystem::is_regular_file(path, ignored) || !std::ifstream(path, std::ios::binary))
    throw read_error(path, std::string("must be a ") + kind + " that can be read");
}

namespace read_detail {

/// As long as it lives, VTK prints nothing.
struct QuietVtk {
  int before = vtkObject::GetGlobalWarningDisplay();
  QuietVtk() { vtkObject::SetGlobalWarningDisplay(0); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before); }
  QuietVtk(const QuietVtk &) = delete;
  QuietVtk &operator=(const QuietVtk &) = delete;
};

inline std::string attribute(vtkXMLDataElement *element, const char *name) {
  const char *text = element->GetAttribute(name);
  return text == nullptr ? "" : text;
}

/// Whether numbers and types in the XML of a .vtu of `bytes` are such that VTK's reader, which believes them, neither
/// crashes nor takes more memory than there can be data.
inline bool sound(vtkXMLDataElement *element, double bytes) {
  constexpr std::array types{"Float32", "Float64", "Int32", "Int64", "UInt8"};
  // Zlib packs no tighter than 1 in 1032.
  for (const auto &[name, most] : {std::pair{"NumberOfPoints", 1032 * bytes},
                                   {"NumberOfCells", 1032 * bytes},
                                   {"NumberOfTuples", 1032 * bytes},
                                   {"NumberOfComponents", 9.0},
                                   {"offset", bytes}}) {
    if (element->GetAttribute(name) == nullptr) continue;
    const auto number = number_from(attribute(element, name));
    if (!number || !(*number >= 0 && *number <= most)) return false;
  }
  if (std::string(element->GetName()) == "DataArray" &&
      std::find(types.begin(), types.end(), attribute(element, "type")) == types.end())
    return false;
  for (int k = 0; k < element->GetNumberOfNestedElements(); ++k)
    if (!sound(element->GetNestedElement(k), bytes)) return false;
  return true;
}

/// Whether every cell's corners are points.
inline bool sound_cells(vtkUnstructuredGrid *grid) {
  vtkCellArray *cells = grid->GetCells();
  if (grid->GetPoints() == nullptr || cells == nullptr) return false;
  if (!cells->IsValid() || cells->GetNumberOfCells() != grid->GetNumberOfCells()) return false;
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkIdType size = 0;
  const vtkIdType *corners = nullptr;
  for (vtkIdType e = 0; e < cells->GetNumberOfCells(); ++e) {
    cells->GetCellAtId(e, size, corners);
    if (!std::all_of(corners, corners + size, [&](vtkIdType n) { return n >= 0 && n < points; })) return false;
  }
  return true;
}

/// The data set of a .vtu; null if VTK complains of it.
inline vtkSmartPointer<vtkUnstructuredGrid> parse_vtu(const std::filesystem::path &path) {
  vtkNew<vtkXMLDataParser> parser;
  parser->SetFileName(path.c_str());
  if (parser->Parse() != 1 || parser->GetRootElement() == nullptr ||
      !sound(parser->GetRootElement(), static_cast<double>(std::filesystem::file_size(path))))
    return nullptr;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (reader->CanReadFile(path.c_str()) != 1) return nullptr;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkUnstructuredGrid *grid = reader->GetOutput();
  return reader->GetErrorCode() == vtkErrorCode::NoError && grid != nullptr && sound_cells(grid) ? grid : nullptr;
}

/// The data set of a .vtu. Throws SetupError.
inline vtkSmartPointer<vtkUnstructuredGrid> read_vtu(const std::filesystem::path &path) {
  require_readable(path, ".vtu file");
  const QuietVtk quiet;
  try {
    if (auto grid = parse_vtu(path)) return grid;
  } catch (const std::bad_alloc &) {
    // A damaged length of data.
  }
  throw read_error(path, "must be a whole .vtu file, as ogive writes it");
}

inline std::vector<Vec3<float>> positions_of(vtkUnstructuredGrid *grid) {
  std::vector<Vec3<float>> positions;
  for (vtkIdType n = 0; n < grid->GetNumberOfPoints(); ++n) {
    std::array<double, 3> x{};
    grid->GetPoint(n, x.data());
    positions.emplace_back((1e-3 * Vec3<double>(x[0], x[1], x[2])).cast<float>());
  }
  return positions;
}

/// All arrays of numbers but the part's number. Throws SetupError unless they have one tuple for each of `count`.
inline std::vector<Field> fields_of(vtkDataSetAttributes *attributes, vtkIdType count,
                                    const std::filesystem::path &path) {
  std::vector<Field> fields;
  for (int k = 0; k < attributes->GetNumberOfArrays(); ++k) {
    vtkDataArray *array = attributes->GetArray(k);
    if (array == nullptr || array->GetName() == nullptr || std::string(array->GetName()) == "part") continue;
    const int components = array->GetNumberOfComponents();
    if (array->GetNumberOfTuples() != count)
      throw read_error(path, std::string(array->GetName()) + " must have one value for each particle, node or hex");
    Field &field = fields.emplace_back(Field{array->GetName(), components, {}});
    field.values.reserve(static_cast<std::size_t>(count * components));
    for (vtkIdType i = 0; i < count; ++i)
      for (int c = 0; c < components; ++c) field.values.push_back(static_cast<float>(array->GetComponent(i, c)));
  }
  return fields;
}

inline std::optional<SymmetryPlanes> symmetry_of(vtkUnstructuredGrid *grid) {
  vtkDataArray *array = grid->GetFieldData()->GetArray(symmetry_array);
  if (array == nullptr || array->GetNumberOfValues() != 2) return std::nullopt;
  return SymmetryPlanes{array->GetComponent(0, 0) != 0, array->GetComponent(0, 1) != 0};
}

inline bool all_cells_are(vtkUnstructuredGrid *grid, int type, vtkIdType size) {
  for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e)
    if (grid->GetCellType(e) != type || grid->GetCells()->GetCellSize(e) != size) return false;
  return true;
}

inline PointCloud cloud_from(vtkUnstructuredGrid *grid, const VtkSeriesEntry &entry,
                             const std::filesystem::path &path) {
  vtkDataArray *diameter = grid->GetFieldData()->GetArray(diameter_array);
  if (diameter->GetNumberOfValues() != 1 || !all_cells_are(grid, VTK_VERTEX, 1))
    throw read_error(path, std::string("must hold particles and one ") + diameter_array);
  return {entry.part_name, entry.part, static_cast<float>(1e-3 * diameter->GetComponent(0, 0)), positions_of(grid),
          fields_of(grid->GetPointData(), grid->GetNumberOfPoints(), path)};
}

inline HexGrid hexes_from(vtkUnstructuredGrid *grid, const VtkSeriesEntry &entry, const std::filesystem::path &path) {
  if (!all_cells_are(grid, VTK_HEXAHEDRON, 8))
    throw read_error(path, std::string("must hold hexes, or particles with a ") + diameter_array);
  HexGrid hexes{entry.part_name,
                entry.part,
                positions_of(grid),
                {},
                fields_of(grid->GetPointData(), grid->GetNumberOfPoints(), path),
                fields_of(grid->GetCellData(), grid->GetNumberOfCells(), path)};
  vtkIdType size = 0;
  const vtkIdType *corners = nullptr;
  for (vtkIdType e = 0; e < grid->GetNumberOfCells(); ++e) {
    grid->GetCells()->GetCellAtId(e, size, corners);
    std::copy_n(corners, 8, hexes.hexes.emplace_back().begin());
  }
  return hexes;
}

} // namespace read_detail

/// Reads what a .pvd lists; the .vtu files are not opened. Throws SetupError that names the file if it is missing,
/// damaged, or not a series as vtk.hpp writes it.
inline StoredSeries read_series(const std::filesystem::path &pvd) {
  using read_detail::attribute;
  require_readable(pvd, ".pvd file");
  const read_detail::QuietVtk quiet;
  vtkNew<vtkXMLDataParser> parser;
  parser->SetFileName(pvd.c_str());
  vtkXMLDataElement *root = parser->Parse() == 1 ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement *list = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (list == nullptr || attribute(root, "type") != "Collection")
    throw read_error(pvd, "must be a .pvd file, as ogive writes it");
  StoredSeries series{pvd, {}};
  for (int k = 0; k < list->GetNumberOfNestedElements(); ++k) {
    vtkXMLDataElement *element = list->GetNestedElement(k);
    const auto time_us = number_from(attribute(element, "timestep")), part = number_from(attribute(element, "part"));
    VtkSeriesEntry entry{0, 0, attribute(element, "name"), attribute(element, "file")};
    if (!time_us || !std::isfinite(*time_us) || !part || !(std::abs(*part) < 1e6) || entry.part_name.empty() ||
        entry.file.empty())
      throw read_error(pvd, "data set " + std::to_string(k + 1) + " must have a timestep, a part, a name and a file");
    entry.time = 1e-6 * *time_us;
    entry.part = static_cast<int>(*part);
    const auto is_same = [&](const VtkSeriesEntry &other) { return other.part_name == entry.part_name; };
    if (series.frames.empty() || series.frames.back().time != entry.time ||
        std::any_of(series.frames.back().parts.begin(), series.frames.back().parts.end(), is_same))
      series.frames.push_back({entry.time});
    series.frames.back().parts.push_back(entry);
  }
  if (series.frames.empty()) throw read_error(pvd, "must list at least one frame");
  return series;
}

/// Number of the frame nearest to `time` (s).
inline std::size_t nearest_frame(const StoredSeries &series, double time) {
  const auto nearer = [&](const StoredFrame &a, const StoredFrame &b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  };
  return static_cast<std::size_t>(
      std::distance(series.frames.begin(), std::min_element(series.frames.begin(), series.frames.end(), nearer)));
}

/// Throws SetupError unless the middles of all hexes lie on the computed side of the planes. Nodes are held there, and
/// hexes that lose their neighbours and get across are removed; particles may stray.
inline void require_one_side(const HexGrid &hexes, SymmetryPlanes planes, const std::filesystem::path &path) {
  constexpr float tolerance = 1e-3F;
  for (const auto &hex : hexes.hexes) {
    Vec3<float> x = Vec3<float>::Zero();
    for (const Index n : hex) x += 0.125F * hexes.positions[static_cast<std::size_t>(n)];
    if ((planes.x && x[0] < -tolerance) || (planes.y && x[1] < -tolerance))
      throw read_error(path, "is not the quarter or half of a model that its symmetry states");
  }
}

/// Reads frame `k` of a series. Files of versions that did not write the symmetry need `symmetry`; others need not, and
/// win. Throws SetupError that names the file if one is missing, damaged or not as vtk.hpp writes it, or if the
/// symmetry is not known or cannot be.
inline Frame read_frame(const StoredSeries &series, std::size_t k, std::optional<SymmetryPlanes> symmetry = {}) {
  require(k < series.frames.size(), series.pvd.string() + " frame", k,
          "must be less than " + std::to_string(series.frames.size()));
  Frame frame;
  frame.time = series.frames[k].time;
  for (const VtkSeriesEntry &entry : series.frames[k].parts) {
    const auto path = series.pvd.parent_path() / entry.file;
    const auto grid = read_detail::read_vtu(path);
    const auto written = read_detail::symmetry_of(grid);
    if (!written && !symmetry)
      throw read_error(path, "does not state whether it is a quarter, a half or all of a model");
    frame.symmetry = written ? *written : *symmetry;
    if (grid->GetFieldData()->GetArray(diameter_array) != nullptr)
      frame.clouds.push_back(read_detail::cloud_from(grid, entry, path));
    else
      require_one_side(frame.grids.emplace_back(read_detail::hexes_from(grid, entry, path)), frame.symmetry, path);
  }
  return frame;
}

} // namespace ogive
