// SPDX-License-Identifier: BSD-3-Clause
#include "data_folder.hpp"

namespace options {

std::filesystem::path data_folder() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto installed = program.parent_path().parent_path() / "share/ogive/data";
  return std::filesystem::exists(installed / "experiment_shots.csv", none) ? installed : OGIVE_DATA_FOLDER;
}

} // namespace options
