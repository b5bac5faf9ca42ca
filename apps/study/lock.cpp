// SPDX-License-Identifier: BSD-3-Clause
#include "lock.hpp"

#include "ogive/io/write_error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace study {

namespace {

/// Opens a file and locks it; refuses where another process has it. File systems without locks leave it to the user
/// that shards are not run twice.
int locked(const std::filesystem::path &file, int kind, const Study &study) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
  while (::flock(descriptor, kind | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) break;
    ::close(descriptor);
    options::refuse("--out", study.out.string(),
                    "another process works on this study" +
                        std::string(study.shards > 1 ? ", on the same shard or on all of it" : "") +
                        "; wait for its end, or give another folder");
  }
  return descriptor;
}

} // namespace

StudyLock::StudyLock(const Study &study) {
  const auto base = (study.out / ".lock").string();
  descriptors.push_back(locked(base, study.shards > 1 ? LOCK_SH : LOCK_EX, study));
  if (study.shards == 1) return;
  try {
    descriptors.push_back(
        locked(base + "." + std::to_string(study.shard) + "-of-" + std::to_string(study.shards), LOCK_EX, study));
  } catch (...) {
    ::close(descriptors.front());
    throw;
  }
}

StudyLock::~StudyLock() {
  for (const int descriptor : descriptors) ::close(descriptor);
}

} // namespace study
