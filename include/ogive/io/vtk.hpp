// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"
#include "ogive/io/vtk_data_set.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>
#include <vtkXMLUnstructuredGridWriter.h>

/// \file
/// Frames as files that ParaView opens: a .vtu for each part and time, and a .pvd that lists them. Needs VTK's modules
/// CommonCore, CommonDataModel and IOXML.

namespace ogive {

/// Writes a data set as compressed binary .vtu, atomically. Throws WriteError.
inline void write_vtu(const std::filesystem::path &path, vtkUnstructuredGrid *grid) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  writer->SetIdTypeToInt32();
  // Into memory first: VTK itself overlooks some failing writes, and would leave half a file.
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw write_error(path, "VTK cannot encode it");
  write_atomically(path, writer->GetOutputString());
}

/// Writes the particles as .vtu: positions in mm, fields on the points. Throws WriteError.
inline void write_vtu(const std::filesystem::path &path, const PointCloud &cloud) { write_vtu(path, to_vtk(cloud)); }

/// Writes the hexes as .vtu: positions in mm, fields on points and cells. Throws WriteError.
inline void write_vtu(const std::filesystem::path &path, const HexGrid &hexes) { write_vtu(path, to_vtk(hexes)); }

/// The files of one part at one time, for the .pvd.
struct VtkSeriesEntry {
  double time = 0;       ///< s
  int part = 0;          ///< number of the body in the model, from 0
  std::string part_name; ///< of the body
  std::string file;      ///< relative to the series' folder: "frames/run_plate_0003.vtu"
};

/// A growing series of frames: FOLDER/NAME.pvd and FOLDER/frames/NAME_PART_NNNN.vtu.
struct VtkSeries {
  std::filesystem::path folder;          ///< of the .pvd
  std::string name;                      ///< of the .pvd, and the start of all names
  int frames = 0;                        ///< written so far
  std::vector<VtkSeriesEntry> entries{}; ///< in the order of writing
};

/// Whether `name` can be part of a file name and of XML without escapes: letters, digits, '-', '_' and '.', not '.'
/// first.
inline bool plain_file_name(const std::string &name) {
  const auto plain = [](char c) { return is_letter_or_digit(c) || c == '-' || c == '_' || c == '.'; };
  return !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), plain);
}

/// The file that lists the frames.
inline std::filesystem::path pvd_path(const VtkSeries &series) { return series.folder / (series.name + ".pvd"); }

/// The frames that the .pvd of a series lists, relative to the folder; none if there is no .pvd.
inline std::vector<std::string> listed_frames(const VtkSeries &series) {
  std::ifstream file(pvd_path(series), std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string before = "file=\"", own = "frames/" + series.name + "_";
  std::vector<std::string> frames;
  for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    auto frame = text.substr(at, text.find('"', at) - at);
    // A .pvd that somebody edited must not make us remove anything but frames of this series.
    if (frame.starts_with(own) && frame.ends_with(".vtu") && plain_file_name(frame.substr(7))) frames.push_back(frame);
  }
  return frames;
}

/// Starts a new series in `folder`, which is made if need be. An old series of this name there is removed: its .pvd and
/// the frames which that lists, nothing else. Throws SetupError unless `name` is made of letters, digits, '-', '_' and
/// '.', WriteError if the folder cannot be made or old files cannot be removed.
inline VtkSeries open_series(const std::filesystem::path &folder, const std::string &name) {
  require(plain_file_name(name), "name of a VTK series", name, "must be made of letters, digits, '-', '_' and '.'");
  VtkSeries series{folder, name};
  std::error_code error;
  std::filesystem::create_directories(folder / "frames", error);
  if (error) throw write_error(folder / "frames", error.message());
  const auto remove_old = [&](const std::filesystem::path &path) {
    std::filesystem::remove(path, error);
    if (error) throw write_error(path, error.message());
  };
  const auto old_frames = listed_frames(series);
  remove_old(pvd_path(series));
  for (const auto &frame : old_frames) remove_old(folder / frame);
  return series;
}

