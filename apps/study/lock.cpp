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

namespace fs = std::filesystem;

/// Opens a file to be locked.
int opened(const fs::path &file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw ogive::write_error(file, std::generic_category().message(errno));
  return descriptor;
}

/// Whether another process has the file. File systems without locks leave it to the user that no shard is run twice.
bool is_taken(int descriptor, int kind) {
  int result = 0;
  do result = ::flock(descriptor, kind | LOCK_NB);
  while (result != 0 && errno == EINTR);
  return result != 0 && errno == EWOULDBLOCK;
}

[[noreturn]] void refuse_study(const Study &study, const std::string &part) {
  options::refuse("--out", study.out.string(),
                  "another process works on this study" + part + "; wait for its end, or give another folder");
}

} // namespace

StudyLock::StudyLock(const Study &study) {
  const bool is_part = study.shards > 1;
  const std::string all = ".lock", parts = ".lock_of_", count = std::to_string(study.shards);
  const auto lock = [&](const std::string &name, int kind, const char *part) {
    descriptors.push_back(opened(study.out / name));
    if (is_taken(descriptors.back(), kind)) refuse_study(study, part);
  };
  try {
    lock(all, is_part ? LOCK_SH : LOCK_EX, is_part ? ", without --shard" : "");
    if (!is_part) return;
    // Shards of another number overlap with this one.
    lock(parts + count, LOCK_SH, ", in another number of shards");
    for (const auto &entry : fs::directory_iterator(study.out)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with(parts) || name == parts + count || name.find("_shard_") != std::string::npos) continue;
      const int other = opened(entry.path());
      const bool taken = is_taken(other, LOCK_EX);
      ::close(other);
      if (taken) refuse_study(study, ", in another number of shards");
    }
    lock(parts + count + "_shard_" + std::to_string(study.shard), LOCK_EX, ", on the same shard");
  } catch (...) {
    release();
    throw;
  }
}

void StudyLock::release() {
  for (const int descriptor : descriptors) ::close(descriptor);
  descriptors.clear();
}

StudyLock::~StudyLock() { release(); }

} // namespace study
