// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace ogive {

/// The name under which a file is written before it takes its place: in the same folder, so that a rename suffices.
inline std::filesystem::path temporary_name(const std::filesystem::path &path) {
  std::filesystem::path temporary = path;
  temporary += "." + std::to_string(::getpid()) + ".part";
  return temporary;
}

/// Throws WriteError if `path` exists but is no regular file: a rename would replace a folder or a device.
inline void require_replaceable(const std::filesystem::path &path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw write_error(path, "exists and is not a regular file");
}

/// Writes the pieces, one after another, to a new file and has the disk confirm it. Returns 0 or the errno of what
/// failed.
inline int write_and_sync(const std::filesystem::path &path, std::span<const std::string_view> pieces) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int error = 0;
  for (std::string_view bytes : pieces)
    while (!bytes.empty() && error == 0) {
      const ssize_t written = ::write(file, bytes.data(), bytes.size());
      if (written >= 0)
        bytes.remove_prefix(static_cast<std::size_t>(written));
      else if (errno != EINTR)
        error = errno;
    }
  if (error == 0 && ::fsync(file) != 0) error = errno;
  // Network file systems report a full disk only here.
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

/// Replaces the file at `path` by the pieces, one after another, or leaves it as it was: a reader never sees half a
/// file, and a run that is killed leaves the old or the new one. Throws WriteError with the operating system's reason.
inline void write_atomically(const std::filesystem::path &path, std::span<const std::string_view> pieces) {
  require_replaceable(path);
  const auto temporary = temporary_name(path);
  int error = write_and_sync(temporary, pieces);
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw write_error(path, std::generic_category().message(error));
}

/// Writes bytes in one piece, see write_and_sync() for several.
inline int write_and_sync(const std::filesystem::path &path, std::string_view bytes) {
  return write_and_sync(path, std::span<const std::string_view>(&bytes, 1));
}
/// Writes bytes that are in memory already. Throws WriteError.
inline void write_atomically(const std::filesystem::path &path, std::string_view bytes) {
  write_atomically(path, std::span<const std::string_view>(&bytes, 1));
}

} // namespace ogive
