// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/target.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

/// Tries every file of the folders that are given, and the beginnings of each. Exit status 1 if a reader throws what it
/// must not, or if there is no file.
int main(int argc, char **argv) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i)
    for (const auto &entry : std::filesystem::directory_iterator(argv[i])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto &file : files) {
    const std::string bytes = read_text(file);
    try {
      for (std::size_t size = bytes.size(), cut = 0; cut < 20; ++cut, size -= size / 8 + (size > 0 ? 1 : 0))
        fuzz::try_input(std::string_view(bytes).substr(0, size));
    } catch (const std::exception &error) {
      std::printf("%s: %s\n", file.c_str(), error.what());
      return 1;
    }
  }
  std::printf("%zu files\n", files.size());
  return files.empty() ? 1 : 0;
}