/// The text of a series' .pvd. Its time steps are in microseconds.
inline std::string pvd_text(const VtkSeries &series) {
  std::string text = "<?xml version=\"1.0\"?>\n<!-- timestep: time in microseconds; positions in mm -->\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const auto &entry : series.entries) {
    text += "    <DataSet timestep=\"" + with_digits(1e6 * entry.time, 9) + "\" part=\"" + std::to_string(entry.part) +
            "\" name=\"" + entry.part_name + "\" file=\"" + entry.file + "\"/>\n";
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

///@{
/// Whether a part has nothing to show: no particle or no hex.
inline bool is_empty(const PointCloud &cloud) { return cloud.positions.empty(); }
inline bool is_empty(const HexGrid &grid) { return grid.hexes.empty(); }
///@}

/// Writes the parts of a frame and lists them in the series' .pvd, which at any moment names whole files only. A part
/// that is empty, such as particles that hexes have yet to turn into, is left out: not every reader takes a file
/// without cells. Throws SetupError for a part name that is used twice or is not made of letters, digits, '-', '_' and
/// '.', and WriteError if a file cannot be written; the frames before are not changed then.
inline void add_frame(VtkSeries &series, const Frame &frame) {
  char number[16];
  std::snprintf(number, sizeof number, "%04d", series.frames);
  VtkSeries next = series;
  std::set<std::string> names;
  const auto add = [&](const auto &part) {
    require(plain_file_name(part.name) && names.insert(part.name).second, "name of a part of " + series.name, part.name,
            "must be used once and be made of letters, digits, '-', '_' and '.'");
    if (is_empty(part)) return;
    const std::string file = "frames/" + series.name + "_" + part.name + "_" + number + ".vtu";
    const auto grid = to_vtk(part);
    add_symmetry(grid, frame.symmetry);
    write_vtu(series.folder / file, grid);
    next.entries.push_back({frame.time, part.part, part.name, file});
  };
  for (const auto &cloud : frame.clouds) add(cloud);
  for (const auto &grid : frame.grids) add(grid);
  ++next.frames;
  write_atomically(pvd_path(next), pvd_text(next));
  series = std::move(next);
}

/// Entry of the .pvd for a file, without its end "/>".
inline std::string pvd_element(const VtkSeriesEntry &entry) {
  const std::string text = pvd_text({{}, {}, 0, {entry}});
  const auto begin = text.find("<DataSet");
  return text.substr(begin, text.find("/>", begin) - begin);
}

/// Resumes the series of a run that was stopped after `frames` frames, made of the files `entries`. Later frames
/// are dropped; so are files that have gone or are another run's. Throws SetupError for a name that is not made of
/// letters, digits, '-', '_' and '.', WriteError if the .pvd cannot be written or old files cannot be removed.
inline VtkSeries resume_series(const std::filesystem::path &folder, const std::string &name, int frames,
                               const std::vector<VtkSeriesEntry> &entries) {
  require(plain_file_name(name), "name of a VTK series", name, "must be made of letters, digits, '-', '_' and '.'");
  require(frames >= 0, "frames of " + name, frames, "must not be negative");
  VtkSeries series{folder, name, frames};
  std::error_code error;
  std::filesystem::create_directories(folder / "frames", error);
  if (error) throw write_error(folder / "frames", error.message());
  std::ifstream file(pvd_path(series), std::ios::binary);
  const std::string listed{std::istreambuf_iterator<char>(file), {}};
  const std::string own = "frames/" + name + "_";
  for (const VtkSeriesEntry &entry : entries) {
    const bool is_plain = entry.file.starts_with(own) && plain_file_name(entry.file.substr(7));
    require(is_plain && plain_file_name(entry.part_name), "file of the series " + name, entry.file,
            "must be one of its frames");
    if (listed.find(pvd_element(entry)) != std::string::npos && std::filesystem::exists(folder / entry.file, error))
      series.entries.push_back(entry);
  }
  const auto old_frames = listed_frames(series);
  // The list first: at any moment it names whole files only.
  write_atomically(pvd_path(series), pvd_text(series));
  for (const std::string &frame : old_frames) {
    const bool kept = std::any_of(series.entries.begin(), series.entries.end(),
                                  [&](const VtkSeriesEntry &entry) { return entry.file == frame; });
    if (kept) continue;
    std::filesystem::remove(folder / frame, error);
    if (error) throw write_error(folder / frame, error.message());
  }
  return series;
}

} // namespace ogive
