// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace figures {

/// A lock that other processes see, until it is destroyed. It goes with the process, however that ends, and children do
/// not have it. Throws WriteError if there can be no such file.
class ShotLock {
public:
  explicit ShotLock(const std::filesystem::path &file)
      : descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EINTR) continue;
      refusal = errno;
      break;
    }
  }
  ShotLock(ShotLock &&other) noexcept : descriptor(std::exchange(other.descriptor, -1)), refusal(other.refusal) {}
  ShotLock &operator=(ShotLock &&) = delete;
  ~ShotLock() {
    if (descriptor >= 0) ::close(descriptor);
  }

  /// Another process has it.
  bool is_elsewhere() const { return refusal == EWOULDBLOCK; }

  /// Why the file system has no locks (errno), 0 where it has: only shards keep processes apart then.
  int missing() const { return is_elsewhere() ? 0 : refusal; }

private:
  int descriptor;
  int refusal = 0;
};

} // namespace figures
