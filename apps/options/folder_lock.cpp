// SPDX-License-Identifier: BSD-3-Clause
#include "folder_lock.hpp"

#include "given.hpp"

#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace options {

namespace {

/// True unless the file of a descriptor has been renamed or removed, with its folder perhaps.
bool is_there(int descriptor, const std::filesystem::path &file) {
  struct stat mine = {}, named = {};
  return ::fstat(descriptor, &mine) != 0 ||
         (::stat(file.c_str(), &named) == 0 && mine.st_dev == named.st_dev && mine.st_ino == named.st_ino);
}

} // namespace

FolderLock::FolderLock(const std::filesystem::path &file, Kind kind, const std::string &busy)
    : descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
  while (::flock(descriptor, (kind == exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) break;
    ::close(descriptor);
    refuse("--out", file.parent_path().string(), busy);
  }
  // Another process that had the lock has put the folder aside.
  if (is_there(descriptor, file)) return;
  ::close(descriptor);
  refuse("--out", file.parent_path().string(), busy);
}

FolderLock::~FolderLock() { ::close(descriptor); }

} // namespace options
