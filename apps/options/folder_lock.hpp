// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace options {

/// A lock that other processes see, until it is destroyed or the process ends, however that happens.
class FolderLock {
public:
  enum Kind { exclusive, shared };

  /// Locks `file`, which stays. Throws SetupError "--out = <folder of the file>: <busy>" if another process has it,
  /// WriteError if there can be no such file. On a file system without locks it locks nothing.
  FolderLock(const std::filesystem::path &file, Kind kind, const std::string &busy);
  ~FolderLock();
  FolderLock(const FolderLock &) = delete;
  FolderLock &operator=(const FolderLock &) = delete;

private:
  int descriptor;
};

} // namespace options
