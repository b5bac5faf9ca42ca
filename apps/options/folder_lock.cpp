// SPDX-License-Identifier: BSD-3-Clause
#include "folder_lock.hpp"

#include "given.hpp"

#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace options {

FolderLock::FolderLock(const std::filesystem::path &file, Kind kind, const std::string &busy)
    : descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
  while (::flock(descriptor, (kind == exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) break;
    ::close(descriptor);
    refuse("--out", file.parent_path().string(), busy);
  }
}

FolderLock::~FolderLock() { ::close(descriptor); }

} // namespace options
