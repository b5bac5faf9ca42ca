// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/targets.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <vector>

namespace {

const std::map<std::string_view, fuzz::TryInput *> targets{
    {"curve_table", fuzz::try_curve_table},
    {"mesh_inp", fuzz::try_mesh_inp},
    {"mesh_k", fuzz::try_mesh_k},
    {"profile", fuzz::try_profile},
#ifdef OGIVE_FUZZ_PROGRAMS
    {"card", fuzz::try_card},
    {"case_file", fuzz::try_case_file},
    {"checkpoint_file", fuzz::try_checkpoint_file},
    {"checkpoint_notes", fuzz::try_checkpoint_notes},
    {"checkpoint_state", fuzz::try_checkpoint_state},
    {"material_file", fuzz::try_material_file},
    {"prediction", fuzz::try_prediction},
#endif
};

} // namespace

/// replay TARGET FOLDER...: tries every file of the folders, and the beginnings of each. Exit status 1 if a reader
/// throws what it must not, or if there is no such target or no file.
int main(int argc, char **argv) {
  const auto target = targets.find(argc > 1 ? argv[1] : "");
  if (target == targets.end()) {
    std::printf("no such target\n");
    return 1;
  }
  std::vector<std::filesystem::path> files;
  for (int i = 2; i < argc; ++i)
    for (const auto &entry : std::filesystem::directory_iterator(argv[i])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto &file : files) {
    const std::string bytes = read_text(file);
    try {
      for (std::size_t size = bytes.size(), cut = 0; cut < 20; ++cut, size -= size / 8 + (size > 0 ? 1 : 0))
        target->second(std::string_view(bytes).substr(0, size));
    } catch (const std::exception &error) {
      std::printf("%s: %s\n", file.c_str(), error.what());
      return 1;
    }
  }
  std::printf("%zu files\n", files.size());
  return files.empty() ? 1 : 0;
}
