// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/vtk.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace ogive {

/// How the .pvd lists a file.
inline std::string pvd_element(const VtkSeriesEntry &entry) {
  const std::string text = pvd_text({{}, {}, 0, {entry}});
  const auto begin = text.find("<DataSet");
  return text.substr(begin, text.find("/>", begin) - begin);
}

/// Goes on with the series of a run that was stopped after `frames` frames, made of the files `entries`. Later frames
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
