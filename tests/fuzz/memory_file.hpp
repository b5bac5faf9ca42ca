// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace fuzz {

/// A file without a disk, for readers that want a name.
struct MemoryFile {
  int descriptor = ::memfd_create("input", 0);
  std::filesystem::path path = "/proc/self/fd/" + std::to_string(descriptor);

  MemoryFile() = default;
  ~MemoryFile() { ::close(descriptor); }
  MemoryFile(const MemoryFile &) = delete;
  MemoryFile &operator=(const MemoryFile &) = delete;

  /// Makes these bytes all that it holds.
  void write(std::string_view bytes) {
    if (::ftruncate(descriptor, 0) != 0 ||
        ::pwrite(descriptor, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
      std::abort();
  }
};

} // namespace fuzz
